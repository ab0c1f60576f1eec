#include "samplers/random/random_mt.hpp"

#include <gtest/gtest.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/seed_seq.hpp>

#include <vector>

namespace ff::samplers {
namespace {

TEST(RandomMt, IsTheUpperHalfOfBoostsTwisterSeededByPhilox) {
    const Stream stream{.key = {1, 2}, .trial = 3, .source = 4, .target = 5};
    std::vector<std::uint32_t> seeds;
    for (const std::uint32_t index : {2u, 3u}) {  // of the second run of 1024 points
        for (const std::uint32_t word : philox(stream, index, Purpose::engine)) seeds.push_back(word);
    }
    boost::random::seed_seq sequence(seeds.begin(), seeds.end());
    boost::random::mt19937_64 engine(sequence);

    PointBlock block;
    block.size = 100;
    RandomMt({.points = 2048}).fill(stream, 1024, block);
    for (std::size_t i = 0; i < block.size; ++i) {
        for (std::size_t d = 0; d < max_dimension; ++d) {
            EXPECT_EQ(block.coordinate[d][i], static_cast<std::uint32_t>(engine() >> 32));
        }
    }
}

}  // namespace
}  // namespace ff::samplers
