#pragma once

#include "reports/words/findings/standing.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// The words in which methods are compared: "err less" and, around the values of the best, "RMSE 0.0016 to 0.0023".
struct Comparative {
    std::string_view better;
    std::string_view before_values;
    std::string_view after_values = {};
    std::string_view than = "another";
    bool is_enough = true;  ///< whether who does better is the one to take
};
inline constexpr Comparative errs_less{"err less", "RMSE "};
// Errors may be large though they fall fast.
inline constexpr Comparative converges_faster{"converge faster", "slopes ", "", "another", false};
inline constexpr Comparative varies_less{"vary less", "", " times less than random points", "random points"};

/// Advice on what to take, as clauses: "take sobol or halton: on parallel and adjacent pairs nothing is shown to err
/// less (RMSE between 0.0016 and 0.0023)". The numbers hold the intervals of all methods named. Where no method is
/// among the best in all rankings of a size, a clause for each.
/// @param words  how much is said of each ranking: the less, the more of them an answer has room for
enum class Words { with_cost, with_margin, names_alone };
std::vector<std::string> advice(const studies::StudyPlan& plan, std::vector<Ranking> rankings,
                                const Comparative& comparative, Words words = Words::with_cost);

/// A clause for each ranking, beginning with its pairs; rankings of a scene in which the same is said share one.
std::vector<std::string> clauses_of(const studies::StudyPlan& plan, const std::vector<Ranking>& rankings,
                                    std::string Ranking::*said = &Ranking::said);

}  // namespace ff::reports
