#pragma once

#include <cstdint>
#include <filesystem>

namespace ff::studies {

/// How SQLite makes transactions atomic. A write-ahead log is faster but needs memory shared between processes, which
/// network file systems do not offer; a fully synchronised rollback journal works everywhere.
enum class Journal { write_ahead, rollback };

/// By the type that statfs(2) names: a rollback journal on network and user-space file systems.
Journal journal_for(std::uint64_t file_system_type);

/// For files in this folder. @throws IoError where the system does not tell
Journal journal_in(const std::filesystem::path& folder);

}  // namespace ff::studies
