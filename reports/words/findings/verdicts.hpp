#pragma once

#include "reports/text/table.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// The family-wise bias test in words, in brackets the bias that would be detected: "none found (0.00019)".
std::string bias_in_words(const studies::CellAnalysis& found);

/// The equivalence test in words, in brackets the margin that would be shown: "shown (±0.00014)".
std::string equivalence_in_words(const studies::CellAnalysis& found);
/// The title of a column of these: "bias within ±0.0002". @pre the study has an equivalence margin
std::string margin_title(const studies::StudySpec& spec);

/// The mark for either, wherever it appears: bad where a bias is found, open where nothing is shown.
Mark bias_mark(const studies::CellAnalysis& found);
Mark equivalence_mark(studies::EquivalenceFinding finding);

/// The verdicts on bias of all cells of a study together.
struct BiasTally {
    std::size_t sampled = 0;                            ///< cells with a verdict
    std::map<studies::BiasFinding, std::size_t> found;  ///< how many have each
    std::size_t partly = 0;                  ///< cells without a bias found, some pairs of which have no test
    std::size_t shown = 0;                   ///< cells whose bias is shown to lie within the margin
    std::vector<double> detectable;          ///< their minimum detectable biases, ascending
    std::optional<std::uint64_t> lost_rays;  ///< lost rays of all cells; empty where no cell shoots rays
};
/// What BiasTally::sampled counts: "sampled methods and sizes", in a study of several scenes of all of them together.
std::string counted_cells(const studies::StudyPlan& plan);
BiasTally tally_of(const studies::Analysis& findings);

}  // namespace ff::reports
