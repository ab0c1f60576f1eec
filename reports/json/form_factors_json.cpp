#include "reports/json/form_factors_json.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/numbers.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

using studies::form_factors::FaceExchange;

Json faces_json(const FormFactorReport& report) {
    Json faces = Json::array();
    for (std::size_t i = 0; i < report.scene.faces.size(); ++i) {
        const studies::form_factors::RowSum& sum = report.matrix.rows[i];
        Json face = {{"face", report.scene.faces[i]},
                     {"area", report.matrix.areas[i]},
                     {"row_sum", sum.value},
                     {"row_sum_low", sum.low},
                     {"row_sum_high", sum.high}};
        if (!studies::form_factors::rows_add_up(report.scene))
            face.update({{"leaves", 1 - sum.value}, {"leaves_low", 1 - sum.high}, {"leaves_high", 1 - sum.low}});
        if (report.request.drop > 0) {
            const studies::form_factors::DroppedExchange& dropped = sum.dropped;
            face.update({{"dropped_pairs", dropped.pairs},
                         {"dropped", dropped.value},
                         {"dropped_low", dropped.low},
                         {"dropped_high", dropped.high}});
        }
        faces.push_back(std::move(face));
    }
    return faces;
}

Json repair_json(const FormFactorReport& report) {
    const auto& repaired = report.matrix.repaired;
    if (!repaired) return nullptr;
    return {{"possible", repaired->possible},
            {"closure_before", repaired->closure_before},
            {"closure_after", repaired->closure_after},
            {"largest_change", repaired->largest_change},
            {"from", report.scene.faces[repaired->from]},
            {"to", report.scene.faces[repaired->to]},
            {"outside", repaired->outside}};
}

}  // namespace

std::string form_factors_json(const FormFactorReport& report) {
    const studies::form_factors::Matrix& matrix = report.matrix;
    double worst = 0;
    for (const FaceExchange& exchange : matrix.exchanges) worst = std::max(worst, worst_half_width(matrix, exchange));
    Json json = {{"scene", report.scene.name},
                 {"tolerance", report.request.tolerance},
                 {"level", report.request.level},
                 {"coverage", report.request.level_of == studies::form_factors::LevelOf::entry ? "entry" : "matrix"},
                 {"entry_level", matrix.entry_level},
                 {"seed", report.request.seed.value},
                 {"pairs", matrix.pairs()},
                 {"missed", matrix.missed()},
                 {"worst_half_width", worst},
                 {"samples", matrix.samples},
                 {"rays", matrix.rays},
                 {"lost_rays", matrix.lost_rays},
                 {"faces", faces_json(report)},
                 {"repair", repair_json(report)},
                 {"warnings", form_factor_warnings(report)}};
    if (report.request.drop > 0) json.update({{"drop", report.request.drop}, {"dropped", matrix.dropped}});
    if (!report.request.surroundings.empty()) json["surroundings"] = report.request.surroundings;
    if (report.request.relative > 0) json["relative"] = report.request.relative;
    return json.dump(2) + "\n";
}

}  // namespace ff::reports
