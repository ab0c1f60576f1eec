#pragma once

#include "stats/convergence/line_fit.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/published/published.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// How the closure error of a deterministic method falls with subdivision: mean row sum - 1 at m patches along an edge.
struct ErrorLaw {
    std::string method;
    bool published = false;  ///< fitted to printed row sums instead of this study's
    std::vector<double> m;
    std::vector<double> closure_errors;
    stats::PowerLaw first_order;          ///< c / m
    std::optional<stats::PowerLaw> free;  ///< c / m^p, both fitted

    /// Whether no error is further from c / m than this share of it.
    static constexpr double most_misfit = 0.2;
    [[nodiscard]] bool holds() const { return first_order.largest_residual <= most_misfit; }
};

/// One law for each deterministic method with at least two subdivisions of a closed scene, then those of the
/// publication. Methods without error (closed_form) have none.
std::vector<ErrorLaw> fit_error_laws(const Analysis& findings, const PublishedTables* tables);

}  // namespace ff::studies
