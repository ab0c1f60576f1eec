#include "studies/plan/shard.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

namespace ff::studies {

Shard parse_shard(std::string_view text) {
    const auto slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto index = parse_bare_number<std::uint64_t>(text.substr(0, slash));
        const auto count = parse_bare_number<std::uint64_t>(text.substr(slash + 1));
        if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
    }
    throw UserError(
        fmt::format("--shard {}: not a share (i/n with 1 <= i <= n is one). For the second of four write 2/4.", text));
}

}  // namespace ff::studies
