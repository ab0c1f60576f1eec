#include "reports/words/findings/radiosity_words.hpp"

#include "core/geometry/scene.hpp"
#include "core/patches/patch_order.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "studies/radiosity/consequences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace ff::reports {
namespace {

using studies::radiosity::Consequences;
using studies::radiosity::Treatment;

/// Row sums that are 1 but for rounding.
constexpr double rounding = 1e-12;
/// Percentages below this are rounding.
constexpr double least_percents = 1e-9;

Treatment own_treatment(const studies::StudyPlan& plan, std::size_t cell) {
    return studies::radiosity::treatment_of(plan.spec.methods[plan.cells[cell].method].completion);
}

std::string dominance_text(const Consequences& found) {
    if (found.dominant_below.least > 1 - rounding) return "keeps diagonal dominance at every reflectance below 1";
    if (found.trials == 1) {
        return fmt::format(
            "loses diagonal dominance from reflectance {} on; the spectral radius of P F reaches 1 at {}",
            brief(found.dominant_below.least, 4), brief(found.convergent_below.least, 4));
    }
    return fmt::format(
        "loses diagonal dominance from reflectance {} on in half of the trials, from {} in the worst; the "
        "spectral radius of P F reaches 1 at {} there",
        brief(found.dominant_below.median, 4), brief(found.dominant_below.least, 4),
        brief(found.convergent_below.least, 4));
}

/// The value, with ± half the width of its interval if it has one.
std::string light_error_text(const studies::radiosity::SettingStatistics& at) {
    return at.light_interval ? percent_with_half_width(*at.light_error, at.light_interval->width() / 2)
                             : percent(*at.light_error);
}

/// The effect on the exitance at one setting.
std::string light_text(const studies::StudyPlan& plan, const Consequences& found, std::size_t setting) {
    const studies::radiosity::SettingStatistics& at = found.settings[setting];
    const std::string where = setting_text(plan, setting);
    const std::size_t impossible = at.negative + at.singular;
    if (found.trials == 1 && impossible > 0) return fmt::format("at {} the exitance is negative or undefined", where);
    if (impossible > 0)
        return fmt::format("at {} the exitance is negative or undefined in {} of {} trials", where, impossible,
                           at.trials);
    if (!at.light_error) return fmt::format("at {} its error has no mean", where);
    return fmt::format("at {} the exitance error is {}", where, light_error_text(at));
}

std::vector<std::string> cell_lines(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::size_t told = told_setting(plan);
    const std::size_t last = plan.spec.radiosity->reflectance.size() - 1;
    std::vector<std::string> lines;
    for (const std::size_t cell : all_lit_cells(plan)) {
        const Consequences* found = results.radiosity->find(cell, own_treatment(plan, cell));
        if (found->settings.empty()) continue;
        std::string line = fmt::format("{}, {}: I − P F {}; {}", cell_label(plan, plan.cells[cell]),
                                       studies::radiosity::name(found->treatment), dominance_text(*found),
                                       light_text(plan, *found, told));
        if (last != told) line += fmt::format(", {}", light_text(plan, *found, last));
        lines.push_back(line + ".");
    }
    return lines;
}

/// The exitance error that each treatment leaves.
std::string repair_line(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::size_t told = told_setting(plan);
    std::vector<std::string> parts;
    for (const std::size_t cell : all_lit_cells(plan)) {
        std::vector<std::string> errors;
        for (const Treatment treatment : studies::radiosity::all_treatments) {
            const Consequences* found = results.radiosity->find(cell, treatment);
            if (found->settings.empty() || !found->settings[told].light_error) continue;
            errors.push_back(
                fmt::format("{} {}", studies::radiosity::name(treatment), percent(*found->settings[told].light_error)));
        }
        if (!errors.empty())
            parts.push_back(fmt::format("{}: {}", cell_label(plan, plan.cells[cell]), fmt::join(errors, ", ")));
    }
    if (parts.empty()) return {};
    return fmt::format("Exitance error at reflectance {}, estimated or repaired: {}.", setting_text(plan, told),
                       fmt::join(parts, "; "));
}

/// The same between patches, with the patch of the largest error.
std::vector<std::string> patch_lines(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::size_t told = told_setting(plan);
    std::vector<std::string> lines;
    for (const std::size_t index : all_lit_cells(plan)) {
        const studies::Cell& cell = plan.cells[index];
        const Treatment own = own_treatment(plan, index);
        std::vector<std::string> errors;
        for (const Treatment treatment : studies::radiosity::all_treatments) {
            if (treatment == Treatment::normalised || (treatment == Treatment::reciprocal && treatment != own))
                continue;
            const Consequences* found = results.radiosity->find(index, treatment, studies::radiosity::Between::patches);
            if (found == nullptr || found->settings.empty() || !found->settings[told].light_error) continue;
            const auto& worst = *worst_element(found->settings[told]);
            errors.push_back(fmt::format("{} {}, on the worst patch {} ({})", studies::radiosity::name(treatment),
                                         percent(*found->settings[told].light_error), percent(relative_error(worst)),
                                         element_text(plan, *found, worst.element)));
        }
        if (errors.empty()) continue;
        lines.push_back(fmt::format("Between the {} patches of {}, exitance error at reflectance {}: {}.",
                                    radiating_patches(plan.scenes[cell.scene], cell.subdivision),
                                    cell_label(plan, cell), setting_text(plan, told), fmt::join(errors, "; ")));
    }
    return lines;
}

/// " with 25 patches per face" where all compared cells have as many; empty otherwise.
std::string patches_in_words(const studies::StudyPlan& plan) {
    std::set<std::uint32_t> patches;
    for (const std::size_t cell : all_lit_cells(plan)) patches.insert(plan.cells[cell].subdivision.per_part());
    return patches.size() == 1 && *patches.begin() > 1 ? fmt::format(" with {} patches per face", *patches.begin())
                                                       : std::string();
}

/// "; balance the factors: at most 0.2 %" where it is shown to reduce the exitance error of every compared
/// cell; empty otherwise.
std::string balancing_in_words(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::size_t told = told_setting(plan);
    using studies::radiosity::SettingStatistics;
    const auto low = [](const SettingStatistics& at) {
        return at.light_interval ? at.light_interval->low : *at.light_error;
    };
    const auto high = [](const SettingStatistics& at) {
        return at.light_interval ? at.light_interval->high : *at.light_error;
    };
    double most = 0;
    for (const std::size_t cell : all_lit_cells(plan)) {
        const Consequences* own = results.radiosity->find(cell, own_treatment(plan, cell));
        const Consequences* balanced = results.radiosity->find(cell, Treatment::balanced);
        if (own->settings.empty() || !own->settings[told].light_error) continue;
        if (balanced == nullptr || balanced->not_balanced > 0 || balanced->settings.empty() ||
            !balanced->settings[told].light_error)
            return {};
        if (own->trials > 1 && !balanced->settings[told].light_interval) return {};
        if (high(balanced->settings[told]) >= low(own->settings[told])) return {};
        most = std::max(most, high(balanced->settings[told]));
    }
    return fmt::format("; balance the factors: at most {}", percent(most, 2));
}

std::string bias_order_line(const studies::StudyResults& results) {
    std::vector<std::string> fitted;
    for (const studies::radiosity::BiasOrder& order : results.bias_orders) {
        if (!order.slope) continue;
        fitted.push_back(fmt::format("{:.2f} [{:.2f}, {:.2f}] ({}, {}, reflectance {})", *order.slope,
                                     order.interval->low, order.interval->high, order.label,
                                     studies::radiosity::name(order.treatment),
                                     setting_text(results.findings.plan, order.setting)));
    }
    if (fitted.empty()) return {};
    return fmt::format(
        "The exitance is biased though the factors are not: with N rays per face its bias falls as a power of N, −1 "
        "for "
        "large N. The power could be fitted in {} of {} cases, where the bias is clear at every size: {}.",
        fitted.size(), results.bias_orders.size(), fmt::join(fitted, "; "));
}

}  // namespace

std::vector<std::size_t> all_lit_cells(const studies::StudyPlan& plan) {
    std::vector<std::size_t> all;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const auto cells = lit_cells(plan, scene);
        all.insert(all.end(), cells.begin(), cells.end());
    }
    return all;
}

std::size_t told_setting(const studies::StudyPlan& plan) {
    constexpr double of_white_walls = 0.9;
    const auto& settings = plan.spec.radiosity->reflectance;
    for (std::size_t i = settings.size(); i-- > 0;) {
        if (std::all_of(settings[i].begin(), settings[i].end(), [](double r) { return r <= of_white_walls; })) return i;
    }
    return settings.size() / 2;
}

std::vector<std::size_t> lit_cells(const studies::StudyPlan& plan, std::size_t scene) {
    std::map<std::uint64_t, std::vector<std::size_t>> by_cost;
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const studies::Cell& cell = plan.cells[i];
        if (cell.scene != scene || estimator_info(plan.spec.methods[cell.method]).exact) continue;
        by_cost[studies::evaluations_per_trial(plan, cell)].push_back(i);
        all.push_back(i);
    }
    const auto dearest = std::find_if(by_cost.rbegin(), by_cost.rend(), [&](const auto& group) {
        std::set<std::size_t> methods;
        for (const std::size_t cell : group.second) methods.insert(plan.cells[cell].method);
        return methods.size() > 1;
    });
    return dearest == by_cost.rend() ? all : dearest->second;
}

std::string percent(double share, int digits) {
    const double percents = 100 * share;
    if (std::abs(percents) < least_percents) return "0 %";
    return std::abs(percents) < 100 ? fmt::format("{} %", brief(percents, digits)) : fmt::format("{:.0f} %", percents);
}

std::string percent_with_half_width(double share, double half) {
    return 100 * half < least_percents ? percent(share) : with_half_width(100 * share, 100 * half) + " %";
}

std::string over_trials_text(const studies::radiosity::OverTrials& range, std::size_t trials, int digits) {
    if (trials == 1) return brief(range.median, digits);
    return with_ends(range.median, range.least, range.largest, digits);
}

std::string bias_text(const studies::radiosity::ExitanceStatistics& found) {
    if (!found.bias) return "no mean";
    if (!found.bias_interval) return percent(*found.bias / found.exact);
    return percent_with_half_width(*found.bias / found.exact, found.bias_interval->width() / 2 / found.exact);
}

std::string iterations_text(const studies::radiosity::SolverStatistics& found) {
    if (found.converged == found.runs) return over_trials_text(*found.iterations, found.runs, 6);
    std::vector<std::string> parts;
    for (const auto& [count, word] : {std::pair{found.converged, "converged"}, std::pair{found.diverged, "diverged"},
                                      std::pair{found.stalled, "stalled"}, std::pair{found.exhausted, "too slow"}}) {
        if (count > 0) parts.push_back(found.runs == 1 ? std::string(word) : fmt::format("{} {}", count, word));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

double relative_error(const studies::radiosity::ExitanceStatistics& found) {
    return found.exact > 0 ? *found.rmse / found.exact : 0;
}

const studies::radiosity::ExitanceStatistics* worst_element(const studies::radiosity::SettingStatistics& at) {
    if (!at.light_error) return nullptr;
    return &*std::max_element(at.exitance.begin() + 1, at.exitance.end(),
                              [](const auto& a, const auto& b) { return relative_error(a) < relative_error(b); });
}

Place place_of(const Scene& scene, Subdivision subdivision, studies::radiosity::Between between, std::size_t element) {
    if (between == studies::radiosity::Between::faces) return {scene.faces[element - 1]};
    const PatchOrder order(scene, subdivision, Numbered::of_faces);
    const PatchPlace place = order.place(static_cast<std::uint32_t>(element - 1));
    const int face = scene.surfaces[place.surface].face;
    return {scene.faces[static_cast<std::size_t>(face)], place.row + std::size_t{1}, place.column + std::size_t{1}};
}

std::string element_text(const studies::StudyPlan& plan, const studies::radiosity::Consequences& found,
                         std::size_t element) {
    const studies::Cell& cell = plan.cells[found.cell];
    const Place place = place_of(plan.scenes[cell.scene], cell.subdivision, found.between, element);
    if (place.row == 0) return fmt::format("face {}", place.face);
    return fmt::format("face {}, row {}, column {}", place.face, place.row, place.column);
}

std::string setting_text(const studies::StudyPlan& plan, std::size_t setting) {
    return studies::in_words(plan.spec.radiosity->reflectance[setting]);
}

std::optional<LightInBrief> light_in_brief(const studies::StudyResults& results) {
    if (!results.radiosity) return std::nullopt;
    const studies::StudyPlan& plan = results.findings.plan;
    const std::size_t told = told_setting(plan);
    std::map<std::size_t, const studies::radiosity::SettingStatistics*> errors;  // largest error of each method
    for (const std::size_t cell : all_lit_cells(plan)) {
        const Consequences* found = results.radiosity->find(cell, own_treatment(plan, cell));
        if (found->settings.empty() || !found->settings[told].light_error) continue;
        const studies::radiosity::SettingStatistics*& largest = errors[plan.cells[cell].method];
        if (largest == nullptr || *largest->light_error < *found->settings[told].light_error)
            largest = &found->settings[told];
    }
    if (errors.empty()) return std::nullopt;
    LightInBrief brief;
    brief.reflectance = setting_text(plan, told);
    std::vector<std::string> parts;  // methods in the study's order: no test tells which error is smaller
    for (const auto& [method, at] : errors)
        parts.push_back(fmt::format("{} with {}", light_error_text(*at), plan.spec.methods[method].name));
    brief.clause =
        fmt::format("at reflectance {}{} the light errs by {}{}{}", brief.reflectance, patches_in_words(plan),
                    fmt::join(parts, ", "), plan.scenes.size() > 1 ? ", in the scene where it is largest" : "",
                    balancing_in_words(results));
    const auto [least, largest] = std::minmax_element(errors.begin(), errors.end(), [](const auto& a, const auto& b) {
        return *a.second->light_error < *b.second->light_error;
    });
    brief.value = percent(*least->second->light_error);
    if (errors.size() > 1) brief.value += fmt::format(" to {}", percent(*largest->second->light_error));
    return brief;
}

std::vector<std::string> radiosity_in_brief(const studies::StudyResults& results) {
    if (!results.radiosity) return {};
    std::vector<std::string> lines = cell_lines(results);
    if (std::string line = repair_line(results); !line.empty()) lines.push_back(std::move(line));
    const auto trials = studies::radiosity::patch_trials(results.findings.plan, *results.radiosity);
    if (!trials.complete()) {
        lines.push_back(fmt::format("Stopped early: systems between patches are evaluated for {} of {} trials.",
                                    trials.done, trials.wanted));
    }
    for (std::string& line : patch_lines(results)) lines.push_back(std::move(line));
    if (std::string line = bias_order_line(results); !line.empty()) lines.push_back(std::move(line));
    return lines;
}

}  // namespace ff::reports
