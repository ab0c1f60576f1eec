#pragma once

#include "core/estimators/estimator.hpp"
#include "samplers/sampler.hpp"
#include "studies/spec/spec.hpp"

namespace ff::studies {

/// The sampler of a [[method]] table, found or read; null where its estimator takes none.
/// @throws UserError with the place
const samplers::SamplerInfo* read_sampler(const TomlReader& reader, const EstimatorInfo& estimator);

}  // namespace ff::studies
