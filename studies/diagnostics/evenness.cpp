#include "studies/diagnostics/evenness.hpp"

#include "core/support/error.hpp"
#include "samplers/point_sets/draw_set.hpp"
#include "studies/sampler_checks/structure.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

namespace ff::studies {
namespace {

constexpr std::uint64_t most_points = 1024;  // discrepancies take the square of it
constexpr std::uint32_t sets = 4;
constexpr std::array<std::string_view, 4> measure_names{"L2-star discrepancy", "centred L2 discrepancy",
                                                        "largest gap of an axis", "t-value in base 2"};
using Measures = std::array<std::optional<double>, measure_names.size()>;

Measures measures_of(const samplers::PointSet& set) {
    const EvennessOfSet found = evenness_of(set, 2);
    return {found.l2_star_discrepancy, found.centred_discrepancy, found.largest_gap, found.t_value};
}

/// Means over a few sets; empty where points cannot be made.
std::optional<Measures> measures_of(std::string_view sampler, std::uint64_t points, std::size_t dimension) {
    Measures means;
    try {
        const auto& entry = samplers::find(sampler);
        const std::uint32_t drawn = entry.info.randomised ? sets : 1;
        for (std::uint32_t trial = 0; trial < drawn; ++trial) {
            const Measures found = measures_of(samplers::draw_set(entry, {points, dimension, 1, trial}));
            for (std::size_t i = 0; i < means.size(); ++i) {
                if (found[i]) means[i] = means[i].value_or(0) + *found[i] / drawn;
            }
        }
    } catch (const UserError&) {
        return std::nullopt;  // only its results are here
    }
    return means;
}

/// The setting that cells share if they differ only in the sampler.
using Setting = std::tuple<std::size_t, std::string, Completion, std::uint32_t>;
Setting setting_of(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    return {cell.scene, method.estimator, method.completion, cell.subdivision.m};
}

/// Cells whose points can be compared, by setting and size.
std::map<Setting, std::map<std::uint64_t, std::vector<std::size_t>>> groups_of(const StudyPlan& plan) {
    std::map<Setting, std::map<std::uint64_t, std::vector<std::size_t>>> groups;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Method& method = plan.spec.methods[plan.cells[i].method];
        if (method.sampler.empty() || method.nodes || method.allocation != Allocation::patch ||
            plan.cells[i].samples_per_patch > most_points)
            continue;
        auto& cells = groups[setting_of(plan, plan.cells[i])][plan.cells[i].samples_per_patch];
        const bool is_new = std::ranges::none_of(cells, [&](std::size_t other) {
            return plan.spec.methods[plan.cells[other].method].sampler == method.sampler;
        });
        if (is_new) cells.push_back(i);
    }
    return groups;
}

class Comparison {
  public:
    explicit Comparison(const Analysis& findings) : findings_(findings) {}

    std::vector<Evenness> compare(const std::vector<std::size_t>& cells, PairClass pair_class) {
        std::vector<Evenness> all;
        for (std::size_t measure = 0; measure < measure_names.size(); ++measure) {
            std::vector<double> unevenness;
            std::vector<double> errors;
            for (const std::size_t cell : cells) {
                const ClassError* error = findings_.cells[cell].class_error(pair_class);
                const auto& measures = measures_of_cell(cell);
                if (error == nullptr || !measures || !(*measures)[measure]) continue;
                unevenness.push_back(*(*measures)[measure]);
                errors.push_back(error->rmse);
            }
            const auto found = stats::rank_correlation(unevenness, errors, findings_.plan.spec.level);
            if (found) all.push_back({cells.front(), errors.size(), measure_names[measure], pair_class, *found});
        }
        return all;
    }

  private:
    const std::optional<Measures>& measures_of_cell(std::size_t index) {
        const Cell& cell = findings_.plan.cells[index];
        const Method& method = findings_.plan.spec.methods[cell.method];
        const std::tuple key{method.sampler, cell.samples_per_patch, estimator_info(method).dimension};
        const auto [at, is_new] = measures_.try_emplace(key);
        if (is_new) at->second = measures_of(method.sampler, cell.samples_per_patch, std::get<2>(key));
        return at->second;
    }

    const Analysis& findings_;
    std::map<std::tuple<std::string, std::uint64_t, std::size_t>, std::optional<Measures>> measures_;
};

}  // namespace

std::vector<Evenness> compare_evenness_with_errors(const Analysis& findings) {
    std::vector<Evenness> all;
    Comparison comparison(findings);
    for (const auto& [setting, sizes] : groups_of(findings.plan)) {
        const auto largest = std::find_if(sizes.rbegin(), sizes.rend(),
                                          [](const auto& size) { return size.second.size() >= stats::fewest_ranked; });
        if (largest == sizes.rend()) continue;
        for (const PairClass pair_class : pair_classes) {
            const auto found = comparison.compare(largest->second, pair_class);
            all.insert(all.end(), found.begin(), found.end());
        }
    }
    return all;
}

}  // namespace ff::studies
