#include "reports/html/scene_html.hpp"

#include "reports/html/html_view.hpp"
#include "reports/html/scene_data.hpp"
#include "reports/html/security_policy.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/terminal/form_factors_text.hpp"
#include "reports/terminal/heat_text.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace ff::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_listed_faces = 1000;

/// Areas and sums of rows.
Table faces_table(const FormFactorReport& report) {
    Table table{
        "faces", "Faces",
        "",      {{"face", false, {}}, {"area", true, {}}, {"sum of the row", true, {}}, {"its interval", true, {}}},
        {},      {}};
    const bool drops = report.request.drop > 0;
    if (drops) table.columns.push_back({"dropped of it", true, {}});
    for (std::size_t face = 0; face < std::min(most_listed_faces, report.scene.faces.size()); ++face) {
        const studies::form_factors::RowSum& sum = report.matrix.rows[face];
        const double width = std::max(sum.high - sum.value, sum.value - sum.low);
        table.rows.push_back(
            {plain_cell(report.scene.faces[face]), plain_cell(brief(report.matrix.areas[face], 6)),
             plain_cell(to_error(sum.value, width)),
             plain_cell(fmt::format("{} to {}", to_error(sum.low, width), to_error(sum.high, width)))});
        const double half = std::max(sum.dropped.high - sum.dropped.value, sum.dropped.value - sum.dropped.low);
        if (drops) table.rows.back().push_back(plain_cell(with_half_width(sum.dropped.value, half)));
    }
    if (report.scene.faces.size() > most_listed_faces)
        table.remarks.push_back(
            fmt::format("The first {} faces, of {}.", most_listed_faces, report.scene.faces.size()));
    return table;
}

Table flows_table(const HeatReport& heat) {
    Table table = heat_table(heat, most_listed_faces);
    table.title = "Flows";
    table.note = "± is half of an interval; all hold at once.";
    return table;
}

}  // namespace

std::string scene_html(const FormFactorReport& report, const std::vector<std::string>& warnings, const HeatReport* heat,
                       const std::string& program, const Templates& templates) {
    const std::string style = templates.text("report.css") + templates.text("scene_report.css");
    const std::string& script = templates.text("scene_report.js");
    const std::array<std::string_view, 1> styles{style};
    const std::array<std::string_view, 1> scripts{script};
    const auto& [scene, request, matrix] = report;
    const std::string effort = heat == nullptr ? std::string() : heat_effort(*heat);
    const std::string tolerance = heat != nullptr && heat->sampled != nullptr
                                      ? in_words(heat->sampled->tolerance) + " of powers"
                                      : brief(request.tolerance);
    const Json view = {
        {"title", fmt::format("{} of {}", heat == nullptr ? "Form factors" : "Heat", scene.name)},
        {"policy", security_policy(styles, scripts)},
        {"style", style},
        {"script", script},
        {"warnings", texts_view(warnings)},
        {"verdict", heat == nullptr ? form_factors_verdict(report) : heat_verdict(*heat)},
        {"balance", heat == nullptr ? std::string() : heat_balance(*heat)},
        {"asked",
         fmt::format("{}, {}; tolerance {}, level {} {}, seed {}.{}{}", counted(scene.faces.size(), "face"),
                     counted(scene.surfaces.size(), "surface"), tolerance, brief(request.level, 10),
                     request.level_of == studies::form_factors::LevelOf::entry ? "of each entry" : "of all at once",
                     request.seed.value, effort.empty() ? "" : " ", effort)},
        {"listing", table_view(heat == nullptr ? faces_table(report) : flows_table(*heat))},
        {"program", program},
        {"data", scene_data(report, heat)}};
    return fill_template(templates, "scene_report", view, escape_html);
}

}  // namespace ff::reports
