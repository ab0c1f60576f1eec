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

/// The command that takes the file: "ffstudy form-factors FILE"
std::string command_for(FileKind kind, const std::filesystem::path& file);

/// @throws UserError where the bytes are recognised as a kind other than the expected one, with the command that takes
///   them. Unrecognised bytes are left to the parser of the expected kind.
void expect_kind(FileKind wanted, std::string_view bytes, const std::filesystem::path& file);

/// The bytes with line feeds, where they are a text whose lines end with carriage returns alone, as in old programs.
std::string with_line_feeds(std::string bytes);

/// All bytes of a file. @throws IoError where it cannot be read
std::string read_bytes(const std::filesystem::path& file);

/// The text of a file of that kind, without a byte order mark.
/// @throws UserError where it is a file of another kind, or not UTF-8; IoError where it cannot be read
std::string read_text_file(const std::filesystem::path& file, FileKind wanted);
/// The same, of bytes that were read from it.
std::string checked_text(std::string bytes, const std::filesystem::path& file, FileKind wanted);

}  // namespace ff::studies
