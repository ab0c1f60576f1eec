#include "reports/pictures/answer_svg.hpp"

#include "core/support/contract.hpp"
#include "reports/pictures/svg_text.hpp"

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
constexpr double axis_left = 200;    // labels stand before it
constexpr double beside_marks = 30;  // room right of the axis for letters beside marks
constexpr double beside_axis = 150;  // and for words, which stand there
constexpr std::size_t most_letters = 3;
constexpr double row_height = 19;
constexpr double rows_top = 10;
constexpr double axis_height = 40;  // height with its title

std::string row_svg(const PictureRow& row, const SvgAxis& axis, double y, const std::string& colour) {
    std::string out;
    if (row.has("expected")) {
        const double x = axis.at(row.number("expected"));
        out += svg_line(x, x, y - 7, y + 7, R"(stroke="#595959" stroke-width="1.5")");
    }
    if (!row.has("value")) return out + svg_text(axis_left + 4, y + 4, R"( fill="#595959")", "exact to rounding");
    if (row.has("low")) {
        out += svg_line(axis.at(row.number("low")), axis.at(row.number("high")), y, y,
                        fmt::format(R"(stroke="{}" stroke-width="2")", colour));
    }
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", axis.at(row.number("value")), y,
                       colour);
    const std::string group = row.words("group");
    const double x = group.size() > most_letters ? ranking_width - beside_axis : axis.at(row.number("end"));
    return out + svg_text(x + 8, y + 4, "", group);
}

}  // namespace

std::string ranking_svg(const Picture& picture) {
    FF_EXPECT(picture.kind == "ranking");
    const Json values = Json::parse(picture.values);
    const auto columns = picture_columns(values);
    auto colours = picture_colours(values);
    std::map<std::string, PictureRow> rows;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double axis_right = ranking_width;
    for (const Json& each : values["rows"]) {
        const PictureRow row(columns, each);
        for (const char* column : {"value", "low", "high", "expected"}) {
            if (!row.has(column)) continue;
            low = std::min(low, row.number(column));
            high = std::max(high, row.number(column));
        }
        rows.emplace(row.words("row"), row);
        const bool is_word = row.has("value") && row.words("group").size() > most_letters;
        axis_right = std::min(axis_right, ranking_width - (is_word ? beside_axis : beside_marks));
    }
    if (!(low <= high)) low = high = 1;  // all are exact to rounding
    const SvgAxis axis(values.value("log", false), low, high, axis_left, axis_right);

    const Json& order = values["scales"]["y"]["domain"];
    const double bottom = rows_top + row_height * static_cast<double>(order.size());
    std::string out;
    for (const double tick : axis.ticks()) {
        out += svg_line(axis.at(tick), axis.at(tick), rows_top, bottom, "stroke=\"#d0d0d0\"");
        out += svg_text(axis.at(tick), bottom + 16, " text-anchor=\"middle\"", fmt::format("{:.6g}", tick));
    }
    out += svg_text((axis_left + axis_right) / 2, bottom + 33, " text-anchor=\"middle\"",
                    values["titles"]["x"].get<std::string>());
    double y = rows_top + row_height / 2;
    for (const Json& each : order) {
        const auto name = each.get<std::string>();
        const auto divider = name.find('|');
        const bool heading = divider == std::string::npos;
        out += heading ? svg_text(8, y + 4, " font-weight=\"bold\"", name)
                       : svg_text(axis_left - 8, y + 4, " text-anchor=\"end\"", name.substr(divider + 1));
        if (const auto row = rows.find(name); row != rows.end())
            out += row_svg(row->second, axis, y, colours[row->second.words("method")]);
        y += row_height;
    }
    return svg_drawing(ranking_width, bottom + axis_height, picture.description, out);
}

}  // namespace ff::reports
