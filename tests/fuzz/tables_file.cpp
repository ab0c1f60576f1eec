// A tables file can be audited and reported, or it is a UserError.

#include "core/support/error.hpp"
#include "studies/audit/audit.hpp"
#include "studies/published/published.hpp"
#include "tests/fuzz/one_input.hpp"

#include <cstdint>
#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto tables =
            ff::studies::parse_published_tables({reinterpret_cast<const char*>(data), size}, "tables.json");
        // The audit is made for tables of human size: its time grows faster than the size of tables.
        if (tables.figures.size() <= 40) ff::studies::audit::examine(tables);
    } catch (const ff::UserError&) {
    }
    return 0;
}
