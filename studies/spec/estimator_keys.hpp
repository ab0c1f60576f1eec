#pragma once

#include "core/estimators/estimator.hpp"
#include "studies/readers/toml_reader.hpp"

namespace ff::studies {

/// The estimator that a method names.
/// @throws UserError where there is no such estimator
const EstimatorInfo& read_estimator(const TomlReader& reader);

/// Keys of a method that only some estimators have.
/// @throws UserError where this estimator does not have a key
void refuse_keys_of_others(const TomlReader& reader, const EstimatorInfo& estimator);

}  // namespace ff::studies
