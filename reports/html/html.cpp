#include "reports/html/html.hpp"

#include "reports/html/html_view.hpp"
#include "reports/html/scene_drawing.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/tables/tables.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/in_brief.hpp"
#include "reports/words/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ff::reports {
namespace {

Json published_view(const studies::PublishedResults& published, double alpha, const Headline& top) {
    Json tables = Json::array();
    for (std::size_t i = 0; i < published.tables.tables.size(); ++i)
        tables.push_back(table_view(published_table(published, i, alpha)));
    return {{"source", published.tables.source},
            {"has_figures", !published.tables.figures.empty()},
            {"wrong", texts_view(top.published)},
            {"contradictory", !top.published.empty()},
            {"unlikely", top.unlikely},
            {"tables", std::move(tables)},
            {"has_claims", !published.claims.empty()},
            {"claims", table_view(claims_table(published))},
            {"alpha", fmt::format("{:g}", 100 * alpha)}};
}

/// The table that the answer to a subject rests on.
std::string_view table_of(Subject subject) {
    switch (subject) {
        case Subject::occlusion:
            return "occlusion";
        case Subject::coverage:
            return "least-coverage";
        case Subject::choice:
            return "decisions";
        case Subject::configurations:
            return "agreement";
        case Subject::rates:
            return "rates";
        case Subject::variances:
            return "reductions";
        case Subject::light:
            return "told-light";
        case Subject::publication:
        case Subject::errors:
            break;
    }
    return "methods";
}

/// Sets the table that the answer rests on: of a long one the first rows, with the rest of it to be opened.
void set_main_table(const Table& table, Json& view) {
    constexpr std::size_t most_rows = 24;
    constexpr std::size_t first_rows = 12;
    Table first = table;
    if (table.rows.size() > most_rows) {
        first.rows.resize(first_rows);
        first.remarks.clear();
        Table whole = table;
        whole.id += "-whole";
        whole.title = fmt::format("{}: all {} rows", table.title, table.rows.size());
        view["rests_on_whole"] = table_view(whole);
    }
    view["rests_on"] = table_view(first);
}

/// Sets the table that the answer rests on, and all others, which readers open if they want to know more.
void add_tables(const studies::StudyResults& results, Subject subject, Json& view) {
    Json others = Json::array();
    view["rests_on_whole"] = Json();
    if (subject == Subject::light) set_main_table(told_light_table(results), view);
    if (subject == Subject::coverage) set_main_table(least_coverage_table(results), view);
    if (subject == Subject::rates) set_main_table(rates_table(results), view);
    if (subject == Subject::configurations) set_main_table(agreement_table(results), view);
    for (const Table& table :
         {methods_table(results), occlusion_table(results), configurations_table(results), convergence_table(results),
          decisions_table(results, false), contests_table(results, false), reductions_table(results),
          evenness_table(results), coverage_table(results), claimed_errors_table(results, Claims::all),
          error_law_table(results), spreads_table(results)}) {
        if (table.rows.empty()) continue;
        if (table.id == table_of(subject))
            set_main_table(table, view);
        else
            others.push_back(table_view(table));
    }
    view["has_findings"] = !others.empty();
    view["findings"] = std::move(others);
}

/// Line drawings of the scenes; only of the first where there are many.
Json scenes_view(const studies::StudyPlan& plan) {
    constexpr std::size_t most_drawings = 30;
    Json scenes = Json::array();
    for (std::size_t i = 0; i < std::min(most_drawings, plan.scenes.size()); ++i)
        scenes.push_back({{"name", plan.scenes.name(i)}, {"drawing", scene_drawing(plan.scenes[i])}});
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

/// The pictures that readers can choose from in place of one, which is among them; empty without a choice.
std::string alternatives_of(const Picture& picture) {
    if (picture.alternatives.empty()) return {};
    Json all = Json::array();
    const auto add = [&](const Picture& each) {
        all.push_back({{"name", each.name},
                       {"title", each.title},
                       {"finding", each.finding},
                       {"description", each.description},
                       {"values", Json::parse(each.values)}});
    };
    add(picture);
    for (const Picture& each : picture.alternatives) add(each);
    return json_in_html(all);
}

Json picture_view(const Picture& picture) {
    return {{"id", picture.id},
            {"kind", picture.kind},
            {"title", picture.title},
            {"finding", picture.finding},
            {"description", picture.description},
            {"values", picture.values},
            {"alternatives", alternatives_of(picture)}};
}

Json pictures_view(const std::vector<Picture>& pictures) {
    Json list = Json::array();
    for (const Picture& picture : pictures) list.push_back(picture_view(picture));
    return list;
}

/// What pictures show, by the beginnings of their titles: "4 pictures: Error against evaluations, Where errors are".
std::string contents_of(const std::vector<Picture>& pictures) {
    constexpr std::size_t most = 4;
    std::vector<std::string> kinds;
    for (const Picture& picture : pictures) {
        std::string kind = picture.title.substr(0, picture.title.find_first_of(",:."));
        if (kinds.size() < most && std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(std::move(kind));
    }
    return fmt::format("{}: {}", counted(pictures.size(), "picture"), fmt::join(kinds, ", "));
}

Json radiosity_view(const studies::StudyResults& results) {
    Json tables = Json::array();
    for (const Table& table : radiosity_tables(results)) tables.push_back(table_view(table));
    const auto lines = radiosity_in_brief(results);
    return {{"count", counted(lines.size(), "finding")}, {"lines", texts_view(lines)}, {"tables", std::move(tables)}};
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

/// The texts of rows as numbers of a list: long names stand on the page once.
std::string packed(const std::string& values) {
    Json json = Json::parse(values);
    Json texts = Json::object();
    for (std::size_t column = 0; column < json["columns"].size(); ++column) {
        const auto is_empty = [&](const Json& row) { return column >= row.size() || row[column].is_null(); };
        const auto is_text = [&](const Json& row) { return is_empty(row) || row[column].is_string(); };
        if (!std::all_of(json["rows"].begin(), json["rows"].end(), is_text)) continue;
        std::map<std::string, std::size_t> numbers;
        Json list = Json::array();
        for (Json& row : json["rows"]) {
            if (is_empty(row)) continue;
            const auto [at, is_new] = numbers.try_emplace(row[column], numbers.size());
            if (is_new) list.push_back(at->first);
            row[column] = at->second;
        }
        texts[std::to_string(column)] = std::move(list);
    }
    json["texts"] = std::move(texts);
    return json_in_html(json);
}

/// All pictures of a page.
struct PagePictures {
    std::optional<Picture> lead;
    std::vector<Picture> pictures;
    std::vector<PictureGroup> groups;
    std::size_t left_out = 0;
};

PagePictures pictures_of_page(const studies::StudyResults& results) {
    PagePictures page{lead_picture(results), pictures_by_size(results), picture_groups(results)};
    // The picture beside the answer is not shown again.
    const auto is_lead = [&](const Picture& picture) { return page.lead && picture.id == page.lead->id; };
    std::erase_if(page.pictures, is_lead);
    for (PictureGroup& group : page.groups) std::erase_if(group.pictures, is_lead);
    std::erase_if(page.groups, [](const PictureGroup& group) { return group.pictures.empty(); });
    const auto pack = [](std::vector<Picture>& pictures) {
        for (Picture& picture : pictures) picture.values = packed(picture.values);
    };
    if (page.lead) {
        page.lead->values = packed(page.lead->values);
        pack(page.lead->alternatives);
    }
    pack(page.pictures);
    for (PictureGroup& group : page.groups) pack(group.pictures);
    return page;
}

/// Pictures make up most of a report. They are left to separate files until about this many bytes are saved: first
/// those of the last single methods, distributions and patches, then the last of all methods together. @return whether
/// any was
bool leave_out(PagePictures& page, std::size_t bytes) {
    constexpr std::size_t markup = 800;  // bytes of a picture's markup, beside its texts
    const auto is_large = [](const Picture& picture) {
        return picture.kind == "qq" || picture.kind == "histogram" || picture.kind == "cube";
    };
    const auto is_any = [](const Picture&) { return true; };
    const std::size_t before = page.left_out;
    std::size_t saved = 0;
    const auto bytes_of = [](const Picture& picture) {
        return picture.values.size() + 2 * picture.description.size() + 2 * picture.title.size() + markup;
    };
    const auto leave = [&](const auto& is_left, bool compared) {
        for (auto group = page.groups.rbegin(); group != page.groups.rend() && saved < bytes; ++group) {
            if (group->compared != compared) continue;
            for (const Picture& picture : group->pictures) {
                if (is_left(picture)) saved += bytes_of(picture);
            }
            page.left_out += std::erase_if(group->pictures, is_left);
        }
    };
    leave(is_large, false);
    leave(is_any, false);
    leave(is_any, true);
    std::erase_if(page.groups, [](const PictureGroup& group) { return group.pictures.empty(); });
    for (; saved < bytes && !page.pictures.empty(); ++page.left_out) {
        saved += bytes_of(page.pictures.back());
        page.pictures.pop_back();
    }
    return page.left_out > before;
}

/// Leaves the tables of the last methods, pair by pair, to summary.csv until about this many bytes are saved, or a
/// little less. @return how many
std::size_t leave_out_pairs(Json& tables, std::size_t bytes) {
    std::size_t saved = 0;
    std::size_t left_out = 0;
    for (; saved < bytes && !tables.empty(); ++left_out) {
        saved += tables.back().dump().size();
        tables.erase(tables.size() - 1);
    }
    return left_out;
}

void add_pictures(const PagePictures& page, const Templates& templates, Json& view) {
    view["left_out"] = Json();
    if (page.left_out > 0)
        view["left_out"] = fmt::format("{} pictures are not on this page: ffstudy figure draws them.", page.left_out);
    view["lead"] = page.lead ? picture_view(*page.lead) : Json();
    view["pictured"] = !page.pictures.empty() || !page.groups.empty() || page.left_out > 0;
    view["pictures"] = pictures_view(page.pictures);
    view["all_pictures"] = page.pictures.empty() ? Json() : Json(contents_of(page.pictures));
    view["groups"] = Json::array();
    for (const PictureGroup& group : page.groups)
        view["groups"].push_back({{"title", group.title},
                                  {"contents", contents_of(group.pictures)},
                                  {"pictures", pictures_view(group.pictures)}});
    view["runtime"] = templates.text("vega.js");
    auto pictures = page.pictures;
    if (page.lead) pictures.push_back(*page.lead);
    view["kinds"] = kinds_view(pictures, page.groups, templates);
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
    view["findings_in_brief"] = counted(view["brief"].size(), "finding");
    view["radiosity"] = results.radiosity ? radiosity_view(results) : Json();
    view["scenes"] = scenes_view(results.findings.plan);
    add_tables(results, top.subject, view);
    view["pairs"] = pairs_view(results);
    view["has_pairs"] = !view["pairs"].empty();
    view["pairs_left_out"] = Json();
    view["again"] = reproduction_view(results);

    const std::string& style = templates.text("report.css");
    const std::string& script = templates.text("report.js");
    view["style"] = style;
    view["script"] = script;
    const std::vector<std::string_view> styles{style};
    PagePictures page = pictures_of_page(results);
    add_pictures(page, templates, view);
    const std::vector<std::string_view> scripts{script, templates.text("vega.js")};
    view["policy"] = security_policy(styles, scripts);
    const auto fill = [&] {
        view["many_pairs"] = counted(view["pairs"].size(), "table");
        return fill_template(templates, "report", view, escape_html);
    };
    std::string html = fill();
    constexpr std::size_t most_bytes = 1'500'000;
    while (html.size() > most_bytes && leave_out(page, html.size() - most_bytes)) {
        add_pictures(page, templates, view);
        html = fill();
    }
    std::size_t left_out = 0;
    while (html.size() > most_bytes && !view["pairs"].empty()) {
        left_out += leave_out_pairs(view["pairs"], html.size() - most_bytes);
        view["pairs_left_out"] = fmt::format("{} more methods and sizes are in summary.csv.", left_out);
        html = fill();
    }
    return html;
}

}  // namespace ff::reports
