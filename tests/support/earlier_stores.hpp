#pragma once

namespace ff::test {

/// SQL that turns a file into version 1 of its format, which had no checksums, so that later changes are judged without
/// them.
inline constexpr const char* store_as_version_1 =
    "UPDATE meta SET value = '1' WHERE key = 'schema_version'; DELETE FROM meta WHERE key = 'checksum'; "
    "DELETE FROM context WHERE key = 'checksum'; ALTER TABLE units DROP COLUMN checksum";
inline constexpr const char* form_factors_as_version_1 =
    "UPDATE about SET value = 1 WHERE key = 'schema_version'; DELETE FROM about WHERE key = 'checksum'";

}  // namespace ff::test
