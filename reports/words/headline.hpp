#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A number to remember, with what it is.
struct KeyNumber {
    std::string value;
    std::string label;   ///< a few words
    std::string detail;  ///< a sentence: how sure, and what it rests on
};

/// The result of a study for someone with a minute.
struct Headline {
    std::string verdict;  ///< one sentence
    std::vector<KeyNumber> numbers;
    std::vector<std::string> published;  ///< what the publication got wrong, a sentence each, worst first
};

Headline headline(const studies::StudyResults& results);

}  // namespace ff::reports
