#include "stats/basics/resampling.hpp"

#include "core/support/contract.hpp"

#include <cmath>
#include <numeric>

namespace ff::stats {

Draws::Draws(StreamKey key, Resampling use, std::uint32_t replicate)
    : stream_{.key = key, .trial = replicate, .source = static_cast<std::uint32_t>(use), .target = 0} {}

std::uint32_t Draws::word() {
    if (used_ == words_.size()) {
        words_ = philox(stream_, block_++, Purpose::permutation);
        used_ = 0;
    }
    return words_[used_++];
}

double Draws::uniform() {
    const std::uint64_t high = word();
    const std::uint64_t low = word();
    return static_cast<double>((high << 32 | low) >> 11) * 0x1p-53;
}

std::size_t Draws::below(std::size_t n) {
    FF_EXPECT(1 <= n && n < (std::uint64_t{1} << 32));
    // Lemire: the high half of word * n is uniform once the few low halves that would favour some results are rejected.
    std::uint64_t product = std::uint64_t{word()} * n;
    const auto range = static_cast<std::uint32_t>(n);
    if (static_cast<std::uint32_t>(product) < range) {
        const std::uint32_t least = (0u - range) % range;
        while (static_cast<std::uint32_t>(product) < least) product = std::uint64_t{word()} * n;
    }
    return static_cast<std::size_t>(product >> 32);
}

void resample(std::span<const double> data, Draws& draws, std::span<double> sample) {
    FF_EXPECT(!data.empty());
    for (double& value : sample) value = data[draws.below(data.size())];
}

std::vector<double> resampled_t(std::span<const double> values, std::size_t n, std::size_t samples, StreamKey key) {
    FF_EXPECT(!values.empty() && n >= 2);
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    const auto size = static_cast<double>(n);
    Draws draws(key, Resampling::bootstrap, 0);
    std::vector<double> found;
    found.reserve(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        double sum = 0;
        double squares = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const double value = values[draws.below(values.size())] - mean;
            sum += value;
            squares += value * value;
        }
        const double variance = (squares - sum * sum / size) / (size - 1);
        if (variance > 0) found.push_back(sum / std::sqrt(variance * size));
    }
    return found;
}

}  // namespace ff::stats
