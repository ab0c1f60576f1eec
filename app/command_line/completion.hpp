#pragma once

#include "app/command_line/command_model.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// Completions of the last word of a command line.
struct Completions {
    struct Word {
        std::string text;
        std::string summary;
    };
    std::vector<Word> words;  ///< words that begin with the given text
    enum class Paths { none, folders, files } paths = Paths::none;
};

/// Names for a value of this type ("SAMPLER").
using NamesOfType = std::function<std::vector<Completions::Word>(std::string_view type)>;

/// Commands, options and values, from the definitions that --help shows: an option's type, or an argument's name, tells
/// what it takes. @param words from the program's name on; the last one, possibly empty, is completed
Completions complete(const ProgramModel& program, std::span<const std::string> words, const NamesOfType& names);

/// For the scripts in app/completion/: a line for each word, "text<tab>summary", then ":files" or ":folders".
std::string in_lines(const Completions& completions);

}  // namespace ff::app
