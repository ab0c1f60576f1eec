#pragma once

#include <string_view>

namespace ff::studies {

/// Why a title cannot stand in reports; empty where it can.
std::string_view problem_with_title(std::string_view title);

/// Why a name cannot stand in tables and file names; empty where it can.
std::string_view problem_with_name(std::string_view name);

}  // namespace ff::studies
