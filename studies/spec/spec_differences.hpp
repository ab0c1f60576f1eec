#pragma once

#include "studies/spec/spec.hpp"

#include <string>
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

}  // namespace ff::studies
