#pragma once

#include <string>

namespace ff::reports {

/// Text escaped for LaTeX, in any font encoding: special characters, ASCII ligatures and the signs that reports use are
/// written out, control characters become spaces. Letters of other scripts stay UTF-8.
std::string escape_latex(const std::string& text);

/// The same, with numbers set as mathematics: "-7.2e-05" becomes $-7.2\times10^{-5}$.
std::string latex_with_numbers(const std::string& text);

}  // namespace ff::reports
