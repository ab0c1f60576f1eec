#pragma once

#include <span>
#include <string_view>

namespace ff::studies {

/// What something is, for `ffstudy list` and `ffstudy explain`.
struct Description {
    std::string_view name;
    std::string_view summary;
    std::string_view details;
    std::string_view reference;  ///< key of docs/references.md
};

std::span<const Description> estimator_descriptions();
std::span<const Description> scene_descriptions();

}  // namespace ff::studies
