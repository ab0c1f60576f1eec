#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

/// Files that commands take.
enum class FileKind { study, bands, scene, tables, baseline, estimates, result_store, form_factor_store, materials };

/// What kind of file these bytes are, by the lines that only that kind has; empty where no line tells.
std::optional<FileKind> kind_of(std::string_view bytes);

/// "a scene file"
std::string_view name_of(FileKind kind);

/// The command that takes the file: "ffstudy form_factors FILE"
std::string command_for(FileKind kind, const std::filesystem::path& file);

/// @throws UserError where the bytes are of another kind than is wanted, with the command that takes them. What has
///   no mark of any kind is left to the parser of the kind that is wanted.
void expect_kind(FileKind wanted, std::string_view bytes, const std::filesystem::path& file);

}  // namespace ff::studies
