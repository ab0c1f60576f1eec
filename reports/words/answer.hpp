#pragma once

#include "reports/words/main_finding.hpp"
#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// Question and answer for a reader with a minute.
struct Answer {
    std::string question;  ///< empty where the study's title asks it
    std::string text;      ///< a sentence or a few; begins with a capital, and ends with a full stop
    MainFinding finding;   ///< what the text says
};
Answer answer(const studies::StudyResults& results);

}  // namespace ff::reports
