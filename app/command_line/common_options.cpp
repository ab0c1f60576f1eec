#include "app/command_line/common_options.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <thread>

namespace ff::app {
namespace {

constexpr std::uint64_t largest_seed = (1ULL << 63) - 1;  // study files hold it as a TOML integer
constexpr unsigned most_threads = 4096;

}  // namespace

Seed checked_seed(std::uint64_t seed) {
    if (seed > largest_seed)
        throw UserError(fmt::format("--seed {} (at most {}). Take a smaller one.", seed, largest_seed));
    return Seed{seed};
}

Seed fresh_seed() {
    std::random_device device;
    return Seed{std::uniform_int_distribution<std::uint64_t>(0, largest_seed)(device)};
}

unsigned thread_count(const std::optional<unsigned>& threads) {
    if (!threads) return std::max(1u, std::thread::hardware_concurrency());
    if (*threads == 0 || *threads > most_threads) {
        throw UserError(
            fmt::format("--threads {} (1 to {} are possible). Leave it out for all cores.", *threads, most_threads));
    }
    return *threads;
}

}  // namespace ff::app
