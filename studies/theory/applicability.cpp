#include "studies/theory/applicability.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

namespace ff::studies {

void expect_applicable(const Method& method, const Scene& scene) {
    const std::string refusal = find_estimator(method.estimator).refusal(estimator_options(method), scene);
    if (!refusal.empty()) throw UserError(fmt::format("method '{}': {}", method.name, refusal));
}

}  // namespace ff::studies
