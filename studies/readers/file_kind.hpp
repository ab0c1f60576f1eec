#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

/// Files that commands take.
enum class FileKind {
    study,
    bands,
    scene,
    tables,
    baseline,
    estimates,
    result_store,
    form_factor_store,
    kept_rows,
    materials,
    points,
};

/// The kind of a file, recognised by lines that only this kind has; empty where no line is typical.
std::optional<FileKind> kind_of(std::string_view bytes);

/// "a scene file"
std::string_view name_of(FileKind kind);

/// The kind of a file that no command accepts, by its first bytes: "a PNG picture". Empty where they do not tell.
std::string_view name_of_foreign(std::string_view bytes);

/// The command that takes the file: "ffstudy form-factors FILE"
std::string command_for(FileKind kind, const std::filesystem::path& file);

/// @throws UserError where the bytes are recognised as a kind other than the expected one, with the command that takes
///   them. Unrecognised bytes are left to the parser of the expected kind.
void expect_kind(FileKind wanted, std::string_view bytes, const std::filesystem::path& file);

}  // namespace ff::studies
