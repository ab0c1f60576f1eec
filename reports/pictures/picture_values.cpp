#include "reports/pictures/picture_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace ff::reports {

PictureValues::PictureValues(const std::vector<std::string>& columns) {
    json_["columns"] = columns;
    json_["rows"] = nlohmann::ordered_json::array();
}

std::string json_in_html(const nlohmann::ordered_json& json) {
    std::string out;
    for (const char c : json.dump()) out += c == '<' ? "\\u003c" : std::string(1, c);
    return out;
}

nlohmann::ordered_json drawn(std::optional<double> value, int digits) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return std::strtod(fmt::format("{:.{}g}", *value, digits).c_str(), nullptr);
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
