#pragma once

#include <cstdint>
#include <string_view>

namespace ff::studies::meshes {

/// Looks for what the library that reads other meshes does not: whether a PLY or OFF file can hold as many elements as
/// its header counts, for which room would be made before any is read, and whether an STL file in text has its end.
/// @param beginning  of the file, with the header  @param size  of the file, in bytes
/// @throws UserError "file: problem (why). Suggestion."
void expect_whole(std::string_view file, std::string_view beginning, std::uint64_t size);

}  // namespace ff::studies::meshes
