#include <ffstudy/core/points/stream.hpp>

#include <cstdio>

int main() {
    const ff::StreamKey key = ff::derive_key(ff::Seed{1}, "consumer");
    const ff::Words words = ff::philox({.key = key}, 0, ff::Purpose::coordinates);
    std::printf("first word of the consumer's stream: %08x\n", words[0]);
    return words == ff::philox({.key = key}, 0, ff::Purpose::coordinates) ? 0 : 1;
}
