#pragma once

#include "studies/readers/digest.hpp"
#include "studies/store/sqlite.hpp"

#include <string_view>

namespace ff::studies {

/// Adds all columns of all rows of a query, with their types.
void add_rows(Digest& digest, const Database& database, std::string_view sql);

}  // namespace ff::studies
