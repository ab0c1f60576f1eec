#include "studies/point_files/content.hpp"

#include "core/points/stream.hpp"
#include "core/support/error.hpp"
#include "studies/readers/text_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace ff::studies {

std::string read_regular_file(const std::filesystem::path& file) {
    std::error_code status;
    if (std::filesystem::exists(file, status) && !std::filesystem::is_regular_file(file, status))
        throw IoError(fmt::format("{}: not a file (points are read from files). Check the name.", file.string()));
    return read_bytes(file);
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
