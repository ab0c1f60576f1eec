#include "reports/latex/latex_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

struct Sign {
    std::string_view text;
    std::string_view latex;
};

/// A text in braces, where a command would swallow what follows, or where [ and * would be arguments of the row before.
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

/// Characters beyond ASCII that reports themselves write.
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

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_alphanumeric(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string_view digits_of(std::string_view text) {
    return text.substr(0,
                       static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin()));
}

/// A decimal number as it stands in a text.
struct Number {
    std::string_view sign;  ///< may be empty
    std::string_view digits;
    bool negative_exponent = false;
    std::string_view exponent;  ///< without leading zeros; empty where there is none
    std::size_t length = 0;
};

/// The number that the text starts with.
std::optional<Number> number_at(std::string_view text) {
    Number number;
    if (text.starts_with('-') || text.starts_with('+')) number.sign = text.substr(0, 1);
    std::string_view rest = text.substr(number.sign.size());
    std::size_t size = digits_of(rest).size();
    if (size == 0) return std::nullopt;
    if (rest.substr(size).starts_with('.')) {
        const std::size_t decimals = digits_of(rest.substr(size + 1)).size();
        if (decimals > 0) size += 1 + decimals;
    }
    number.digits = rest.substr(0, size);
    number.length = number.sign.size() + size;
    rest = rest.substr(size);
    if (!rest.starts_with('e')) return number;
    const bool is_signed = rest.substr(1).starts_with('-') || rest.substr(1).starts_with('+');
    const std::string_view exponent = digits_of(rest.substr(is_signed ? 2 : 1));
    if (exponent.empty()) return number;
    number.negative_exponent = rest[1] == '-';
    number.exponent = exponent.substr(std::min(exponent.find_first_not_of('0'), exponent.size() - 1));
    number.length += (is_signed ? 2 : 1) + exponent.size();
    return number;
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
    std::string out;
    const std::string_view all = text;
    std::size_t written = 0;
    for (std::size_t at = 0; at < all.size();) {
        const auto number = number_at(all.substr(at));
        if (!number) {
            ++at;
            continue;
        }
        // A sign belongs to a number unless something stands before it, as in "F 1-6"; an exponent ends it.
        const bool inside = at > 0 && (is_alphanumeric(all[at - 1]) || all[at - 1] == '.');
        if (!inside && (!number->sign.empty() || !number->exponent.empty())) {
            out += escape_latex(text.substr(written, at - written));
            out += fmt::format("${}{}", number->sign, number->digits);
            if (!number->exponent.empty())
                out += fmt::format("\\times10^{{{}{}}}", number->negative_exponent ? "-" : "", number->exponent);
            out += '$';
            written = at + number->length;
        }
        at += number->length;
    }
    return out + escape_latex(text.substr(written));
}

}  // namespace ff::reports
