#pragma once

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
Subject subject_of(const studies::StudyResults& results);

/// Question and answer for a reader with a minute.
struct Answer {
    std::string question;  ///< empty where the study's title asks it
    std::string text;      ///< a sentence or a few; begins with a capital, and ends with a full stop
};
Answer answer(const studies::StudyResults& results);

/// "a, b and c"; with more than `most` names, the first ones and the number of others. Names with commas are quoted.
std::string listed(std::vector<std::string> names, std::size_t most = 4);

/// "adjacent pairs", "possibly occluded adjacent pairs"
std::string kind_of_pairs(PairClass pair_class, bool may_be_occluded);

/// The pairs of a class in words: "on parallel pairs", "on parallel pairs of cube".
std::string on_pairs(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class);

}  // namespace ff::reports
