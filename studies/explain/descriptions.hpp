#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A description for `ffstudy list` and `ffstudy explain`.
struct Description {
    std::string_view name;
    std::string_view summary;
    std::string_view details;
    std::string_view reference;  ///< key of docs/references.md
};

/// The choices of a study file besides samplers.
struct Choices {
    std::string_view kind;    ///< "estimator"
    std::string_view plural;  ///< "estimators"
    std::span<const Description> descriptions;
};

/// Estimators, scenes, and the values of a method's keys `completion`, `allocation`, `map` and `tracer`.
std::span<const Choices> all_choices();

/// Something that is broken on purpose and can be named in study and bands files, so that checks can be shown to catch
/// it.
struct Control {
    std::string_view kind;  ///< "sampler", "tracer" or "combination"
    Description description;
};

/// All controls. None of them is in an ordinary listing.
std::vector<Control> controls();

}  // namespace ff::studies
