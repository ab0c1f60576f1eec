#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// What may stand in place of the last word of a command line.
struct Completions {
    struct Word {
        std::string text;
        std::string summary;
    };
    std::vector<Word> words;  ///< those that begin with what is there
    enum class Paths { none, folders, files } paths = Paths::none;
};

/// Names that may stand where something of this type ("SAMPLER") is taken.
using NamesOfType = std::function<std::vector<Completions::Word>(std::string_view type)>;

/// Commands, options and values, from the definitions that --help shows: an option's type, or an argument's name, says
/// what is taken. @param words from the program's name on; the last one, which may be empty, is completed
Completions complete(const CLI::App& app, std::span<const std::string> words, const NamesOfType& names);

/// For the scripts in app/completion/: a line for each word, "text<tab>summary", then ":files" or ":folders".
std::string in_lines(const Completions& completions);

}  // namespace ff::app
