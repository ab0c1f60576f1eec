#pragma once

#include "studies/spec/spec.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ff::app {

/// A study file that comes with the program.
struct BuiltInStudy {
    std::string name;
    std::string title;
    std::filesystem::path file;
};

/// Their folder: beside the installed program, or in the source tree when it runs from its build.
std::filesystem::path studies_folder();

/// Built-in studies, by name.
std::vector<BuiltInStudy> built_in_studies();

/// The file of a built-in study by name, or a file by path.
/// @throws UserError with the nearest name where there is neither
std::filesystem::path find_study(const std::string& name_or_file);

}  // namespace ff::app
