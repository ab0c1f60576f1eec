#include "reports/latex_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

struct Sign {
    std::string_view text;
    std::string_view latex;
};

/// In braces where a command would swallow what follows, or where [ and * are arguments of the row before.
constexpr std::array ascii{
    Sign{"\\", "\\textbackslash{}"},
    Sign{"{", "\\{"},
    Sign{"}", "\\}"},
    Sign{"$", "\\$"},
    Sign{"&", "\\&"},
    Sign{"#", "\\#"},
    Sign{"%", "\\%"},
    Sign{"_", "\\_"},
    Sign{"^", "\\^{}"},
    Sign{"~", "\\~{}"},
    Sign{"<", "\\textless{}"},
    Sign{">", "\\textgreater{}"},
    Sign{"|", "\\textbar{}"},
    Sign{"\"", "\\char34{}"},
    Sign{"[", "{[}"},
    Sign{"*", "{*}"},
};

/// What reports themselves write beyond ASCII.
constexpr std::array signs{
    Sign{"−", "\\ensuremath{-}"},
    Sign{"×", "\\ensuremath{\\times}"},
    Sign{"±", "\\ensuremath{\\pm}"},
    Sign{"·", "\\ensuremath{\\cdot}"},
    Sign{"≤", "\\ensuremath{\\leq}"},
    Sign{"≥", "\\ensuremath{\\geq}"},
    Sign{"Δ", "\\ensuremath{\\Delta}"},
    Sign{"Σ", "\\ensuremath{\\Sigma}"},
    Sign{"σ", "\\ensuremath{\\sigma}"},
    Sign{"χ", "\\ensuremath{\\chi}"},
    Sign{"ψ", "\\ensuremath{\\psi}"},
    Sign{"₁", "\\textsubscript{1}"},
    Sign{"²", "\\textsuperscript{2}"},
    Sign{"³", "\\textsuperscript{3}"},
    Sign{"√", "\\ensuremath{\\surd}"},
    Sign{"∞", "\\ensuremath{\\infty}"},
    Sign{"…", "\\dots{}"},
    Sign{"–", "--"},
    Sign{"→", "\\ensuremath{\\to}"},
    Sign{"″", "\\ensuremath{''}"},
};

/// Characters of which two in a row may become one.
constexpr std::string_view ligatures = "-'`,!?";

template <std::size_t N>
const Sign* find_at(const std::array<Sign, N>& table, std::string_view rest) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const Sign& sign) { return rest.starts_with(sign.text); });
    return found == table.end() ? nullptr : &*found;
}

bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

std::string escape_latex(const std::string& text) {
    std::string out;
    const std::string_view all = text;
    for (std::size_t i = 0; i < all.size();) {
        const std::string_view rest = all.substr(i);
        const Sign* sign = find_at(ascii, rest);
        if (sign == nullptr) sign = find_at(signs, rest);
        if (sign != nullptr) {
            out += sign->latex;
            i += sign->text.size();
            continue;
        }
        out += is_control(rest.front()) ? ' ' : rest.front();
        const bool joins = rest.size() > 1 && ligatures.find(rest[0]) != std::string_view::npos &&
                           ligatures.find(rest[1]) != std::string_view::npos;
        if (joins) out += "{}";
        ++i;
    }
    return out;
}

std::string latex_with_numbers(const std::string& text) {
    // A sign belongs to a number unless something stands before it, as in "F 1-6"; an exponent ends it.
    static const std::regex number(R"(([-+]?)([0-9]+(?:\.[0-9]+)?)(?:e([-+]?)0*([0-9]+))?)");
    std::string out;
    auto after = text.cbegin();
    for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it) {
        const std::smatch& found = *it;
        const auto start = found[0].first;
        const bool inside = start != text.cbegin() &&
                            (std::isalnum(static_cast<unsigned char>(*(start - 1))) != 0 || *(start - 1) == '.');
        if (inside || (found[1].length() == 0 && !found[4].matched)) continue;
        out += escape_latex(std::string(after, start));
        out += fmt::format("${}{}", found[1].str(), found[2].str());
        if (found[4].matched)
            out += fmt::format("\\times10^{{{}{}}}", found[3].str() == "-" ? "-" : "", found[4].str());
        out += '$';
        after = found[0].second;
    }
    return out + escape_latex(std::string(after, text.cend()));
}

}  // namespace ff::reports
