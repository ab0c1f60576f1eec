#pragma once

#include "reports/templates/templates.hpp"
#include "studies/spec/spec.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

// Files that come with the program: they lie beside it when installed, else in its source and build tree.

/// A study file that comes with the program.
struct BuiltInStudy {
    std::string name;
    std::string title;
    std::filesystem::path file;
};

/// Built-in studies, by name.
std::vector<BuiltInStudy> built_in_studies();

/// The file of a built-in study by name, or a file by path.
/// @throws UserError with the nearest name where there is neither
std::filesystem::path find_study(const std::string& name_or_file);

/// A term of the glossary.
struct Term {
    std::string name;
    std::string meaning;
};

/// The terms of docs/glossary.md.
std::vector<Term> glossary();

/// The templates that come with the program; those of `own` take precedence.
/// @param own  the user's folder; empty: none
/// @throws IoError where a folder cannot be read
reports::Templates find_templates(const std::filesystem::path& own);

/// A file among the templates of the program; empty where there is none.
std::filesystem::path find_template_file(std::string_view name);

}  // namespace ff::app
