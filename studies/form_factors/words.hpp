#pragma once

#include "studies/form_factors/form_factors.hpp"

#include <string_view>

namespace ff::studies::form_factors {

/// The most expensive method that a pair of faces took; "bounds" where there was no time for one.
std::string_view method_of(const FaceExchange& exchange);

/// The reason for that method.
std::string_view reason_of(const FaceExchange& exchange);

/// The inverse: sets the method and the reason of an exchange from these words. @return false for unknown words
bool set_method(FaceExchange& exchange, std::string_view method, std::string_view reason);

}  // namespace ff::studies::form_factors
