#pragma once

#include "app/process/exit_code.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

/// Options of `ffstudy figure`.
struct FigureCommand {
    std::filesystem::path results;     ///< folder or store
    std::string picture;               ///< its name or the beginning of it; empty: list all
    std::vector<std::string> methods;  ///< empty: all
    std::string pairs;                 ///< class of pairs; empty: any
    std::string width = "120mm";
    std::string height;  ///< empty: the default of the kind of picture
    double font_size = 8;
    std::string font;
    std::filesystem::path out;        ///< .svg, .pdf or .png; empty: the picture's name, .pdf
    std::filesystem::path templates;  ///< folder of custom templates; empty: none
};

/// Draws one picture of a study in a size for a paper, or lists the available ones.
ExitCode figure(const FigureCommand& command);

}  // namespace ff::app
