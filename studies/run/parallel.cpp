#include "studies/run/parallel.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ff::studies {

void for_each_index(std::uint64_t times, unsigned threads, const std::function<void(std::uint64_t)>& task) {
    std::atomic<std::uint64_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        try {
            for (std::uint64_t i = next++; i < times; i = next++) task(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            next = times;
        }
    };
    std::vector<std::jthread> pool;
    try {
        while (pool.size() + 1 < threads) pool.emplace_back(work);
    } catch (const std::system_error& error) {
        next = times;
        throw UserError("{} threads (the system started {} of them: {}). Take fewer with --threads.", threads,
                        pool.size(), error.code().message());
    }
    work();
    pool.clear();  // joins them
    if (failure) std::rethrow_exception(failure);
}

Shard parse_shard(std::string_view text) {
    const auto slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto index = parse_bare_number<std::uint64_t>(text.substr(0, slash));
        const auto count = parse_bare_number<std::uint64_t>(text.substr(slash + 1));
        if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
    }
    throw UserError("--shard {}: not a share (i/n with 1 <= i <= n is one). For the second of four write 2/4.", text);
}

}  // namespace ff::studies
