#pragma once

#include <string>

namespace ff::reports {

/// Text as LaTeX shows it, in any font encoding: its special characters, ligatures of ASCII and the signs that reports
/// use are written out, control characters become spaces. Letters of other scripts stay as they are, in UTF-8.
std::string escape_latex(const std::string& text);

/// The same, with numbers as mathematics sets them: "-7.2e-05" becomes $-7.2\times10^{-5}$.
std::string latex_with_numbers(const std::string& text);

}  // namespace ff::reports
