#include "studies/claims/claim_evidence.hpp"

#include "stats/basics/binomial.hpp"
#include "stats/basics/moments.hpp"
#include "stats/means/mean_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ff::studies {

std::vector<std::size_t> ClaimEvidence::cells(const PublishedClaim& claim) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < findings_.plan.cells.size(); ++i) {
        const Cell& cell = findings_.plan.cells[i];
        if (cell.scene != scene_ || findings_.cells[i].trials == 0) continue;
        if (!names(claim.patches_per_face, cell.subdivision.per_part())) continue;
        if (cell.deterministic || names(claim.samples_per_patch, cell.samples_per_patch)) found.push_back(i);
    }
    return found;
}

std::vector<std::size_t> ClaimEvidence::cells(const PublishedClaim& claim, std::size_t method) const {
    if (method >= claim.methods.size()) return {};
    auto found = cells(claim);
    std::erase_if(found, [&](std::size_t i) {
        return findings_.plan.spec.methods[findings_.plan.cells[i].method].name != claim.methods[method];
    });
    std::ranges::sort(found, {}, [&](std::size_t i) {
        const Cell& cell = findings_.plan.cells[i];
        return std::pair(cell.subdivision.m, cell.samples_per_patch);
    });
    return found;
}

bool ClaimEvidence::infinite_variance(const PublishedClaim& claim) const {
    for (std::size_t method = 0; method < claim.methods.size(); ++method) {
        for (const std::size_t cell : cells(claim, method)) {
            for (const Quantity pair : pairs(claim.pair_class)) {
                if (findings_.cells[cell].summary(pair).variance == VarianceStatus::infinite) return true;
            }
        }
    }
    return false;
}

std::vector<double> ClaimEvidence::sum_errors(std::size_t cell) const {
    return cells_.load(cell)->sum_relative_error;
}

std::vector<double> ClaimEvidence::pair_errors(std::size_t cell, std::size_t trial,
                                               const std::vector<Quantity>& pairs) const {
    const auto estimates = cells_.load(cell);
    std::vector<double> errors;
    for (const Quantity pair : pairs) {
        const auto& values = estimates->values(pair);
        const double reference = findings_.cells[cell].summary(pair).reference.value_or(0.0);
        errors.push_back(100.0 * std::abs(values[values.size() == 1 ? 0 : trial] - reference) / reference);
    }
    return errors;
}

std::vector<Quantity> ClaimEvidence::pairs(std::string_view pair_class) const {
    const Scene& scene = findings_.plan.scenes[scene_];
    auto list = distinct_pairs(findings_.plan.scenes.faces(scene_).size(), Completion::reciprocal);
    std::erase_if(list, [&](Quantity pair) {
        return !pair_class.empty() && pair_class != "all" &&
               name(ff::pair_class(scene, pair.from - 1, pair.to - 1)) != pair_class;
    });
    return list;
}

std::vector<double> ClaimEvidence::printed_errors(const PublishedClaim& claim, std::size_t method,
                                                  const std::vector<Quantity>& pairs) const {
    const std::vector<std::string>& faces = findings_.plan.scenes.faces(scene_);
    std::vector<double> errors;
    if (method >= claim.methods.size()) return errors;
    for (const Quantity pair : pairs) {
        for (const Figure& figure : tables_.figures) {
            if (figure.kind != FigureKind::relative_error || figure.method != claim.methods[method]) continue;
            if (!names(claim.patches_per_face, figure.patches_per_face)) continue;
            if (figure.samples_per_patch && !names(claim.samples_per_patch, *figure.samples_per_patch)) continue;
            if (figure.from != faces[static_cast<std::size_t>(pair.from - 1)]) continue;
            if (figure.to != faces[static_cast<std::size_t>(pair.to - 1)]) continue;
            errors.push_back(std::strtod(figure.printed.c_str(), nullptr));
            break;
        }
    }
    if (errors.size() != pairs.size()) errors.clear();
    return errors;
}

Share share_of(std::size_t count, std::size_t of, double level) {
    return {count, of, stats::clopper_pearson_interval({count, of}, level)};
}

MeanWithError mean_with_error(const std::vector<double>& values, double level) {
    const double mean = *stats::moments_of(values, values.front()).mean();
    if (std::ranges::all_of(values, [&](double value) { return value == values.front(); })) return {mean, 0};
    const auto interval = stats::mean_interval(values, mean, level);
    return {mean, interval ? std::max(-interval->low, interval->high) : std::numeric_limits<double>::infinity()};
}

Judgement not_in_study() {
    return {ClaimVerdict::inconclusive, "The study has no trials of the methods and sizes that the claim is about."};
}

std::string percent(const MeanWithError& value) {
    if (value.half_width == 0 && value.mean < rounding_percent) return "exact to rounding";
    if (value.half_width == 0) return fmt::format("{:.3g} %", value.mean);
    if (!std::isfinite(value.half_width))
        return fmt::format("{:.3g} % (of too few trials, or too skewed ones, for an interval)", value.mean);
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(value.half_width))));
    return fmt::format("{:.{}f} ± {:.{}f} %", value.mean, decimals, value.half_width, decimals);
}

std::string percent(const Share& share) {
    return fmt::format("{:.1f} % [{:.1f}, {:.1f}] of {} trials", 100 * share.value(), 100 * share.interval.low,
                       100 * share.interval.high, share.of);
}

}  // namespace ff::studies
