#pragma once

#include "core/support/error.hpp"
#include "studies/verdicts/gate.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace ff::studies::gates {

/// @throws UserError at the gate's place in its file
[[noreturn]] inline void refuse_gate(const Gate& gate, const std::string& problem) {
    throw UserError(fmt::format("{}: {}", gate.place, problem));
}

/// @param unit  what more would be needed of
[[noreturn]] inline void refuse_undecidable(const Gate& gate, std::string_view unit) {
    refuse_gate(
        gate,
        fmt::format("no number of {} can decide (the reference is too uncertain for this band, or the band is far "
                    "below the noise). Widen the band, or find a better reference.",
                    unit));
}

/// Calls `task`, and names the gate where a statistic is out of Boost.Math's range.
/// @throws UserError at the gate's place; anything else that `task` throws
template <class Task>
auto at_gate(const Gate& gate, const Task& task) {
    const auto named = [&gate](const std::exception& error) {
        return UserError(
            fmt::format("{}: gate '{}' cannot be judged (a statistic is beyond what can be computed: {}). Look for "
                        "values that are far from all others, or choose another band.",
                        gate.place, gate.name, error.what()));
    };
    try {
        return task();
    } catch (const UserError&) {
        throw;
    } catch (const IoError&) {
        throw;
    } catch (const std::system_error&) {
        throw;
    } catch (const std::domain_error& error) {
        throw named(error);
    } catch (const std::runtime_error& error) {
        throw named(error);
    }
}

}  // namespace ff::studies::gates
