#include "studies/readers/text_file.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace ff::studies {
namespace {

struct Words {
    std::string_view name;
    std::string_view command;  ///< command that takes such a file; {} stands for the file
};
constexpr std::array words_of_kinds{
    Words{"a study file", "ffstudy run {}"},
    Words{"a bands file", "ffstudy check {}"},
    Words{"a scene file", "ffstudy form-factors {}"},
    Words{"a tables file", "ffstudy audit {}"},
    Words{"a baseline", "ffstudy check BANDS.toml --baseline {}"},
    Words{"a file of estimates", "ffstudy check BANDS.toml --estimates {}"},
    Words{"a result store", "ffstudy report {}"},
    Words{"a store of form factors", "ffstudy form-factors --load {}"},
    Words{"a file of sampled rows", "ffstudy merge {} --out DIR"},
    Words{"a materials file", "ffstudy heat SCENE --materials {}"},
    Words{"a file of points", "ffstudy convergence --sampler file:{}"},
};

const Words& words_of(FileKind kind) {
    return words_of_kinds.at(static_cast<std::size_t>(kind));
}

/// Kinds for which evidence was seen.
using Marks = std::set<FileKind>;

constexpr std::array<std::pair<std::string_view, FileKind>, 6> headings{{{"[study]", FileKind::study},
                                                                         {"[[method]]", FileKind::study},
                                                                         {"[gates]", FileKind::bands},
                                                                         {"[[gate]]", FileKind::bands},
                                                                         {"[[surface]]", FileKind::scene},
                                                                         {"[materials]", FileKind::materials}}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> beginnings_of_foreign{
    {{"\x89PNG", "a PNG picture"},
     {"\xff\xd8\xff", "a JPEG picture"},
     {"%PDF", "a PDF document"},
     {"PK\x03\x04", "a ZIP archive (as .npz is)"},
     {"\x1f\x8b", "compressed by gzip"},
     {"\xfd\x37zXZ", "compressed by xz"},
     {"\x7f\x45LF", "a program or a library"},
     {"SQLite format 3", "a SQLite database"}}};

/// A vertex, a face or a surface of OBJ and View3D.
bool begins_geometry(const std::vector<std::string_view>& words) {
    constexpr std::array<std::string_view, 4> first{"v", "V", "f", "S"};
    return words.size() >= 4 && std::find(first.begin(), first.end(), words[0]) != first.end() &&
           std::all_of(words.begin() + 2, words.begin() + 4, [](std::string_view word) {
               return word.find_first_not_of("+-.0123456789eE/") == std::string_view::npos;
           });
}

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

void mark_json(std::string_view text, Marks& marks) {
    if (has(text, "\"ffstudy.baseline/")) marks.insert(FileKind::baseline);
    if (has(text, "\"tables\"") && has(text, "\"methods\"")) marks.insert(FileKind::tables);
}

void mark_store(std::string_view bytes, Marks& marks) {
    if (has(bytes, "CREATE TABLE meta(")) marks.insert(FileKind::result_store);
    if (has(bytes, "CREATE TABLE about(")) marks.insert(FileKind::form_factor_store);
    if (has(bytes, "CREATE TABLE rows(face")) marks.insert(FileKind::kept_rows);
}

/// The header of a table of estimates: trials, means, hits, counts or shares of quantities.
bool is_table_header(std::string_view line) {
    constexpr std::array<std::string_view, 5> values{"estimate", "mean", "count", "share", "hits"};
    return !has(line, "=") && has(line, "quantity") && has(line, ",") &&
           std::ranges::any_of(values, [&](std::string_view value) { return has(line, value); });
}

void mark_lines(std::string_view text, Marks& marks) {
    bool is_first = true;
    for_each_line(text, [&](std::uint64_t, std::string_view line) {
        const auto words = split_words(line);
        if (words.empty() || words[0].front() == '#' || words[0].front() == '!') return;
        const bool heads = std::exchange(is_first, false);
        for (const auto& [heading, kind] : headings) {
            if (words[0] == heading) marks.insert(kind);
        }
        if (begins_geometry(words)) marks.insert(FileKind::scene);
        if (heads && is_table_header(line)) marks.insert(FileKind::estimates);
        if (heads && words[0] == "solid") marks.insert(FileKind::scene);
    });
}

Marks marks_of(std::string_view bytes) {
    Marks marks;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (bytes.starts_with("\x93NUMPY") || bytes.starts_with("FFPOINTS")) {
        marks.insert(FileKind::points);
    } else if (bytes.starts_with("SQLite format 3")) {
        mark_store(bytes, marks);
    } else if (first != std::string_view::npos && bytes[first] == '{') {
        mark_json(bytes, marks);
    } else {
        mark_lines(bytes, marks);
    }
    return marks;
}

/// The kind of a file that no command accepts, by its first bytes: "a PNG picture". Empty where they do not tell.
std::string_view name_of_foreign(std::string_view bytes) {
    for (const auto& [magic, name] : beginnings_of_foreign) {
        if (bytes.starts_with(magic)) return name;
    }
    return {};
}

void expect_utf8(std::string_view text, const std::filesystem::path& file, FileKind wanted) {
    const std::size_t at = std::min(find_no_utf8(text), text.find('\0'));
    if (at == std::string_view::npos) return;
    if (const auto foreign = name_of_foreign(text); !foreign.empty())
        throw UserError("{}: {} (expected {}). Check the name.", file.string(), foreign, name_of(wanted));
    const std::string_view before = text.substr(0, at);
    throw UserError("{}:{}:{}: the byte 0x{:02x} is not {} (no other encoding is read). Save the file as UTF-8.",
                    file.string(), 1 + std::count(before.begin(), before.end(), '\n'),
                    before.size() - (before.rfind('\n') + 1) + 1, static_cast<unsigned char>(text[at]),
                    text[at] == '\0' ? "text" : "UTF-8");
}

}  // namespace

std::optional<FileKind> kind_of(std::string_view bytes) {
    const Marks marks = marks_of(bytes);
    return marks.empty() ? std::nullopt : std::optional(*marks.begin());
}

std::string_view name_of(FileKind kind) {
    return words_of(kind).name;
}

std::string command_for(FileKind kind, const std::filesystem::path& file) {
    return fmt::format(fmt::runtime(words_of(kind).command), file.string());
}

void expect_kind(FileKind wanted, std::string_view bytes, const std::filesystem::path& file) {
    // Millions of lines need not be looked at to know the header of a table.
    if (wanted == FileKind::estimates && is_table_header(bytes.substr(0, bytes.find('\n')))) return;
    if (marks_of(bytes).contains(wanted)) return;
    auto kind = kind_of(bytes);
    if (!kind && file.extension() == ".csv") kind = FileKind::estimates;  // whatever its columns and separators
    if (!kind || kind == wanted) return;
    throw UserError("{}: {} (expected {}). Run '{}'.", file.string(), name_of(*kind), name_of(wanted),
                    command_for(*kind, file));
}

std::string read_bytes(const std::filesystem::path& file) {
    if (std::error_code unknown; std::filesystem::is_directory(file, unknown))
        throw IoError("{}: a folder, not a file. Check the name.", file.string());
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    // Writing the buffer of an empty file would set an error.
    if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
    if (in.fail() || !bytes) {
        const int error = errno;
        throw IoError("{}: cannot be read ({}). Check the name and the permissions.", file.string(),
                      error == 0 ? "input error" : std::generic_category().message(error));
    }
    return std::move(bytes).str();
}

std::string with_line_feeds(std::string bytes) {
    if (bytes.find('\n') == std::string::npos && bytes.find('\0') == std::string::npos)
        std::replace(bytes.begin(), bytes.end(), '\r', '\n');
    return bytes;
}

std::string read_text_file(const std::filesystem::path& file, FileKind wanted) {
    return checked_text(read_bytes(file), file, wanted);
}

std::string checked_text(std::string bytes, const std::filesystem::path& file, FileKind wanted) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (bytes.starts_with(byte_order_mark)) bytes.erase(0, byte_order_mark.size());
    bytes = with_line_feeds(std::move(bytes));
    expect_kind(wanted, bytes, file);
    expect_utf8(bytes, file, wanted);
    return bytes;
}

}  // namespace ff::studies
