#pragma once

#include "studies/spec/spec.hpp"

#include <string>

namespace ff::reports {

/// A study file for readers. Of a scene's text of more than 60 lines it shows the first 20, and says how many follow.
struct StudyText {
    std::string text;
    bool whole = true;  ///< it can be run as it is
};

StudyText study_text(studies::StudySpec spec);

/// Where all of it is, when it is not whole.
inline constexpr const char* whole_study_is_kept =
    "Long texts of scenes are cut short here; results.sqlite holds all of them: sqlite3 results.sqlite \"SELECT value "
    "FROM meta WHERE key = 'study'\" prints the study as a file to run.";

}  // namespace ff::reports
