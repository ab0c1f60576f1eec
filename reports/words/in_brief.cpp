#include "reports/words/in_brief.hpp"

#include "reports/text/numbers.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/reduction_words.hpp"
#include "reports/words/findings/slope_words.hpp"
#include "reports/words/findings/tail_words.hpp"
#include "reports/words/findings/until_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

/// The constants of c/m in one sentence; empty without laws.
std::vector<std::string> error_laws_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> laws;
    if (!results.occlusion.empty()) return laws;  // row sums are not what its scenes are about
    for (const studies::ErrorLaw& law : results.error_laws) {
        laws.push_back(fmt::format("{:+.4f} for {}{} (within {} %)", law.first_order.coefficient, law.method,
                                   law.published ? " as printed" : "",
                                   brief(100 * law.first_order.largest_residual, 2)));
    }
    if (laws.empty()) return {};
    return {fmt::format("With m patches along an edge the row sums of deterministic methods miss 1 by c/m: c = {}.",
                        fmt::join(laws, ", "))};
}

}  // namespace

std::vector<std::string> results_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> all;
    for (const auto& lines : {occlusion_in_brief(results), heavy_tails_in_brief(results), slopes_in_brief(results),
                              reductions_in_brief(results), coverage_in_brief(results), until_in_brief(results),
                              error_laws_in_brief(results)})
        all.insert(all.end(), lines.begin(), lines.end());
    return all;
}

}  // namespace ff::reports
