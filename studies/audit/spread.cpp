#include "studies/audit/spread.hpp"

#include "studies/audit/scene_facts.hpp"

#include <Eigen/Core>

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ff::studies::audit {
namespace {

using Index = Eigen::Index;

/// Position of a figure's quantity in the covariance matrix of pairs or of sums.
Index position(const SceneFacts& facts, const Figure& figure) {
    const auto from = static_cast<Index>(*facts.face(figure.from));
    if (figure.kind == FigureKind::row_sum) return from;
    return from * static_cast<Index>(facts.faces()) + static_cast<Index>(*facts.face(figure.to));
}

/// log of the likelihood of one figure, up to a constant that all readings share.
double log_likelihood(const Expectation& expected, double value, std::size_t explained, double chance) {
    const double z = (value - expected.mean) / expected.sigma;
    const double density =
        std::exp(-0.5 * z * z) / (expected.sigma * std::sqrt(2 * std::numbers::pi)) * static_cast<double>(explained);
    return std::log((1 - misprint_share) * density / std::max(chance, 1e-300) + misprint_share);
}

ReadingEvidence weigh_reading(const PublishedTables& tables, const SceneFacts& facts, NumberFormat format,
                              DistributionCache& cache, ReadingEvidence reading) {
    std::vector<SampledFigure> sampled;
    for (std::size_t column = 0; column < reading.rays_per_face.size(); ++column) {
        const std::uint64_t rays = reading.rays_per_face[column];
        std::vector<SampledValue> values;
        std::optional<SrDistribution> distribution;
        for (std::size_t f = 0; f < tables.figures.size(); ++f) {
            const Figure& figure = tables.figures[f];
            if (figure.table != reading.table || figure.column != column) continue;
            if (!is_sampling(tables, figure.method) || !is_value(figure)) continue;
            distribution = cache.at(facts, figure.patches_per_face, rays, completion_of(tables, figure.method));
            if (!distribution) continue;
            const auto expected = expectation(facts, *distribution, figure);
            const auto number = parse_printed(figure.printed);
            if (!number || !expected || expected->sigma <= 0) continue;
            const auto range = printed_range(*number, format);
            const auto hits = range ? possible_hits(*range, rays) : std::nullopt;
            const double unit = printed_unit(number->value(), format);
            reading.log_odds +=
                log_likelihood(*expected, number->value(), hits ? static_cast<std::size_t>(hits->count()) : 0,
                               unit * static_cast<double>(rays));
            sampled.push_back({*number, rays});
            values.push_back({f, range.value_or(Range{number->value(), number->value()})});
        }
        reading.spread.push_back(distribution ? weigh_spread(tables, facts, *distribution, rays, values)
                                              : std::nullopt);
    }
    reading.hits = weigh_format(sampled, format);
    return reading;
}

}  // namespace

std::optional<JointDistance> weigh_spread(const PublishedTables& tables, const SceneFacts& facts,
                                          const SrDistribution& distribution, std::uint64_t rays,
                                          std::span<const SampledValue> values) {
    constexpr double fewest_hits = 4;
    const bool pairs = std::ranges::any_of(
        values, [&](const SampledValue& v) { return tables.figures[v.figure].kind == FigureKind::form_factor; });
    const Eigen::MatrixXd& covariance = pairs ? distribution.pair_covariance : distribution.sum_covariance;
    std::map<Index, SampledValue> of_position;
    for (const SampledValue& v : values) {
        const Figure& figure = tables.figures[v.figure];
        if ((figure.kind == FigureKind::form_factor) != pairs) continue;
        const double sigma = expectation(facts, distribution, figure)->sigma;
        if (sigma > 0 && sigma * static_cast<double>(rays) < fewest_hits) continue;
        of_position.try_emplace(position(facts, figure), v);
    }
    const auto n = static_cast<Index>(of_position.size());
    Eigen::MatrixXd part(n, n);
    std::vector<double> deviations;
    Eigen::VectorXd room(n);
    JointDistance spread;
    Index i = 0;
    for (const auto& [row, value] : of_position) {
        Index j = 0;
        for (const auto& [column, other] : of_position) part(i, j++) = covariance(row, column);
        room(i++) = 0.5 * std::max(0.0, value.values.high - value.values.low);
        deviations.push_back(value.values.middle() -
                             expectation(facts, distribution, tables.figures[value.figure])->mean);
        spread.figures.push_back(value.figure);
    }
    if (deviations.empty()) return std::nullopt;
    const auto form = stats::combine_deviations(deviations, part, 1e-6);
    if (!form || form->chi_squared.freedom == 0) return std::nullopt;
    spread.chi_squared = form->chi_squared;
    // The triangle inequality bounds how far the values can be from their middles.
    const double distance = std::sqrt(form->chi_squared.statistic);
    const double reach = std::sqrt(room.dot(form->inverse.cwiseAbs() * room));
    const double half_freedom = 0.5 * static_cast<double>(form->chi_squared.freedom);
    spread.too_far = boost::math::gamma_q(half_freedom, 0.5 * std::pow(std::max(0.0, distance - reach), 2));
    // Computed from its own tail: 1 - p loses it where the values are too close.
    spread.too_close = boost::math::gamma_p(half_freedom, 0.5 * std::pow(distance + reach, 2));
    return spread;
}

std::vector<ReadingEvidence> weigh_readings(const PublishedTables& tables, const SceneFacts& facts, NumberFormat format,
                                            DistributionCache& cache) {
    std::vector<ReadingEvidence> all;
    for (const PublishedTable& table : tables.tables) {
        if (!has_readings(tables, table.id)) continue;
        const std::size_t first = all.size();
        ReadingEvidence own{.table = table.id, .statement = "as the columns say", .stated_in = "columns"};
        own.rays_per_face.assign(table.column_titles.size(), 1);
        for (const Figure& figure : tables.figures) {
            if (figure.table == table.id && figure.samples_per_patch) {
                own.rays_per_face[figure.column] = *figure.samples_per_patch * figure.patches_per_face;
            }
        }
        all.push_back(weigh_reading(tables, facts, format, cache, own));
        for (const Reading& reading : tables.readings) {
            if (reading.table != table.id) continue;
            ReadingEvidence other{.table = table.id, .statement = reading.statement, .stated_in = reading.stated_in};
            other.rays_per_face = reading.rays_per_face;
            all.push_back(weigh_reading(tables, facts, format, cache, other));
        }
        double best = all[first].log_odds;
        for (std::size_t k = first; k < all.size(); ++k) best = std::max(best, all[k].log_odds);
        for (std::size_t k = first; k < all.size(); ++k) {
            all[k].log_odds -= best;
            all[k].refuted = all[k].log_odds < -std::log(refuting_odds);
        }
    }
    return all;
}

}  // namespace ff::studies::audit
