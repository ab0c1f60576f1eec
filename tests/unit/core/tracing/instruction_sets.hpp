#pragma once

#include "core/support/instruction_sets.hpp"

#include <string>
#include <vector>

namespace ff::test {

/// Runs `body` once with each instruction set that the library was compiled for and this CPU has, the best first, and
/// returns what it gave; one element alone means that nothing could be compared.
template <class Body>
auto with_each_instruction_set(Body body) {
    std::vector<decltype(body())> results;
    for (const std::string& set : instruction_sets()) {
        use_instruction_set(set);
        results.push_back(body());
    }
    use_instruction_set("");
    return results;
}

}  // namespace ff::test
