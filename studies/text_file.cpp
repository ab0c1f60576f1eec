#include "studies/text_file.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace ff::studies {
namespace {

void expect_utf8(const std::string& text, const std::filesystem::path& file) {
    using Utf8 = boost::locale::utf::utf_traits<char>;
    for (auto at = text.begin(); at != text.end();) {
        const auto start = at;
        const auto code = Utf8::decode(at, text.end());
        if (code != boost::locale::utf::illegal && code != boost::locale::utf::incomplete) continue;
        const auto line = std::find(std::reverse_iterator(start), text.rend(), '\n').base();
        throw UserError(
            fmt::format("{}:{}:{}: the byte 0x{:02x} is not UTF-8 (no other encoding is read). Save the "
                        "file as UTF-8.",
                        file.string(), 1 + std::count(text.begin(), start, '\n'), 1 + (start - line),
                        static_cast<unsigned char>(*start)));
    }
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    // Writing the buffer of an empty file would set an error.
    if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
    if (in.fail() || !text) {
        const int error = errno;
        throw IoError(fmt::format("{}: cannot be read ({}). Check the name and the permissions.", file.string(),
                                  error == 0 ? "input error" : std::generic_category().message(error)));
    }
    expect_utf8(text.str(), file);
    return text.str();
}

}  // namespace ff::studies
