#pragma once

#include <string_view>

/// Whether a CSV or JSON text has a word that C++ prints for what is no number.
inline bool has_no_number(std::string_view text) {
    for (const char* word : {",nan", ",-nan", ",inf", ",-inf", ": nan", ": inf", ": -inf", ": NaN", ": Infinity"}) {
        if (text.find(word) != std::string_view::npos) return true;
    }
    return false;
}
