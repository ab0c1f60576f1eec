// furnace_walks WALKS SEED: the counts of the furnace in tests/support/known_flows.cpp.

#include "tests/references/furnace_walks.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    constexpr int decimal = 10;
    const std::uint64_t walks = std::strtoull(argv[1], nullptr, decimal);
    ff::test::FurnaceWalks furnace(std::strtoull(argv[2], nullptr, decimal));
    std::printf("%llu of %llu walks end on the roof\n", static_cast<unsigned long long>(furnace.to_roof(walks)),
                static_cast<unsigned long long>(walks));
}
