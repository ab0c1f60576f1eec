#pragma once

#include "app/folders/output_folder.hpp"

#include "studies/plan/plan.hpp"

#include <filesystem>
#include <string>

namespace ff::app {

/// Where a folder has the store of another study, a store of this one replaces it and begins with the trials that both
/// share. An old store with other trials is kept beside it.
/// @param replace  whether trials that are not part of this study may be set aside
/// @return what is reused, in words; empty where the folder has no other study
/// @throws UserError where trials would have to be set aside but may not; IoError
std::string grow_study(OutputFolder& folder, const studies::StudyPlan& plan, bool replace, unsigned threads);

/// Says in the same words what would be reused, without doing anything.
std::string describe_growth(const std::filesystem::path& folder, const studies::StudyPlan& plan);

}  // namespace ff::app
