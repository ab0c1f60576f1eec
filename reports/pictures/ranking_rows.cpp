#include "reports/pictures/ranking_rows.hpp"

#include "reports/pictures/method_styles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ff::reports {

using Json = nlohmann::ordered_json;

void RankingRows::heading(const std::string& text) {
    ++blocks_;
    block_ = text;
    begun_ = false;
}

void RankingRows::add(const RankedMethod& row) {
    const std::string& method = plan_.spec.methods[row.method].name;
    if (!chosen_.has(method)) return;
    if (!std::exchange(begun_, true)) order_.push_back(block_);
    ++rows_;
    methods_.insert(method);
    order_.push_back(fmt::format("{}|{}", block_, row.label));
    values_.add({order_.back(), method, row.size, drawn(row.value), row.interval ? drawn(row.interval->low) : Json(),
                 row.interval ? drawn(row.interval->high) : Json(),
                 row.interval ? drawn(row.interval->high) : drawn(row.value), drawn(row.expected), row.group});
}

void RankingRows::add(const Ranking& ranking) {
    heading(ranking.heading);
    for (const RankedMethod& row : ranking.methods) add(row);
}

Picture ranking_picture(const studies::StudyResults& results, const RankingText& text, const MethodChoice& methods,
                        RankingRows& rows) {
    const auto styles = method_styles(results, methods);
    auto names = Json::array();
    for (const MethodStyle& style : styles) {
        if (rows.methods().contains(style.method)) names.push_back(style.method);
    }
    if (names.size() > 1 && text.isolates) rows.values().set("isolate", std::move(names));
    Json scales = style_scales(styles);
    scales["y"] = {{"domain", rows.order()}};
    rows.values().set("scales", std::move(scales));
    rows.values().set("titles", {{"x", text.axis}});
    if (text.log) rows.values().set("log", true);
    constexpr std::size_t most_above_axis = 26;  // of more, the axis below is not on the first screen
    if (rows.rows() > most_above_axis) rows.values().set("tall", true);
    Picture picture;
    picture.id = text.id;
    picture.kind = "ranking";
    picture.title = text.title;
    picture.finding = text.finding;
    picture.description = fmt::format("A row for each method: {}, with its interval. {}", text.axis, text.description);
    picture.values = rows.values().text();
    return picture;
}

}  // namespace ff::reports
