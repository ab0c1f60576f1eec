// Runs a fuzz target without libFuzzer: on every seed, and on copies of seeds that are changed in a few places by a
// generator with a fixed seed. Usage: fuzz_NAME CHANGED_COPIES FILE_OR_FOLDER...

#include "tests/fuzz/one_input.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// All files, in the order of their names.
std::vector<Bytes> read_seeds(int count, char** places) {
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < count; ++i) {
        if (!std::filesystem::is_directory(places[i]))
            files.emplace_back(places[i]);
        else
            for (const auto& entry : std::filesystem::directory_iterator(places[i])) {
                if (entry.is_regular_file()) files.push_back(entry.path());
            }
    }
    std::sort(files.begin(), files.end());
    std::vector<Bytes> seeds;
    std::transform(files.begin(), files.end(), std::back_inserter(seeds), read);
    return seeds;
}

Bytes change(Bytes bytes, const std::vector<Bytes>& seeds, std::mt19937_64& random) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1)); };
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
        const std::size_t at = below(bytes.size() + 1);
        const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
        switch (below(5)) {
            case 0:
                bytes.resize(at);
                break;
            case 1:
                bytes.insert(place, static_cast<std::uint8_t>(random()));
                break;
            case 2:
                bytes.erase(place, bytes.end() - static_cast<std::ptrdiff_t>(below(bytes.size() - at + 1)));
                break;
            case 3: {
                const Bytes& other = seeds[below(seeds.size())];
                const std::size_t from = below(other.size());
                const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
                const auto length = static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(other.size() - from, 64)));
                bytes.insert(place, begin, begin + length);
                break;
            }
            default:
                if (at < bytes.size()) bytes[at] = static_cast<std::uint8_t>(random());
        }
    }
    return bytes;
}

}  // namespace

int main(int argc, char** argv) {
    const int copies = argc > 2 ? std::atoi(argv[1]) : -1;
    const auto seeds = copies < 0 ? std::vector<Bytes>() : read_seeds(argc - 2, argv + 2);
    if (seeds.empty()) {
        std::fprintf(stderr, "usage: %s CHANGED_COPIES FILE_OR_FOLDER... (with some files in them)\n", argv[0]);
        return 2;
    }
    for (const Bytes& seed : seeds) LLVMFuzzerTestOneInput(seed.data(), seed.size());
    std::mt19937_64 random(20261120);
    for (int i = 0; i < copies; ++i) {
        const Bytes changed = change(seeds[static_cast<std::size_t>(i) % seeds.size()], seeds, random);
        LLVMFuzzerTestOneInput(changed.data(), changed.size());
    }
    std::printf("%zu seeds and %d changed copies\n", seeds.size(), copies);
}
