#include "studies/form_factors/row_sums.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::form_factors {

void OrderlessSum::add(double value) {
    units_ += static_cast<Units>(std::ldexp(value, 100));
}

double OrderlessSum::value() const {
    return std::ldexp(static_cast<double>(units_), -100);
}

RowSums::RowSums(std::vector<double> areas, std::vector<double> levels)
    : areas_(std::move(areas)), levels_(std::move(levels)), rows_(areas_.size()) {}

void RowSums::add(std::size_t face, const PairEstimate& estimate) {
    FF_EXPECT(estimate.sum.has_value());
    Row& row = rows_[face];
    const double area = areas_[face];
    row.offset.add(estimate.sum->offset / area);
    row.offset_error.add(estimate.sum->offset_error / area);
    row.unmet.resize(levels_.size(), 0.0);
    for (const auto& [scale, share] : estimate.sum->terms) {
        FF_EXPECT(share.means.size() == randomisations);
        row.is_sampled = true;
        for (std::size_t r = 0; r < randomisations; ++r) row.means[r].add(scale * share.means[r] / area);
        for (std::size_t k = 0; k < levels_.size(); ++k)
            row.unmet[k] = std::max(row.unmet[k], unmet_of(scale, share, levels_[k]) / area);
    }
}

EstimatedSum RowSums::at(std::size_t face, double level) const {
    const Row& row = rows_[face];
    EstimatedSum result{row.offset.value(), row.offset_error.value(), row.offset_error.value(), 0};
    if (!row.is_sampled) return result;
    const auto known = std::find(levels_.begin(), levels_.end(), level);
    FF_EXPECT(known != levels_.end());
    std::vector<double> means;
    for (const OrderlessSum& mean : row.means) means.push_back(mean.value());
    return with_means(result, means, row.unmet[static_cast<std::size_t>(known - levels_.begin())], level);
}

}  // namespace ff::studies::form_factors
