#include "reports/html/html.hpp"

#include "reports/html/html_view.hpp"
#include "reports/html/scene_drawing.hpp"
#include "reports/html/security_policy.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/tables/radiosity_tables.hpp"
#include "reports/tables/tables.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/cells_in_between.hpp"
#include "reports/words/in_brief.hpp"
#include "reports/words/radiosity_words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace ff::reports {
namespace {

using Json = nlohmann::ordered_json;

Json published_view(const studies::PublishedResults& published, double alpha, const Headline& top) {
    Json tables = Json::array();
    for (std::size_t i = 0; i < published.tables.tables.size(); ++i)
        tables.push_back(table_view(published_table(published, i, alpha)));
    return {{"source", published.tables.source},
            {"wrong", texts_view(top.published)},
            {"contradictory", !top.published.empty()},
            {"unlikely", top.unlikely},
            {"tables", std::move(tables)},
            {"has_claims", !published.claims.empty()},
            {"claims", table_view(claims_table(published))},
            {"alpha", fmt::format("{:g}", 100 * alpha)}};
}

/// The tables of what is asked beyond bias and spread, as far as the study has it.
Json findings_view(const studies::StudyResults& results) {
    Json tables = Json::array();
    for (auto* make : {occlusion_table, configurations_table, convergence_table, reductions_table, evenness_table,
                       coverage_table, error_law_table, spreads_table}) {
        if (const Table table = make(results); !table.rows.empty()) tables.push_back(table_view(table));
    }
    return tables;
}

/// Line drawings of the scenes; of many the first.
Json scenes_view(const studies::StudyPlan& plan) {
    constexpr std::size_t most_drawings = 30;
    Json scenes = Json::array();
    for (std::size_t i = 0; i < std::min(most_drawings, plan.scenes.size()); ++i)
        scenes.push_back({{"name", plan.scenes[i].name}, {"drawing", scene_drawing(plan.scenes[i])}});
    return scenes;
}

Json pairs_view(const studies::StudyResults& results) {
    const auto hidden = cells_in_between(results);
    Json cells = Json::array();
    for (std::size_t i = 0; i < results.findings.cells.size(); ++i) {
        if (!hidden.contains(results.findings.cells[i].cell)) cells.push_back(table_view(pairs_table(results, i)));
    }
    return cells;
}

Json picture_view(const Picture& picture, bool is_drawn) {
    return {{"id", picture.id},
            {"kind", picture.kind},
            {"title", picture.title},
            {"finding", picture.finding},
            {"description", picture.description},
            {"values", picture.values},
            {"drawn", is_drawn}};
}

Json pictures_view(const std::vector<Picture>& pictures, bool drawn) {
    Json list = Json::array();
    for (const Picture& picture : pictures) list.push_back(picture_view(picture, drawn));
    return list;
}

Json radiosity_view(const studies::StudyResults& results) {
    Json tables = Json::array();
    for (const Table& table : radiosity_tables(results)) tables.push_back(table_view(table));
    return {{"lines", texts_view(radiosity_in_brief(results))}, {"tables", std::move(tables)}};
}

/// The specifications of the pictures that are shown.
Json kinds_view(const std::vector<Picture>& pictures, const std::vector<PictureGroup>& groups,
                const Templates& templates) {
    std::set<std::string> kinds;
    for (const Picture& picture : pictures) kinds.insert(picture.kind);
    for (const PictureGroup& group : groups) {
        for (const Picture& picture : group.pictures) kinds.insert(picture.kind);
    }
    Json list = Json::array();
    for (const std::string& kind : kinds)
        list.push_back({{"name", kind}, {"specification", templates.text(kind + ".json")}});
    return list;
}

/// Distributions and patches of methods are most of a report's bytes. Beyond what a page holds, those of the last
/// methods are left to files. @return how many pictures are left out
std::size_t leave_out(std::vector<PictureGroup>& groups) {
    constexpr std::size_t most_bytes = 530'000;
    std::size_t bytes = 0;
    for (const PictureGroup& group : groups) {
        for (const Picture& picture : group.pictures) bytes += picture.values.size();
    }
    const auto is_large = [](const Picture& picture) {
        return picture.kind == "qq" || picture.kind == "histogram" || picture.kind == "cube";
    };
    std::size_t left_out = 0;
    for (auto group = groups.rbegin(); group != groups.rend() && bytes > most_bytes; ++group) {
        if (group->open) continue;
        for (const Picture& picture : group->pictures) {
            if (is_large(picture)) bytes -= picture.values.size();
        }
        left_out += std::erase_if(group->pictures, is_large);
    }
    return left_out;
}

void add_pictures(const studies::StudyResults& results, const Templates& templates, Json& view) {
    const bool drawn = templates.has("vega.js");
    const auto lead = lead_picture(results);
    auto pictures = pictures_by_size(results);
    auto groups = picture_groups(results);
    // What is beside the answer is not shown again.
    const auto is_lead = [&](const Picture& picture) { return lead && picture.id == lead->id; };
    std::erase_if(pictures, is_lead);
    for (PictureGroup& group : groups) std::erase_if(group.pictures, is_lead);
    const std::size_t left_out = leave_out(groups);
    std::erase_if(groups, [](const PictureGroup& group) { return group.pictures.empty(); });
    view["left_out"] = left_out > 0 ? Json(fmt::format("{} pictures of the distributions and patches of single methods "
                                                       "are not on this page: ffstudy figure draws them.",
                                                       left_out))
                                    : Json();
    view["drawn"] = drawn;
    view["lead"] = lead ? picture_view(*lead, drawn) : Json();
    view["pictured"] = !pictures.empty() || !groups.empty();
    view["pictures"] = pictures_view(pictures, drawn);
    view["groups"] = Json::array();
    for (const PictureGroup& group : groups) {
        view["groups"].push_back(
            {{"title", group.title}, {"open", group.open}, {"pictures", pictures_view(group.pictures, drawn)}});
    }
    if (!drawn) return;
    view["runtime"] = templates.text("vega.js");
    if (lead) pictures.push_back(*lead);
    view["kinds"] = kinds_view(pictures, groups, templates);
}

}  // namespace

std::string html_report(const studies::StudyResults& results, const Templates& templates) {
    const studies::StudySpec& spec = results.findings.plan.spec;
    const Headline top = headline(results);
    Json view = headline_view(top);
    view["title"] = spec.title;
    view["partial"] = !results.findings.complete;
    view["published"] = results.published ? published_view(*results.published, 1 - spec.level, top) : Json();
    view["brief"] = texts_view(results_in_brief(results));
    view["has_brief"] = !view["brief"].empty();
    view["radiosity"] = results.radiosity ? radiosity_view(results) : Json();
    view["scenes"] = scenes_view(results.findings.plan);
    view["methods"] = table_view(methods_table(results));
    view["findings"] = findings_view(results);
    view["has_findings"] = !view["findings"].empty();
    view["pairs"] = pairs_view(results);
    view["again"] = reproduction_view(results);

    const std::string& style = templates.text("report.css");
    const std::string& script = templates.text("report.js");
    view["style"] = style;
    view["script"] = script;
    const std::vector<std::string_view> styles{style};
    add_pictures(results, templates, view);
    std::vector<std::string_view> scripts{script};
    if (templates.has("vega.js")) scripts.push_back(templates.text("vega.js"));
    view["policy"] = security_policy(styles, scripts);
    return fill_template(templates, "report", view, escape_html);
}

}  // namespace ff::reports
