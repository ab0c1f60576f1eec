#include "studies/spec/coverage_request.hpp"

#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

namespace ff::studies {

std::vector<std::uint64_t> read_coverage(const TomlReader& reader, std::uint64_t trials) {
    reader.expect_only({"replicates"});
    auto replicates = reader.counts("replicates");
    for (const std::uint64_t r : replicates) {
        if (r >= 3 && r <= trials / 2) continue;
        reader.fail("replicates", fmt::format("(3 to {} of the study's {} trials make a group). Try [5, 10, 20, 30] "
                                              "and 1000 trials.",
                                              trials / 2, trials));
    }
    return replicates;
}

}  // namespace ff::studies
