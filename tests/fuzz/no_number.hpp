#pragma once

#include <cctype>
#include <string_view>

/// Whether a CSV or JSON text has a word that C++ prints for NaN or infinity.
inline bool has_no_number(std::string_view text) {
    for (const char* word : {",nan", ",-nan", ",inf", ",-inf", ": nan", ": inf", ": -inf", ": NaN", ": Infinity"}) {
        const std::string_view sought = word;
        for (auto at = text.find(sought); at != std::string_view::npos; at = text.find(sought, at + 1)) {
            // "tail index 0.67: infinite variance" is a sentence.
            const auto end = at + sought.size();
            if (end == text.size() || std::isalpha(static_cast<unsigned char>(text[end])) == 0) return true;
        }
    }
    return false;
}
