// A bands file is gates that can be planned, or a UserError.

#include "studies/gates/bands_file.hpp"
#include "core/error.hpp"
#include "studies/gates/gate_plan.hpp"
#include "tests/fuzz/one_input.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ff::studies;
    try {
        const GatesSpec spec = parse_bands({reinterpret_cast<const char*>(data), size}, "bands.toml");
        for (std::size_t gate = 0; gate < spec.gates.size(); ++gate) {
            if (!(spec.gates[gate].band.low <= spec.gates[gate].band.high)) std::abort();
            if (!spec.gates[gate].from_estimates()) prepare_gate(spec, gate, GatePurpose::check, nullptr);
        }
    } catch (const ff::UserError&) {
    }
    return 0;
}
