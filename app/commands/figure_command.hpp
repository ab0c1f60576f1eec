#pragma once

#include "app/commands/hidden_commands.hpp"
#include "app/process/exit_code.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

/// Of `ffstudy figure`.
struct FigureCommand {
    std::filesystem::path results;     ///< folder or store
    std::string picture;               ///< its name or how that begins; empty: all are listed
    std::vector<std::string> methods;  ///< empty: all
    std::string pairs;                 ///< class of pairs; empty: any
    std::string width = "120mm";
    std::string height;  ///< empty: as the kind of picture has it
    double font_size = 8;
    std::string font;
    std::filesystem::path out;        ///< .svg, .pdf, .png or .pgf; empty: the picture's name, .pdf
    std::filesystem::path templates;  ///< folder of own templates; empty: none
};

/// Draws one picture of a study in a size for a paper, or lists those that there are.
ExitCode figure(const FigureCommand& command);

void add_figure(CLI::App& app, FigureCommand& command, Action& action);

}  // namespace ff::app
