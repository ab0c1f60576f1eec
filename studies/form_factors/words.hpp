#pragma once

#include "studies/form_factors/form_factors.hpp"

#include <string_view>

namespace ff::studies {

/// The most expensive method that a pair of faces took; "bounds" where there was no time for any.
std::string_view method_of(const FaceExchange& exchange);

/// Why that one.
std::string_view reason_of(const FaceExchange& exchange);

/// The same backwards: gives an exchange the method and the reason of these words. @return false for unknown words
bool set_method(FaceExchange& exchange, std::string_view method, std::string_view reason);

}  // namespace ff::studies
