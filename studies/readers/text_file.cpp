#include "studies/readers/text_file.hpp"

#include "core/support/error.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace ff::studies {
namespace {

void expect_utf8(std::string_view text, const std::filesystem::path& file, FileKind wanted) {
    const std::size_t at = std::min(find_no_utf8(text), text.find('\0'));
    if (at == std::string_view::npos) return;
    if (const auto foreign = name_of_foreign(text); !foreign.empty())
        throw UserError(fmt::format("{}: {} (expected {}). Check the name.", file.string(), foreign, name_of(wanted)));
    const std::string_view before = text.substr(0, at);
    throw UserError(fmt::format(
        "{}:{}:{}: the byte 0x{:02x} is not {} (no other encoding is read). Save the file as UTF-8.", file.string(),
        1 + std::count(before.begin(), before.end(), '\n'), before.size() - (before.rfind('\n') + 1) + 1,
        static_cast<unsigned char>(text[at]), text[at] == '\0' ? "text" : "UTF-8"));
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    // Writing the buffer of an empty file would set an error.
    if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
    if (in.fail() || !bytes) {
        const int error = errno;
        throw IoError(fmt::format("{}: cannot be read ({}). Check the name and the permissions.", file.string(),
                                  error == 0 ? "input error" : std::generic_category().message(error)));
    }
    return std::move(bytes).str();
}

std::string read_text_file(const std::filesystem::path& file, FileKind wanted) {
    return checked_text(read_bytes(file), file, wanted);
}

std::string checked_text(std::string bytes, const std::filesystem::path& file, FileKind wanted) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (bytes.starts_with(byte_order_mark)) bytes.erase(0, byte_order_mark.size());
    expect_kind(wanted, bytes, file);
    expect_utf8(bytes, file, wanted);
    return bytes;
}

}  // namespace ff::studies
