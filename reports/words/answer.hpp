#pragma once

#include "reports/words/findings/standing.hpp"
#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// The topic of a study, judged by its findings: the first that applies.
enum class Subject {
    light,           ///< errors of radiosity solutions
    occlusion,       ///< error against the occluded fraction
    coverage,        ///< how often intervals contain the exact value
    publication,     ///< methods against the figures of a publication
    choice,          ///< which method to take on each kind of pairs, over many scenes
    configurations,  ///< estimates against the exact values of the catalogue
    rates,           ///< how fast errors fall
    variances,       ///< variances against those of random points
    errors,          ///< errors of methods at the same size
};

/// The main finding of a study on its subject. The answer says it, and the picture beside the answer shows it.
struct MainFinding {
    Subject subject = Subject::errors;
    std::string question = {};
    std::vector<std::string> clauses = {};               ///< the answer, in a few words each
    std::vector<std::vector<std::string>> shorter = {};  ///< the same in fewer words, and in fewer still
    std::vector<std::string> caveats = {};               ///< sentences that belong to the answer
    std::vector<std::string> details = {};  ///< sentences that say more, where nothing else in the reports does
    std::vector<Ranking> rankings = {};     ///< empty where the subject has pictures of its own
    std::string title = {};                 ///< title of the rankings; the next members are theirs, too
    std::string axis = {};                  ///< what the values are
    std::string note = {};                  ///< what else is drawn
    bool logarithmic = false;               ///< whether the axis is logarithmic
};
MainFinding main_finding(const studies::StudyResults& results);

/// Question and answer for a reader with a minute.
struct Answer {
    std::string question;  ///< empty where the study's title asks it
    std::string text;      ///< a sentence or two of at most 35 words, if one clause has so few
    MainFinding finding;   ///< what the text says
};
Answer answer(const studies::StudyResults& results);

}  // namespace ff::reports
