#pragma once

#include "studies/spec/spec.hpp"

#include <string>
#include <vector>

namespace ff::studies {

/// A key of the study file that differs.
struct SpecDifference {
    std::string place;  ///< "study", or the name of a method
    std::string key;
    std::string first;  ///< as in a study file; empty where it is not there
    std::string second;
};

/// What the study files of two runs say differently; seeds and numbers of trials included, sizes left out.
std::vector<SpecDifference> differences_of(const StudySpec& first, const StudySpec& second);

}  // namespace ff::studies
