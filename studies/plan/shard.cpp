#include "studies/plan/shard.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace ff::studies {
namespace {

std::optional<std::uint64_t> whole_number(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

Shard parse_shard(std::string_view text) {
    const auto slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto index = whole_number(text.substr(0, slash));
        const auto count = whole_number(text.substr(slash + 1));
        if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
    }
    throw UserError(
        fmt::format("--shard {}: not a share (i/n with 1 <= i <= n is one). For the second of four write 2/4.", text));
}

}  // namespace ff::studies
