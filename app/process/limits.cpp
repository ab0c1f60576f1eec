#include "app/process/limits.hpp"

#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <system_error>

namespace ff::app {
namespace {

struct Unit {
    char letter;
    double factor;
};
constexpr std::array time_units{Unit{'s', 1}, Unit{'m', 60}, Unit{'h', 3600}, Unit{'d', 86400}};
constexpr std::array size_units{Unit{'k', 0x1p10}, Unit{'m', 0x1p20}, Unit{'g', 0x1p30}, Unit{'t', 0x1p40}};

/// A positive number with at most one letter after it, in units of 1; empty for any other text.
std::optional<double> quantity(std::string_view text, const std::array<Unit, 4>& units) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
    if (error != std::errc() || !(value > 0) || value > 1e15 || end - rest > 1) return std::nullopt;
    if (rest == end) return value;
    const int letter = std::tolower(static_cast<unsigned char>(*rest));
    const auto* unit = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.letter == letter; });
    return unit == units.end() ? std::nullopt : std::optional(value * unit->factor);
}

/// Memory of the machine, in bytes.
struct MachineMemory {
    std::uint64_t total = 0;
    std::uint64_t available = 0;
};

std::optional<MachineMemory> machine_memory() {
    std::ifstream lines("/proc/meminfo");
    MachineMemory memory;
    std::string name;
    std::uint64_t kibibytes = 0;
    while (lines >> name >> kibibytes) {
        if (name == "MemTotal:") memory.total = kibibytes * 1024;
        if (name == "MemAvailable:") memory.available = kibibytes * 1024;
        std::getline(lines, name);
    }
    return memory.total > 0 && memory.available > 0 ? std::optional(memory) : std::nullopt;
}

/// Why the run has to end, in words; empty: it need not.
std::string too_much(std::optional<std::uint64_t> limit) {
    const auto used = resident_memory();
    if (!used) return "";
    if (limit) {
        return *used > *limit ? fmt::format("{} of memory are in use, more than --max-memory", size_in_words(*used))
                              : "";
    }
    const auto machine = machine_memory();
    if (!machine || *used < machine->total / 2 || machine->available > machine->total / 50) return "";
    return fmt::format("{} of memory are in use, and the machine has only {} left", size_in_words(*used),
                       size_in_words(machine->available));
}

}  // namespace

std::optional<std::chrono::duration<double>> parse_duration(const std::optional<std::string>& text,
                                                            std::string_view option) {
    if (!text) return std::nullopt;
    const auto seconds = quantity(*text, time_units);
    // Clocks count nanoseconds in 63 bits.
    if (seconds && *seconds < 1e9) return std::chrono::duration<double>(*seconds);
    throw UserError("{} {}: not a duration (90, 90s, 15m, 2.5h and 1d are). Give one.", option, *text);
}

std::optional<std::uint64_t> parse_size(const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    const auto bytes = quantity(*text, size_units);
    if (bytes && *bytes >= 1 && *bytes < 0x1p63) return static_cast<std::uint64_t>(*bytes);
    throw UserError("--max-memory {}: not a size (500M and 2G are). Give one.", *text);
}

std::string size_in_words(std::uint64_t bytes) {
    const double mebibytes = static_cast<double>(bytes) / 0x1p20;
    return mebibytes < 1000 ? fmt::format("{:.0f} MiB", std::max(1.0, mebibytes))
                            : fmt::format("{:.1f} GiB", mebibytes / 1024);
}

std::optional<std::uint64_t> resident_memory() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t size = 0;
    std::uint64_t resident = 0;
    if (!(statm >> size >> resident)) return std::nullopt;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

Limits::Limits(std::optional<std::chrono::duration<double>> time, std::optional<std::uint64_t> memory) {
    if (time) {
        clock_ = std::jthread([limit = *time](const std::stop_token& ended) {
            std::mutex mutex;
            std::condition_variable_any never;
            std::unique_lock lock(mutex);
            never.wait_for(lock, ended, limit, [] { return false; });
            if (!ended.stop_requested()) ask_for_the_end();
        });
    }
    const auto watch = [memory](const std::stop_token& ended) {
        constexpr std::chrono::milliseconds pause{20};
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        do {
            const std::string reason = too_much(memory);
            if (reason.empty()) continue;
            say("note: {}.\n", reason);
            return ask_for_the_end();
        } while (!never.wait_for(lock, ended, pause, [&] { return ended.stop_requested(); }));
    };
    try {
        watch_ = std::jthread(watch);
    } catch (const std::system_error&) {
        if (memory) throw;  // otherwise nobody has asked for it
    }
}

}  // namespace ff::app
