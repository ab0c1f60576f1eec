#pragma once

#include "studies/explain/descriptions.hpp"

#include <string_view>
#include <vector>

namespace ff::studies {

/// Something that is broken on purpose and can be named in study and bands files, so that checks can be shown to catch
/// it.
struct Control {
    std::string_view kind;  ///< "sampler", "tracer" or "combination"
    Description description;
};

/// All controls. None of them is in an ordinary listing.
std::vector<Control> controls();

}  // namespace ff::studies
