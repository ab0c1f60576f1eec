#include "studies/verdicts/trend.hpp"

#include "stats/multiplicity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ff::studies {
namespace {

constexpr std::array<std::string_view, 3> trend_names{"mean", "spread", "cost"};

std::optional<double> value_of(const HistoryRow& row, TrendOf what) {
    return what == TrendOf::mean ? std::optional(row.mean) : what == TrendOf::spread ? row.spread() : row.cost;
}

/// The rows of a quantity; empty where not all of them have what is asked for.
std::optional<Trend> series_of(const History& history, const std::string& quantity, TrendOf what) {
    Trend trend;
    trend.quantity = quantity;
    trend.what = what;
    double least = 0;
    double most = 0;
    for (const HistoryRow& row : history) {
        if (row.quantity != quantity) continue;
        const auto value = value_of(row, what);
        if (!value || (what != TrendOf::mean && *value <= 0)) return std::nullopt;
        trend.commits.push_back(row.commit);
        trend.values.push_back(*value);
        if (what == TrendOf::mean) trend.errors.push_back(row.standard_error);
        least = trend.values.size() == 1 ? row.n : std::min(least, row.n);
        most = std::max(most, row.n);
    }
    constexpr double alike = 1.2;
    if (most > alike * least)
        trend.note = fmt::format("not tested: n differs between runs ({:g} to {:g}), so that they scatter differently",
                                 least, most);
    return trend;
}

std::vector<std::string> quantities_of(const History& history) {
    std::vector<std::string> names;
    for (const HistoryRow& row : history) {
        if (std::find(names.begin(), names.end(), row.quantity) == names.end()) names.push_back(row.quantity);
    }
    return names;
}

void test_trend(Trend& trend, const TrendOptions& options, std::size_t tests) {
    if (!trend.note.empty()) return;
    // Ten of them at the level of each series: p is resolved to a tenth of it.
    constexpr double most = 1e6;
    const double permutations = std::min(most, 10 * static_cast<double>(tests) / options.alpha);
    if (stats::least_change_p(trend.values.size()) * static_cast<double>(tests) > options.alpha) {
        trend.note = fmt::format("not tested: {} runs are too few for any change to be found at alpha = {:g}",
                                 trend.values.size(), options.alpha);
        return;
    }
    const auto key = derive_key(options.seed, fmt::format("trend|{}|{}", trend.quantity, name(trend.what)));
    std::vector<double> values = trend.values;
    if (trend.what != TrendOf::mean) {
        for (double& value : values) value = std::log(value);
    }
    trend.change = stats::find_change(values, {key, static_cast<std::uint32_t>(permutations) - 1});
    if (!trend.change) {
        trend.note = "all values are equal";
        return;
    }
    if (trend.what == TrendOf::mean) return;
    trend.change->before = std::exp(trend.change->before);
    trend.change->after = std::exp(trend.change->after);
}

}  // namespace

std::string_view name(TrendOf what) {
    return trend_names.at(static_cast<std::size_t>(what));
}

std::vector<Trend> find_trends(const History& history, const TrendOptions& options) {
    std::vector<Trend> trends;
    for (const std::string& quantity : quantities_of(history)) {
        for (const TrendOf what : {TrendOf::mean, TrendOf::spread, TrendOf::cost}) {
            if (auto trend = series_of(history, quantity, what)) trends.push_back(std::move(*trend));
        }
    }
    for (Trend& trend : trends) test_trend(trend, options, trends.size());
    std::vector<double> p;
    std::vector<Trend*> tested;
    for (Trend& trend : trends) {
        if (!trend.change) continue;
        p.push_back(trend.change->p);
        tested.push_back(&trend);
    }
    const auto adjusted = stats::holm(p);
    for (std::size_t i = 0; i < tested.size(); ++i) {
        tested[i]->adjusted_p = adjusted[i];
        tested[i]->changed = adjusted[i] <= options.alpha;
    }
    return trends;
}

}  // namespace ff::studies
