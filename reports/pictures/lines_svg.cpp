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
    bool log;       ///< the x axis
    bool reversed;  ///< the x axis, on which 1 - value is written
    std::string_view x_title;
    const char* y;
    std::string_view y_title;
};
constexpr std::array line_charts{
    LineChart{"convergence", "evaluations", true, false, "evaluations per face", "error", "RMSE of a run"},
    LineChart{"occlusion", "occluded_fraction", false, false, "occluded fraction", "error", "RMSE of a run"},
    LineChart{"light_errors", "absorbed", true, true, "reflectance of all faces", "rmse",
              "relative RMSE of the exitance"}};

constexpr double canvas_width = 640;
constexpr double frame_left = 60;
constexpr double frame_right = canvas_width - 130;  // labels stand beyond it
constexpr double frame_top = 10;
constexpr double frame_bottom = 330;                 // as high as in the page, so that labels stand apart
constexpr double canvas_height = frame_bottom + 40;  // with the title of the axis

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
        out += svg_line(x.at(tick), x.at(tick), frame_top, frame_bottom, "stroke=\"#d0d0d0\"");
        out += svg_text(x.at(tick), frame_bottom + 16, " text-anchor=\"middle\"",
                        chart.reversed ? fmt::format("{:.6g}", 1 - tick) : tick_text(tick));
    }
    for (const double tick : y.ticks()) {
        out += svg_line(frame_left, frame_right, y.at(tick), y.at(tick), "stroke=\"#d0d0d0\"");
        out += svg_text(frame_left - 6, y.at(tick) + 4, " text-anchor=\"end\"", tick_text(tick));
    }
    out += svg_text((frame_left + frame_right) / 2, frame_bottom + 33, " text-anchor=\"middle\"", chart.x_title);
    return out + svg_text(14, (frame_top + frame_bottom) / 2,
                          fmt::format(" text-anchor=\"middle\" transform=\"rotate(-90 14 {:.1f})\"",
                                      (frame_top + frame_bottom) / 2),
                          chart.y_title);
}

/// Whether a logarithmic axis has a place for the row's error: it may be zero, or infinite, which is null.
bool has_place(const LineChart& chart, const PictureRow& row) {
    return row.has(chart.y) && row.number(chart.y) > 0;
}

/// The row's text in a column that not all kinds of pictures have.
std::string words_in(const PictureRow& row, const std::map<std::string, std::size_t>& columns, const char* column) {
    return columns.contains(column) ? row.words(column) : std::string();
}

/// The mark of a point with its interval: hollow where it is printed.
std::string mark_svg(const PictureRow& row, double x, double level, const SvgAxis& y, bool has_interval,
                     const std::string& colour, bool printed) {
    std::string out;
    if (has_interval && row.has("low") && row.has("high") && row.number("low") > 0)
        out += svg_line(x, x, y.at(row.number("low")), y.at(row.number("high")),
                        fmt::format(R"(stroke="{}" stroke-width="2")", colour));
    return out + fmt::format(
                     "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" stroke=\"{}\" stroke-width=\"1.5\" "
                     "fill=\"{}\"/>\n",
                     x, level, printed ? 5 : 3.5, colour, printed ? "none" : colour);
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
        if (!has_place(chart, row)) continue;
        rows.push_back(row);
        low = std::min(low, row.number(chart.x));
        high = std::max(high, row.number(chart.x));
    }
    if (rows.empty())
        return svg_drawing(canvas_width, canvas_height, picture.description,
                           svg_text(frame_left, frame_bottom / 2, "", "no error is finite"));
    const SvgAxis x(chart.log, low, high, chart.reversed ? frame_right : frame_left,
                    chart.reversed ? frame_left : frame_right);
    const Json& range = values["scales"]["y"]["domain"];
    const SvgAxis y(true, range[0].get<double>(), range[1].get<double>(), frame_bottom, frame_top);
    std::string content = grid(chart, x, y);
    std::string marks;
    // Points of a method follow each other, by ascending size; what theory expects is a line of its own.
    struct Path {
        std::string method;
        bool dashed = false;
        std::string points;
    };
    std::map<std::array<std::string, 3>, Path> paths;  // by method, and by what else makes a line of its own
    for (const PictureRow& row : rows) {
        const std::string method = row.words("method");
        const std::string role = words_in(row, columns, "role");
        const double at = x.at(row.number(chart.x));
        const double level = y.at(row.number(chart.y));
        const bool is_expected = role == "expected";
        const bool is_printed = role == "printed";
        if (!is_expected) marks += mark_svg(row, at, level, y, columns.contains("low"), colours[method], is_printed);
        if (is_printed) continue;
        const bool by_size = columns.contains("treatment");
        Path& path = paths[{method, by_size ? row.words("size") + row.words("treatment") : std::string(),
                            is_expected ? role : std::string()}];
        path.method = method;
        path.dashed = is_expected || (by_size && !row["own"].get<bool>());
        path.points += fmt::format("{:.1f},{:.1f} ", at, level);
    }
    for (const auto& [key, path] : paths)
        content += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"{}/>\n",
                               path.points, colours[path.method], path.dashed ? " stroke-dasharray=\"4 3\"" : "");
    content += marks;
    for (const Json& label : values["labels"])
        content += svg_text(frame_right + 8, y.at(label["height"].get<double>()) + 4,
                            fmt::format(" fill=\"{}\"", colours[label["method"].get<std::string>()]),
                            label["text"].get<std::string>());
    return svg_drawing(canvas_width, canvas_height, picture.description, content);
}

}  // namespace ff::reports
