#pragma once

#include "app/folders/output_folder.hpp"

#include "studies/plan/plan.hpp"

#include <filesystem>
#include <string>

namespace ff::app {

/// Where a folder holds the store of another study, a store of this one takes its place, and begins with the trials
/// that both have in common. An old store with other trials is kept beside it.
/// @param replace  whether trials that are none of this study may be put aside
/// @return what is reused, in words; empty where the folder has no other study
/// @throws UserError where trials would be put aside that may not; IoError
std::string grow_study(OutputFolder& folder, const studies::StudyPlan& plan, bool replace, unsigned threads);

/// The same in words of what would be done; nothing is.
std::string describe_growth(const std::filesystem::path& folder, const studies::StudyPlan& plan);

}  // namespace ff::app
