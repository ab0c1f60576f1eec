#include "studies/spec/sample_sizes.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "samplers/support/sizes.hpp"

#include <algorithm>
#include <optional>
#include <unordered_set>

namespace ff::studies {
namespace {

std::optional<std::uint64_t> whole_number(std::string_view text) {
    const auto value = parse_bare_number<std::uint64_t>(text);
    if (!value) return std::nullopt;
    return std::min(*value, samplers::max_points + 1);  // beyond it all are alike: too many
}

/// "1000" or "5^4".
std::uint64_t read_count(std::string_view text) {
    const std::size_t hat = text.find('^');
    const auto base = whole_number(text.substr(0, hat));
    const auto exponent =
        hat == std::string_view::npos ? std::optional<std::uint64_t>(1) : whole_number(text.substr(hat + 1));
    if (!base || !exponent) {
        throw UserError("('{}' is not a number of points). Write 1000, 5^4, or a range 2^6..2^16.", excerpt(text));
    }
    std::uint64_t value = std::min<std::uint64_t>(*base, 1);
    if (*base > 1) {
        for (std::uint64_t i = 0; i < *exponent && value <= samplers::max_points; ++i) value *= *base;
    }
    if (value == 0 || value > samplers::max_points) {
        throw UserError("('{}' is not between 1 and 2^32 points). Take more trials instead.", excerpt(text));
    }
    return value;
}

std::vector<std::uint64_t> read_part(std::string_view text, const samplers::SamplerInfo& sampler,
                                     std::size_t dimension) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return {read_count(text)};
    const std::uint64_t low = read_count(trimmed(text.substr(0, dots)));
    const std::uint64_t high = read_count(trimmed(text.substr(dots + 2)));
    if (low > high) throw UserError("(the range ends before it begins). Write the smaller number first.");
    auto sizes = samplers::size_ladder(sampler, low, high, dimension);
    if (sizes.empty()) {
        throw UserError("(no size that {} is made for lies in this range). Widen it, e.g. 2^6..2^16.", sampler.name);
    }
    return sizes;
}

}  // namespace

std::vector<std::uint64_t> read_sample_sizes(std::string_view text, const samplers::SamplerInfo& sampler,
                                             std::size_t dimension) {
    std::vector<std::uint64_t> sizes;
    std::unordered_set<std::uint64_t> seen;
    for (const std::string_view part : split_at(',', text)) {
        for (const std::uint64_t size : read_part(trimmed(part), sampler, dimension)) {
            if (seen.insert(size).second) sizes.push_back(size);
        }
    }
    return sizes;
}

}  // namespace ff::studies
