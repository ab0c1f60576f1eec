#include "studies/run/parallel.hpp"

#include "core/support/error.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace ff::studies {
namespace {

TEST(Shard, HoldsEveryUnitInExactlyOneOfAll) {
    for (std::uint64_t count = 1; count <= 5; ++count) {
        for (std::size_t unit = 0; unit < 23; ++unit) {
            int holders = 0;
            for (std::uint64_t index = 1; index <= count; ++index) holders += Shard{index, count}.holds(unit) ? 1 : 0;
            EXPECT_EQ(holders, 1) << unit << " of shards " << count;
        }
    }
}

TEST(Shard, IsReadFromIndexAndCount) {
    const Shard shard = parse_shard("2/5");
    EXPECT_EQ(shard.index, 2u);
    EXPECT_EQ(shard.count, 5u);
    EXPECT_FALSE(shard.is_whole());
    EXPECT_TRUE(parse_shard("1/1").is_whole());
}

TEST(Shard, RefusesMalformedText) {
    for (const char* text :
         {"", "1", "0/1", "2/1", "1/0", "-1/2", "1/2/3", "1 /2", "a/2", "1/2x", "1/99999999999999999999"})
        EXPECT_THROW(parse_shard(text), UserError) << text;
}

}  // namespace
}  // namespace ff::studies
