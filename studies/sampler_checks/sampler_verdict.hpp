#pragma once

#include <string>

namespace ff::studies {

enum class SamplerVerdict { pass, fail, inconclusive, note };

/// One requirement on a sampler, or one thing that its points show.
struct SamplerCheck {
    std::string name;
    SamplerVerdict verdict = SamplerVerdict::pass;
    std::string found;
};

}  // namespace ff::studies
