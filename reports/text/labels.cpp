#include "reports/text/labels.hpp"

#include "reports/text/numbers.hpp"

#include "core/geometry/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ff::reports {

using studies::QuantityKind;

std::string from_label(const Scene& scene, const studies::Quantity& quantity) {
    return quantity.from == 0 ? std::string("all") : scene.faces.at(static_cast<std::size_t>(quantity.from - 1));
}

std::string to_label(const Scene& scene, const studies::Quantity& quantity) {
    switch (quantity.kind) {
        case QuantityKind::form_factor:
            return scene.faces.at(static_cast<std::size_t>(quantity.to - 1));
        case QuantityKind::row_sum:
            return "sum";
        case QuantityKind::sum_relative_error:
            break;
    }
    return "sum_re";
}

std::string quantity_label(const Scene& scene, const studies::Quantity& quantity) {
    switch (quantity.kind) {
        case QuantityKind::form_factor:
            return fmt::format("F {}-{}", from_label(scene, quantity), to_label(scene, quantity));
        case QuantityKind::row_sum:
            return fmt::format("Σ {}", from_label(scene, quantity));
        case QuantityKind::sum_relative_error:
            break;
    }
    return "Σ r.e.";
}

std::string size_label(const studies::StudyPlan& plan, const studies::Cell& cell) {
    const studies::Method& method = plan.spec.methods[cell.method];
    const auto patches = cell.subdivision.per_part();
    if (method.nodes) {
        const auto [source, target] = *method.nodes;
        if (target == 0) return fmt::format("{} × {}² nodes", patches, source);
        return fmt::format("{} × {}²·{}² nodes", patches, source, target);
    }
    const EstimatorInfo& estimator = estimator_info(method);
    if (cell.samples_per_patch == 0) return estimator.exact ? "exact" : "one size";
    const std::string_view counted = estimator.observes == Observes::hits ? "rays"
                                     : estimator.own_points               ? estimator.evaluations
                                                                          : "points";
    return fmt::format("{} × {} {}", patches, cell.samples_per_patch, counted);
}

std::string sizes_text(const studies::StudyPlan& plan, const studies::Ladder& ladder) {
    const bool patches = ladder.growth == studies::Growth::patches;
    const auto size = [&](std::size_t cell) {
        return patches ? plan.cells[cell].subdivision.per_part() : plan.cells[cell].samples_per_patch;
    };
    return fmt::format("{} … {} ({}){}", size(ladder.cells.front()), size(ladder.cells.back()), ladder.cells.size(),
                       patches ? " patches" : "");
}

std::string slope_text(const studies::Slope& slope) {
    if (!slope.slope) return "-";
    if (!slope.interval) return fmt::format("{:.2f}", *slope.slope);
    const auto interval = studies::interval_with_misfit(slope, slope.interval->level);
    return fmt::format("{:.2f}±{:.2f}", *slope.slope, interval->width() / 2);
}

std::string cell_label(const studies::StudyPlan& plan, const studies::Cell& cell) {
    return fmt::format("{}, {}", method_label(plan, cell), size_label(plan, cell));
}

std::string scene_prefix(const studies::StudyPlan& plan, std::size_t scene) {
    return plan.scenes.size() == 1 ? std::string() : plan.scenes.name(scene) + ": ";
}

std::string method_label(const studies::StudyPlan& plan, const studies::Cell& cell) {
    return scene_prefix(plan, cell.scene) + plan.spec.methods[cell.method].name;
}

std::string of_scene(const studies::StudyPlan& plan, std::size_t scene) {
    return plan.scenes.size() == 1 ? std::string() : fmt::format(" of {}", plan.scenes.name(scene));
}

std::string listed(std::vector<std::string> names, std::size_t most, std::string_view conjunction) {
    constexpr std::array<std::string_view, 3> separators{",", " and ", " or "};
    for (std::string& name : names) {
        const bool misreads = std::any_of(separators.begin(), separators.end(), [&](std::string_view separator) {
            return name.find(separator) != std::string::npos;
        });
        if (misreads) name = fmt::format("“{}”", name);
    }
    if (names.empty()) return {};
    if (names.size() == 1) return names.front();
    if (names.size() > most) {
        const std::size_t more = names.size() - most + 1;
        names.resize(most - 1);
        return fmt::format("{} {} {} more", fmt::join(names, ", "), conjunction, more);
    }
    const std::string last = names.back();
    names.pop_back();
    return fmt::format("{} {} {}", fmt::join(names, ", "), conjunction, last);
}

std::string budget_label(studies::Equal equal, double budget) {
    switch (equal) {
        case studies::Equal::evaluations:
            return fmt::format("at {:g} evaluations", budget);
        case studies::Equal::processor_time:
            return fmt::format("in {} s of processor time", brief(budget));
        case studies::Equal::error:
            break;
    }
    return fmt::format("at an RMSE of {}", brief(budget));
}

std::string_view kind_in_words(studies::PairKind kind) {
    switch (kind) {
        case studies::PairKind::parallel:
            return "parallel";
        case studies::PairKind::adjacent:
            return "adjacent";
        case studies::PairKind::other:
            return "other";
        case studies::PairKind::small:
            return "far";
        case studies::PairKind::occluded:
            return "possibly occluded";
        case studies::PairKind::occluded_adjacent:
            return "adjacent, possibly occluded";
        case studies::PairKind::curved:
            return "curved";
        case studies::PairKind::curved_adjacent:
            break;
    }
    return "adjacent curved";
}

std::string on_pairs(const studies::StudyPlan& plan, std::size_t scene, std::string_view classes) {
    return fmt::format("on {} pairs{}", classes, of_scene(plan, scene));
}

std::string begin_on_pairs(const studies::StudyPlan& plan, std::size_t scene, std::string_view classes) {
    return on_pairs(plan, scene, classes) + (of_scene(plan, scene).empty() ? "" : ",");
}

std::string heading_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    return fmt::format("{}{} pairs", scene_prefix(plan, scene), name(pair_class));
}

std::string program_label(const studies::Context& context) {
    const auto version = context.find("version");
    const auto revision = context.find("revision");
    if (version == context.end() || revision == context.end()) return {};
    return fmt::format("ffstudy {}, revision {}", version->second, revision->second);
}

}  // namespace ff::reports
