#pragma once

#include "reports/words/answer.hpp"
#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A key number, with its meaning.
struct KeyNumber {
    std::string value;
    std::string label;   ///< a few words
    std::string detail;  ///< a sentence on certainty and evidence
};

/// The result of a study for a reader with a minute.
struct Headline {
    Subject subject = Subject::errors;
    std::string question;  ///< empty where the title asks it
    std::string verdict;   ///< the answer
    std::vector<KeyNumber> numbers;
    std::vector<std::string> published;  ///< contradictions in a publication's figures, a sentence each, worst first
    std::string unlikely;                ///< figures of the publication that a run as described does not give
};

Headline headline(const studies::StudyResults& results);

}  // namespace ff::reports
