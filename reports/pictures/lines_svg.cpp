#include "reports/pictures/answer_svg.hpp"
#include "reports/pictures/svg_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

/// A kind of picture with a line for each method: the error, on a logarithmic axis, against something.
struct LineChart {
    std::string_view kind;
    const char* x;
    bool log;  ///< the x axis
    std::string_view x_title;
};
constexpr std::array line_charts{LineChart{"convergence", "evaluations", true, "evaluations per face"},
                                 LineChart{"occlusion", "hidden", false, "occluded fraction"}};

constexpr double width = 640;
constexpr double left = 60;
constexpr double right = width - 130;  // labels stand beyond it
constexpr double top = 10;
constexpr double bottom = 270;
constexpr double height = bottom + 40;  // with the title of the axis

const LineChart* chart_of(const Picture& picture) {
    const auto chart = std::ranges::find(line_charts, picture.kind, &LineChart::kind);
    return chart == line_charts.end() ? nullptr : &*chart;
}

/// "0.02", "5e-4", "1e6"
std::string tick_text(double tick) {
    if (tick == 0 || (std::abs(tick) >= 1e-2 && std::abs(tick) < 1e5)) return fmt::format("{:.6g}", tick);
    const auto power = static_cast<int>(std::floor(std::log10(std::abs(tick)) + 1e-9));
    return fmt::format("{:.6g}e{}", tick / std::pow(10, power), power);
}

std::string grid(const LineChart& chart, const SvgAxis& x, const SvgAxis& y) {
    std::string out;
    for (const double tick : x.ticks()) {
        out += svg_line(x.at(tick), x.at(tick), top, bottom, "stroke=\"#d0d0d0\"");
        out += svg_text(x.at(tick), bottom + 16, " text-anchor=\"middle\"", tick_text(tick));
    }
    for (const double tick : y.ticks()) {
        out += svg_line(left, right, y.at(tick), y.at(tick), "stroke=\"#d0d0d0\"");
        out += svg_text(left - 6, y.at(tick) + 4, " text-anchor=\"end\"", tick_text(tick));
    }
    out += svg_text((left + right) / 2, bottom + 33, " text-anchor=\"middle\"", chart.x_title);
    return out +
           svg_text(14, (top + bottom) / 2,
                    fmt::format(" text-anchor=\"middle\" transform=\"rotate(-90 14 {:.1f})\"", (top + bottom) / 2),
                    "RMSE of a run");
}

/// Whether a logarithmic axis has a place for the row's error: it may be zero, or infinite, which is null.
bool has_place(const PictureRow& row) {
    return row.has("error") && row.number("error") > 0;
}

/// The mark of a point with its interval: hollow where it is printed.
std::string mark_svg(const PictureRow& row, double x, const SvgAxis& y, const std::string& colour, bool printed) {
    std::string out;
    if (row.has("low") && row.has("high") && row.number("low") > 0)
        out += svg_line(x, x, y.at(row.number("low")), y.at(row.number("high")),
                        fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour));
    return out + fmt::format(
                     "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" stroke=\"{}\" stroke-width=\"1.5\" "
                     "fill=\"{}\"/>\n",
                     x, y.at(row.number("error")), printed ? 5 : 3.5, colour, printed ? "none" : colour);
}

}  // namespace

bool has_lines_svg(const Picture& picture) {
    return chart_of(picture) != nullptr;
}

std::string lines_svg(const Picture& picture) {
    const LineChart& chart = *chart_of(picture);
    const Json values = Json::parse(picture.values);
    const auto columns = picture_columns(values);
    auto colours = picture_colours(values);
    std::vector<PictureRow> rows;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Json& each : values["rows"]) {
        const PictureRow row(columns, each);
        if (!has_place(row)) continue;
        rows.push_back(row);
        low = std::min(low, row.number(chart.x));
        high = std::max(high, row.number(chart.x));
    }
    if (rows.empty())
        return svg_drawing(width, height, picture.description, svg_text(left, bottom / 2, "", "no error is finite"));
    const SvgAxis x(chart.log, low, high, left, right);
    const Json& range = values["scales"]["y"]["domain"];
    const SvgAxis y(true, range[0].get<double>(), range[1].get<double>(), bottom, top);
    std::string content = grid(chart, x, y);
    std::string marks;
    // Points of a method follow each other, by ascending size; what theory expects is a line of its own.
    std::map<std::pair<std::string, std::string>, std::string> paths;
    for (const PictureRow& row : rows) {
        const std::string method = row.words("method");
        const std::string role = columns.contains("role") ? row.words("role") : std::string();
        const double at = x.at(row.number(chart.x));
        const bool is_expected = role == "expected";
        const bool is_printed = role == "printed";
        if (!is_expected) marks += mark_svg(row, at, y, colours[method], is_printed);
        if (!is_printed)
            paths[{method, is_expected ? role : std::string()}] +=
                fmt::format("{:.1f},{:.1f} ", at, y.at(row.number("error")));
    }
    for (const auto& [line, points] : paths)
        content += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"{}/>\n", points,
                               colours[line.first], line.second.empty() ? "" : " stroke-dasharray=\"4 3\"");
    content += marks;
    for (const Json& label : values["labels"])
        content += svg_text(right + 8, y.at(label["height"].get<double>()) + 4,
                            fmt::format(" fill=\"{}\"", colours[label["method"].get<std::string>()]),
                            label["text"].get<std::string>());
    return svg_drawing(width, height, picture.description, content);
}

}  // namespace ff::reports
