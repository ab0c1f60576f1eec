#include "reports/json/heat_json.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/json_values.hpp"

namespace ff::reports {
namespace {

using studies::heat::Bounds;

Json bounds_json(const Bounds& bounds) {
    return {{"low", bounds.low}, {"high", bounds.high}};
}

Json groups_of_case_json(const studies::heat::Flows& flows) {
    Json groups = Json::array();
    for (const studies::heat::GroupFlow& group : flows.groups) groups.push_back(group_json(group));
    return groups;
}

Json case_json(const studies::heat::SolvedCase& solved, const studies::heat::FlowTolerance& tolerance) {
    const studies::heat::Flows& flows = solved.flows;
    return {{"case", solved.materials.name},
            {"surroundings", optional_json(solved.materials.surroundings)},
            {"emitted", flows.emitted},
            {"sources", flows.throughput},
            {"balance", bounds_json(flows.balance)},
            {"reaches_outside", flows.reaches_outside},
            {"worst_half_width", flows.worst},
            {"within", flows.within(tolerance)},
            {"interval", flows.statistical ? "statistical" : "bound"},
            {"groups", groups_of_case_json(flows)}};
}

}  // namespace

Json group_json(const studies::heat::GroupFlow& group) {
    return {{"group", group.name},
            {"faces", group.faces},
            {"area", group.area},
            {"net", bounds_json(group.net())},
            {"power", bounds_json(group.power)},
            {"share", group.share ? bounds_json(*group.share) : Json(nullptr)}};
}

Json flow_json(const std::string& name, const studies::heat::SolvedCase& solved, std::size_t face) {
    const studies::heat::FaceFlow& flow = solved.flows.faces[face];
    return {{"case", solved.materials.name},
            {"face", name},
            {"area", flow.area},
            {"radiosity", bounds_json(flow.radiosity)},
            {"irradiation", bounds_json(flow.irradiation)},
            {"net", bounds_json(flow.net)},
            {"power", bounds_json(flow.power)},
            {"temperature", bounds_json(flow.temperature)}};
}

std::string heat_json(const HeatReport& report, const HeatRequest& request, const std::vector<std::string>& warnings) {
    Json cases = Json::array();
    for (const auto& solved : report.cases) cases.push_back(case_json(solved, report.tolerance));
    const Json json = {{"scene", report.scene.name},
                       {"scale", request.scale},
                       {"tolerance", report.request.tolerance},
                       {"flow_tolerance", in_words(report.tolerance)},
                       {"sampled_for_flows", report.sampled != nullptr},
                       {"trusted", report.trusted},
                       {"level", report.request.level},
                       {"simultaneous", report.all_at_once},
                       {"seed", report.request.seed.value},
                       {"materials", request.materials},
                       {"cases", std::move(cases)},
                       {"warnings", warnings}};
    return json.dump(2) + "\n";
}

}  // namespace ff::reports
