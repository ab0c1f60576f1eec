#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/spec/spec.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A key of the study file that differs.
struct SpecDifference {
    std::string place;  ///< "study", or the name of a method
    std::string key;
    std::string first;  ///< as in a study file; empty where absent
    std::string second;
};

/// Differences between the study files of two runs, including seeds and numbers of trials, but not sizes.
std::vector<SpecDifference> differences_of(const StudySpec& first, const StudySpec& second);

/// The first section and key in which two studies, both written by `to_toml`, differ, and the number of other differing
/// keys: "[study]: 'seed = 1' there, 'seed = 2' here". Methods are matched by name. Empty where the texts are equal.
std::string first_difference(std::string_view stored, std::string_view wanted);

/// How the faces of two scenes differ, in words, whatever stands between the faces: "2 in the first and 4 in the
/// second". Empty where the faces are the same.
std::string difference_of_faces(const Scene& a, const Scene& b);

}  // namespace ff::studies
