#pragma once

#include "studies/plan/plan.hpp"
#include "studies/run/run.hpp"
#include "studies/store/store.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// Key of a Context under which measured costs are kept.
inline constexpr std::string_view costs_key = "processor_time";

/// The measured cost of the trials of a cell.
struct MeasuredCost {
    std::uint64_t trials = 0;
    double seconds = 0;          ///< processor time of all of them
    double squared_seconds = 0;  ///< sum of the squares of each one's

    [[nodiscard]] double mean() const { return seconds / static_cast<double>(trials); }
    /// Relative standard error of the mean, with what the machine does to all trials of a cell alike: 10 %, and a
    /// millisecond in all.
    [[nodiscard]] double relative_error() const;
};

/// Processor time measured in a run, by cell.
class MeasuredCosts {
  public:
    explicit MeasuredCosts(const StudyPlan& plan) : plan_(plan), of_cells_(plan.cells.size()) {}

    void add(const RunProgress& progress);

    /// The costs of methods without a table of costs, i.e. programs and functions of a user: "mine at 64: 0.0312 s,
    /// mine at 256: 0.124 s" by method and size, over all scenes and patches; empty where nothing was measured.
    [[nodiscard]] std::string in_words() const;

    /// The entries for a Context, "KEY:TRIALS:SECONDS:SQUARES", separated by "; " like values of several runs, which
    /// all count. KEY is the key of the cell's random numbers, with the tracer if one is chosen. Empty where nothing
    /// was measured.
    [[nodiscard]] std::string in_context() const;

  private:
    const StudyPlan& plan_;
    std::vector<MeasuredCost> of_cells_;
};

/// The costs in a store's context, by cell of its plan; empty for cells without any.
std::vector<std::optional<MeasuredCost>> measured_costs(const StudyPlan& plan, const Context& context);

}  // namespace ff::studies
