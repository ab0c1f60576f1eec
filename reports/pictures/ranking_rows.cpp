#include "reports/pictures/ranking_rows.hpp"

#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/answer.hpp"
#include "studies/diagnostics/claimed_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ff::reports {

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
    values_.add({order_.back(), method, row.size, drawn(row.value), drawn_low(row.interval), drawn_high(row.interval),
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
    return {text.id,
            "ranking",
            text.title,
            text.finding,
            fmt::format("A row for each method: {}, with its interval. {}", text.axis, text.description),
            rows.values().text()};
}

std::optional<Picture> claims_picture(const studies::StudyResults& results) {
    const auto& claims = results.claimed_errors;
    const auto fails = [](const studies::ClaimedErrors& each) {
        return each.finding == studies::ClaimedErrorFinding::fails;
    };
    const auto failing = std::count_if(claims.begin(), claims.end(), fails);
    const bool is_stated = std::any_of(claims.begin(), claims.end(), [](const studies::ClaimedErrors& each) {
        return each.claimant != studies::Claimant::one_run;
    });
    if (!is_stated && failing == 0) return std::nullopt;
    const studies::StudyPlan& plan = results.findings.plan;
    const MethodChoice all;
    RankingRows rows(plan, all);
    std::string heading;
    for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
        for (const studies::ClaimedErrors& each : claims) {
            const studies::Cell& cell = plan.cells[each.cell];
            const std::string its_heading = heading_of(plan, cell.scene, pair_class);
            constexpr std::size_t most_rows = 40;
            if (each.pair_class != pair_class || rows.rows() == most_rows) continue;
            if (its_heading != heading) {
                if (rows.full()) break;
                rows.heading(its_heading);
                heading = its_heading;
            }
            const studies::Method& method = plan.spec.methods[cell.method];
            const double share = static_cast<double>(each.worst_held) / static_cast<double>(cell.trials);
            rows.add({.label = fmt::format("{}{}{}", method.name,
                                           method.sizes.size() > 1 ? ", " + size_label(plan, cell) : "",
                                           each.claimant == studies::Claimant::one_run ? ", as random" : ""),
                      .method = cell.method,
                      .size = size_label(plan, cell),
                      .value = share,
                      .interval = each.worst_share_interval,
                      .expected = each.promised,
                      .group = fails(each) ? "fails" : ""});
        }
    }
    RankingText text;
    text.id = "claimed-errors";
    text.title = "How often claimed errors hold";
    text.axis = "share of runs within the claimed error, on the worst pair";
    text.finding = fmt::format("{} of {} claims about errors {} not hold as often as they should.", failing,
                               claims.size(), failing == 1 ? "does" : "do");
    text.description = "The line across a row is the share in which the claim should hold. " + text.finding;
    return ranking_picture(results, text, {}, rows);
}

std::optional<Picture> lead_picture(const studies::StudyResults& results, const MethodChoice& methods) {
    const Answer said = answer(results);
    const MainFinding& found = said.finding;
    if (found.subject == Subject::light) {
        const auto group = radiosity_pictures(results);
        return group && !group->pictures.empty() ? std::optional(group->pictures.front()) : std::nullopt;
    }
    if (found.subject == Subject::occlusion) return occlusion_pictures(results, methods).front();
    const bool is_about_all = found.subject == Subject::coverage || found.subject == Subject::configurations;
    if (is_about_all && !methods.names.empty()) return std::nullopt;
    RankingRows rows(results.findings.plan, methods);
    for (const Ranking& ranking : found.rankings) {
        if (is_about_all || !rows.full()) rows.add(ranking);
    }
    if (rows.rows() < 2) return std::nullopt;  // one number needs no picture
    Picture picture = ranking_picture(results,
                                      {"answer", found.title, found.axis, found.note, said.text, found.logarithmic,
                                       found.subject != Subject::coverage},
                                      methods, rows);
    if (found.subject == Subject::rates) {
        picture.name = "convergence rates";
        picture.alternatives = errors_at_sizes(results, methods);
    }
    return picture;
}

}  // namespace ff::reports
