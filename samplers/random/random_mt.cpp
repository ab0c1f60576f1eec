#include "samplers/random/random_mt.hpp"

#include "core/support/contract.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/seed_seq.hpp>

#include <algorithm>
#include <array>

namespace ff::samplers {
namespace {

/// Points that share an engine: random access has to throw away at most this many.
constexpr std::uint64_t run_length = block_capacity;

boost::random::mt19937_64 make_engine(const Stream& stream, std::uint64_t run) {
    const auto index = static_cast<std::uint32_t>(2 * run);
    const Words low = philox(stream, index, Purpose::engine);
    const Words high = philox(stream, index + 1, Purpose::engine);
    std::array<std::uint32_t, 8> words{};
    std::copy(high.begin(), high.end(), std::copy(low.begin(), low.end(), words.begin()));
    boost::random::seed_seq seeds(words.begin(), words.end());
    return boost::random::mt19937_64(seeds);
}

}  // namespace

void RandomMt::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    FF_EXPECT(block.dimension == dimension_);
    std::size_t done = 0;
    while (done < block.size) {
        const PointIndex index = first + done;
        const std::uint64_t skipped = index % run_length;
        const std::size_t end = std::min<std::size_t>(block.size, done + (run_length - skipped));
        auto engine = make_engine(stream, index / run_length);
        for (std::uint64_t draw = 0; draw < skipped * dimension_; ++draw) engine();
        for (; done < end; ++done) {
            for (std::size_t d = 0; d < dimension_; ++d) {
                block.coordinate[d][done] = static_cast<std::uint32_t>(engine() >> 32);
            }
        }
    }
}

}  // namespace ff::samplers
