#pragma once

#include "studies/form_factors/form_factors.hpp"

#include <string_view>

namespace ff::reports {

/// The dearest method that a pair of faces took; "bounds" where there was no time for any.
std::string_view method_of(const studies::FacePair& pair, const studies::FaceExchange& exchange);

/// Why that one.
std::string_view reason_of(const studies::FacePair& pair, const studies::FaceExchange& exchange);

/// The larger half of a pair's interval, as a form factor of its smaller face.
double worst_half_width(const studies::FormFactorMatrix& matrix, std::size_t pair);

}  // namespace ff::reports
