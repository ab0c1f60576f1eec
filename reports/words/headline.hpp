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
    std::string question;  ///< empty where the title asks it
    std::string verdict;   ///< the answer
    std::vector<KeyNumber> numbers;
    std::vector<std::string>
        published;         ///< the contradictions in a publication's figures, a sentence each, worst first
    std::string unlikely;  ///< which of its figures a run as described does not give
};

Headline headline(const studies::StudyResults& results);

}  // namespace ff::reports
