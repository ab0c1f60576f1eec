#pragma once

#include "core/support/repeatable.hpp"

namespace ff::python {

/// How messages speak of Python functions whose results do not repeat.
inline constexpr OutsideWords words_of_functions{"returns", "seed", "give it the option \"randomised\": False"};

}  // namespace ff::python
