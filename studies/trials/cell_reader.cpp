#include "studies/trials/cell_reader.hpp"

#include <algorithm>

namespace ff::studies {
namespace {

std::size_t bytes_of(const CellEstimates& estimates) {
    std::size_t numbers = estimates.trial_numbers.size() + estimates.sum_relative_error.size();
    for (const auto& values : estimates.factors) numbers += values.size();
    for (const auto& values : estimates.row_sums) numbers += values.size();
    return numbers * sizeof(double);
}

}  // namespace

std::shared_ptr<const CellEstimates> CellReader::load(std::size_t cell) const {
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& kept) { return kept->cell == cell; });
    if (found != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, found);
    } else {
        kept_.push_front(std::make_shared<const CellEstimates>(load_estimates(*store_, cell)));
        std::size_t bytes = 0;
        const auto beyond = std::find_if(std::next(kept_.begin()), kept_.end(), [&](const auto& kept) {
            bytes += bytes_of(*kept);
            return bytes > most_kept_;
        });
        kept_.erase(beyond, kept_.end());
    }
    return kept_.front();
}

}  // namespace ff::studies
