#include "reports/json/json_slopes.hpp"

#include "reports/text/labels.hpp"

#include <array>

namespace ff::reports {
namespace {

std::string_view name(studies::RateFinding finding) {
    constexpr std::array<std::string_view, 5> names{"as_expected", "slower", "faster", "no_theory", "no_slope"};
    return names.at(static_cast<std::size_t>(finding));
}

Json expected_json(const studies::Slope& slope) {
    if (!slope.expected) return nullptr;
    return {{"rate", slope.expected->rate},
            {"slowest", slope.slowest_expected},
            {"bound", slope.expected->at_least},
            {"source", slope.expected->source},
            {"because", slope.expected->because}};
}

Json class_json(const Scene& scene, const studies::ClassSlopes& found) {
    Json json{{"pair_class", ff::name(found.pair_class)},
              {"pairs", found.pairs},
              {"finding", name(found.finding)},
              {"adjusted_p", optional_json(found.adjusted_p)},
              {"slopes", {slope_json(scene, found.rmse), slope_json(scene, found.median)}}};
    Json& sizes = json["sizes"] = Json::array();
    for (const studies::ClassError& size : found.sizes) {
        const bool infinite = size.status == studies::VarianceStatus::infinite;
        sizes.push_back({{"evaluations", size.evaluations},
                         {"rmse", infinite ? Json() : Json(size.rmse)},
                         {"median_abs_error", size.median_abs_error},
                         {"bias", size.bias},
                         {"bias_interval", interval_json(size.bias_interval)},
                         {"efficiency", optional_json(size.efficiency)},
                         {"efficiency_interval", interval_json(size.efficiency_interval)}});
    }
    return json;
}

}  // namespace

Json slope_json(const Scene& scene, const studies::Slope& slope) {
    return {{"from_face", slope.pair ? Json(from_label(scene, *slope.pair)) : Json(nullptr)},
            {"to_face", slope.pair ? Json(to_label(scene, *slope.pair)) : Json(nullptr)},
            {"pair_class", ff::name(slope.pair_class)},
            {"statistic", studies::name(slope.statistic)},
            {"slope", optional_json(slope.slope)},
            {"interval", interval_json(slope.interval)},
            {"interval_from_fit", interval_json(slope.interval_from_fit)},
            {"lack_of_fit_p", optional_json(slope.lack_of_fit_p)},
            {"expected", expected_json(slope)},
            {"p", optional_json(slope.p)},
            {"points", slope.points}};
}

Json slopes_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json ladders = Json::array();
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const Scene& scene = plan.scenes[ladder.ladder.scene];
        const bool samples = ladder.ladder.growth == studies::Growth::samples;
        Json json{{"scene", scene.name},
                  {"method", plan.spec.methods[ladder.ladder.method].name},
                  {"label", ladder.ladder.label},
                  {"growth", samples ? "samples" : "patches"},
                  {"multiplicity", "holm over all classes with an expected rate"}};
        Json& classes = json["classes"] = Json::array();
        for (const studies::ClassSlopes& found : ladder.classes) classes.push_back(class_json(scene, found));
        Json& pairs = json["pairs"] = Json::array();
        for (const studies::Slope& slope : ladder.pairs) pairs.push_back(slope_json(scene, slope));
        ladders.push_back(std::move(json));
    }
    return ladders;
}

}  // namespace ff::reports
