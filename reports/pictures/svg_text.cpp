#include "reports/pictures/svg_text.hpp"

#include "reports/templates/mustache.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff::reports {

SvgAxis::SvgAxis(bool log, double low, double high, double from, double to)
    : log_(log), low_(scaled(low)), high_(scaled(high)), from_(from), to_(to) {
    const double room = 0.04 * (high_ - low_ > 0 ? high_ - low_ : 1);
    low_ -= room;
    high_ += room;
}

double SvgAxis::at(double value) const {
    return from_ + (to_ - from_) * (scaled(value) - low_) / (high_ - low_);
}

std::vector<double> SvgAxis::ticks() const {
    std::vector<double> ticks;
    if (log_) {
        const bool wide = high_ - low_ > 3;
        for (int power = static_cast<int>(std::floor(low_)); power <= high_; ++power) {
            for (const double digit : {1.0, 2.0, 5.0}) {
                if (digit == 1 || !wide) ticks.push_back(digit * std::pow(10, power));
            }
        }
    } else {
        const double rough = (high_ - low_) / 5;
        const double power = std::pow(10, std::floor(std::log10(rough)));
        const double between = power * (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : 5);
        const double first = std::ceil(low_ / between);
        const double last = std::floor(high_ / between);
        for (int i = 0; i <= last - first; ++i) ticks.push_back((first + i) * between);
    }
    std::erase_if(ticks, [&](double tick) { return scaled(tick) < low_ || scaled(tick) > high_; });
    return ticks;
}

double SvgAxis::scaled(double value) const {
    return log_ ? std::log10(value) : value;
}

std::string svg_drawing(double width, double height, std::string_view description, std::string_view content) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
        "font-family=\"system-ui, 'Liberation Sans', Arial, sans-serif\" font-size=\"12\" fill=\"#1b1b1b\">\n"
        "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{3}</svg>\n",
        width, height, escape_html(std::string(description)), content);
}

std::string svg_text(double x, double y, std::string_view attributes, std::string_view words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", x, y, attributes,
                       escape_html(std::string(words)));
}

std::string svg_line(double x1, double x2, double y1, double y2, std::string_view attributes) {
    return fmt::format("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, x2, y1, y2,
                       attributes);
}

std::map<std::string, std::size_t> picture_columns(const Json& values) {
    std::map<std::string, std::size_t> columns;
    for (const Json& column : values["columns"]) columns.emplace(column, columns.size());
    return columns;
}

std::map<std::string, std::string> picture_colours(const Json& values) {
    std::map<std::string, std::string> colours;
    const Json& scale = values["scales"]["color"];
    for (std::size_t i = 0; i < scale["domain"].size(); ++i) colours[scale["domain"][i]] = scale["range"][i];
    return colours;
}

}  // namespace ff::reports
