#include "reports/pictures/ranking_svg.hpp"

#include "core/support/contract.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/json_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

constexpr double ranking_width = 640;
constexpr double axis_left = 200;  // labels stand before it
constexpr double axis_right = ranking_width - 30;
constexpr double row_height = 19;
constexpr double rows_top = 10;
constexpr double axis_height = 40;  // height with its title

/// A value's place from left to right.
class Axis {
  public:
    Axis(bool log, double low, double high) : log_(log), low_(scaled(low)), high_(scaled(high)) {
        const double room = 0.04 * (high_ - low_ > 0 ? high_ - low_ : 1);
        low_ -= room;
        high_ += room;
    }
    [[nodiscard]] double at(double value) const {
        return axis_left + (axis_right - axis_left) * (scaled(value) - low_) / (high_ - low_);
    }
    /// Four to about ten round numbers.
    [[nodiscard]] std::vector<double> ticks() const {
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

  private:
    [[nodiscard]] double scaled(double value) const { return log_ ? std::log10(value) : value; }
    bool log_;
    double low_;
    double high_;
};

std::string text(double x, double y, std::string_view attributes, std::string_view words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", x, y, attributes,
                       escape_html(std::string(words)));
}

std::string line(double x1, double x2, double y1, double y2, std::string_view attributes) {
    return fmt::format("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, x2, y1, y2,
                       attributes);
}

/// One row of the values, column by name.
class Row {
  public:
    Row(const std::map<std::string, std::size_t>& columns, const Json& values) : columns_(columns), values_(values) {}
    [[nodiscard]] const Json& operator[](const std::string& column) const { return values_.at(columns_.at(column)); }
    [[nodiscard]] bool has(const std::string& column) const { return (*this)[column].is_number(); }
    [[nodiscard]] double number(const std::string& column) const { return (*this)[column].get<double>(); }

  private:
    const std::map<std::string, std::size_t>& columns_;
    const Json& values_;
};

std::string row_svg(const Row& row, const Axis& axis, double y, const std::string& colour) {
    std::string out;
    if (row.has("expected")) {
        const double x = axis.at(row.number("expected"));
        out += line(x, x, y - 7, y + 7, R"(stroke="#595959" stroke-width="1.5")");
    }
    if (!row.has("value")) return out + text(axis_left + 4, y + 4, R"( fill="#595959")", "exact to rounding");
    if (row.has("low")) {
        out += line(axis.at(row.number("low")), axis.at(row.number("high")), y, y,
                    fmt::format(R"(stroke="{}" stroke-width="2")", colour));
    }
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", axis.at(row.number("value")), y,
                       colour);
    return out + text(axis.at(row.number("end")) + 8, y + 4, "", row["group"].get<std::string>());
}

}  // namespace

std::string ranking_svg(const Picture& picture) {
    FF_EXPECT(picture.kind == "ranking");
    const Json values = Json::parse(picture.values);
    std::map<std::string, std::size_t> columns;
    for (const Json& column : values["columns"]) columns.emplace(column, columns.size());
    std::map<std::string, std::string> colours;
    const Json& scale = values["scales"]["color"];
    for (std::size_t i = 0; i < scale["domain"].size(); ++i) colours[scale["domain"][i]] = scale["range"][i];

    std::map<std::string, Row> rows;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Json& each : values["rows"]) {
        const Row row(columns, each);
        for (const char* column : {"value", "low", "high", "expected"}) {
            if (!row.has(column)) continue;
            low = std::min(low, row.number(column));
            high = std::max(high, row.number(column));
        }
        rows.emplace(row["row"].get<std::string>(), row);
    }
    if (!(low <= high)) low = high = 1;  // all are exact to rounding
    const Axis axis(values.value("log", false), low, high);

    const Json& order = values["scales"]["y"]["domain"];
    const double bottom = rows_top + row_height * static_cast<double>(order.size());
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
        "font-family=\"system-ui, 'Liberation Sans', Arial, sans-serif\" font-size=\"12\" fill=\"#1b1b1b\">\n"
        "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        ranking_width, bottom + axis_height, escape_html(picture.description));
    for (const double tick : axis.ticks()) {
        out += line(axis.at(tick), axis.at(tick), rows_top, bottom, "stroke=\"#d0d0d0\"");
        out += text(axis.at(tick), bottom + 16, " text-anchor=\"middle\"", fmt::format("{:.6g}", tick));
    }
    out += text((axis_left + axis_right) / 2, bottom + 33, " text-anchor=\"middle\"",
                values["titles"]["x"].get<std::string>());
    double y = rows_top + row_height / 2;
    for (const Json& each : order) {
        const auto name = each.get<std::string>();
        const auto divider = name.find('|');
        const bool heading = divider == std::string::npos;
        out += heading ? text(8, y + 4, " font-weight=\"bold\"", name)
                       : text(axis_left - 8, y + 4, " text-anchor=\"end\"", name.substr(divider + 1));
        if (const auto row = rows.find(name); row != rows.end())
            out += row_svg(row->second, axis, y, colours[row->second["method"].get<std::string>()]);
        y += row_height;
    }
    return out + "</svg>\n";
}

}  // namespace ff::reports
