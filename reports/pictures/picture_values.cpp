#include "reports/pictures/picture_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace ff::reports {

PictureValues::PictureValues(const std::vector<std::string>& columns) {
    json_["columns"] = columns;
    json_["rows"] = Json::array();
}

std::string json_in_html(const Json& json) {
    std::string out;
    for (const char c : json.dump()) out += c == '<' ? "\\u003c" : std::string(1, c);
    return out;
}

Json drawn(std::optional<double> value, int digits) {
    if (!value || !std::isfinite(*value)) return nullptr;
    // Not std::stod: it throws where a number is smaller than doubles of full precision are.
    return std::strtod(fmt::format("{:.{}g}", *value, digits).c_str(), nullptr);
}

Json drawn_low(const std::optional<stats::Interval>& interval) {
    return interval ? drawn(interval->low) : Json();
}

Json drawn_high(const std::optional<stats::Interval>& interval) {
    return interval ? drawn(interval->high) : Json();
}

Picture picture_of(const PictureValues& values, std::string_view kind, const std::string& id, std::string title,
                   std::string finding, std::string_view shown) {
    Picture picture{slug(id), std::string(kind), std::move(title), std::move(finding), {}, values.text()};
    picture.description = fmt::format("{} {}", shown, picture.finding);
    return picture;
}

Picture picture_of_cell(const PictureValues& values, std::string_view kind, std::size_t cell, const std::string& label,
                        std::string_view title, std::string finding, std::string_view shown) {
    return picture_of(values, kind, fmt::format("{}-{}-{}", kind, cell, label), fmt::format("{}, {}.", title, label),
                      std::move(finding), shown);
}

std::string slug(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (plain) {
            out += c;
        } else if (!out.empty() && out.back() != '-') {
            out += '-';
        }
    }
    while (!out.empty() && out.back() == '-') out.pop_back();
    return out;
}

}  // namespace ff::reports
