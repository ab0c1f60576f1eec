#include "reports/html/trend_html.hpp"

#include "reports/html/html_page.hpp"
#include "reports/terminal/trend_text.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

constexpr double trend_width = 720;
constexpr double trend_height = 160;
constexpr double trend_margin = 12;

struct Point {
    double x = 0;
    double y = 0;
};

/// Places of runs and values in the picture.
struct TrendFrame {
    double low = 0;
    double high = 1;
    std::size_t runs = 1;

    [[nodiscard]] double x(double run) const {
        return trend_margin +
               (trend_width - 2 * trend_margin) * run / static_cast<double>(std::max<std::size_t>(1, runs - 1));
    }
    [[nodiscard]] double y(double value) const {
        return trend_height - trend_margin - (trend_height - 2 * trend_margin) * (value - low) / (high - low);
    }
};

TrendFrame frame_of(const studies::Trend& trend) {
    TrendFrame frame{trend.values.front(), trend.values.front(), trend.values.size()};
    for (std::size_t i = 0; i < trend.values.size(); ++i) {
        const double error = trend.errors.empty() ? 0 : trend.errors[i];
        frame.low = std::min(frame.low, trend.values[i] - error);
        frame.high = std::max(frame.high, trend.values[i] + error);
    }
    if (frame.low == frame.high) frame.high = frame.low + 1;
    return frame;
}

void add_line(pugi::xml_node svg, Point from, Point to, const char* colour, const char* thickness) {
    pugi::xml_node line = svg.append_child("line");
    for (const auto& [name, value] : {std::pair("x1", from.x), {"y1", from.y}, {"x2", to.x}, {"y2", to.y}})
        set_attribute(line, name, fmt::format("{:.1f}", value));
    set_attribute(line, "stroke", colour);
    set_attribute(line, "stroke-width", thickness);
}

void add_trend_picture(pugi::xml_node body, const studies::Trend& trend) {
    const TrendFrame frame = frame_of(trend);
    pugi::xml_node svg = add_svg(body, trend_width, trend_height,
                                 fmt::format("{} of {} over {} runs, {} to {}", name(trend.what), trend.quantity,
                                             trend.values.size(), brief(frame.low), brief(frame.high)));
    if (trend.changed) {
        const auto first = static_cast<double>(trend.change->first);
        const double last = static_cast<double>(trend.values.size() - 1);
        add_line(svg, {frame.x(first - 0.5), 0}, {frame.x(first - 0.5), trend_height}, "#a4161a", "1");
        add_line(svg, {frame.x(0), frame.y(trend.change->before)},
                 {frame.x(first - 0.5), frame.y(trend.change->before)}, "#a4161a", "2");
        add_line(svg, {frame.x(first - 0.5), frame.y(trend.change->after)},
                 {frame.x(last), frame.y(trend.change->after)}, "#a4161a", "2");
    }
    for (std::size_t i = 0; i < trend.values.size(); ++i) {
        const double x = frame.x(static_cast<double>(i));
        if (!trend.errors.empty())
            add_line(svg, {x, frame.y(trend.values[i] - trend.errors[i])},
                     {x, frame.y(trend.values[i] + trend.errors[i])}, "#555", "1");
        pugi::xml_node dot = svg.append_child("circle");
        set_attribute(dot, "cx", fmt::format("{:.1f}", x));
        set_attribute(dot, "cy", fmt::format("{:.1f}", frame.y(trend.values[i])));
        set_attribute(dot, "r", "3");
        set_attribute(dot, "fill", "#1f5a99");
        add_element(dot, "title", fmt::format("{}: {}", trend.commits[i], brief(trend.values[i], 6)));
    }
}

}  // namespace

std::string trend_html(const std::vector<studies::Trend>& trends, double alpha) {
    HtmlPage page = begin_page("Trends", "h2{margin:1.5em 0 .2em}svg{border:1px solid #ccc}");
    add_element(page.body, "p",
                fmt::format("A change is found anywhere, where there is none, in at most a share of {} of histories. "
                            "Bars: standard errors.",
                            brief(alpha)));
    for (const studies::Trend& trend : trends) {
        add_element(page.body, "h2", fmt::format("{}, {}", trend.quantity, name(trend.what)));
        add_element(page.body, "p", trend_in_words(trend));
        add_trend_picture(page.body, trend);
    }
    return page_text(page);
}

}  // namespace ff::reports
