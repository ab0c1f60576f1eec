#include "studies/point_files/content.hpp"

#include "core/points/stream.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace ff::studies {

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code status;
    if (std::filesystem::exists(file, status) && !std::filesystem::is_regular_file(file, status))
        throw IoError(fmt::format("{}: not a file (points are read from files). Check the name.", file.string()));
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
    if (in.fail() || !bytes) {
        const int error = errno;
        throw IoError(fmt::format("{}: cannot be read ({}). Check the name and the permissions.", file.string(),
                                  error == 0 ? "input error" : std::generic_category().message(error)));
    }
    return std::move(bytes).str();
}

std::string hash_of(const samplers::AddedSampler::Content& content) {
    std::string all;
    for (const auto& [name, bytes] : content) {
        const StreamKey part = derive_key(Seed{bytes.size()}, bytes);
        all += fmt::format("{:08x}{:08x}", part.word0, part.word1);
    }
    if (content.size() == 1) return all;
    const StreamKey whole = derive_key(Seed{content.size()}, all);
    return fmt::format("{:08x}{:08x}", whole.word0, whole.word1);
}

bool is_hash(std::string_view text) {
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace ff::studies
