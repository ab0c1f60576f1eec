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

void RankingRows::add(const Row& row) {
    if (!chosen_.has(row.method)) return;
    if (!std::exchange(begun_, true)) order_.push_back(block_);
    ++rows_;
    if (!row.method.empty()) methods_.insert(row.method);
    order_.push_back(fmt::format("{}|{}", block_, row.label));
    values_.add({order_.back(), row.method, row.size, drawn(row.value),
                 row.interval ? drawn(row.interval->low) : Json(), row.interval ? drawn(row.interval->high) : Json(),
                 row.interval ? drawn(row.interval->high) : drawn(row.value), drawn(row.expected), row.group});
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

std::string letter(const std::vector<studies::Ranked>& ranked, const studies::Ranked& one) {
    const bool groups =
        std::any_of(ranked.begin(), ranked.end(), [](const studies::Ranked& each) { return each.group > 0; });
    return groups ? std::string(1, static_cast<char>('a' + std::min<std::size_t>(one.group, 25))) : std::string();
}

std::string heading_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    const std::string where = fmt::format("{} pairs", name(pair_class));
    return plan.scenes.size() == 1 ? where : fmt::format("{}: {}", plan.scenes[scene].name, where);
}

std::string letters_in_words(double level) {
    return fmt::format(
        "Methods with the same letter cannot be told apart from the first of them ({:g} % over all pairs of methods in "
        "a block).",
        100 * (1 - level));
}

}  // namespace ff::reports
