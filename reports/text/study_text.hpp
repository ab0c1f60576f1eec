#pragma once

#include "studies/spec/spec.hpp"

#include <string>

namespace ff::reports {

/// A study file for readers. Of a scene's text of more than 60 lines only the first 20 are shown.
struct StudyText {
    std::string text;
    bool whole = true;  ///< false if shortened; then it cannot be run
};

StudyText study_text(studies::StudySpec spec);

/// Where to find the whole text of a shortened one.
inline constexpr const char* whole_study_is_kept =
    "Long texts of scenes are cut short here; results.sqlite holds all of them: sqlite3 results.sqlite \"SELECT value "
    "FROM meta WHERE key = 'study'\" prints the study as a file to run.";

}  // namespace ff::reports
