// A study file is a study, whose canonical text reads as the same study, or a UserError; an IoError where a file that
// it names cannot be read.

#include "core/support/error.hpp"
#include "studies/plan/plan.hpp"
#include "studies/spec/spec.hpp"
#include "tests/fuzz/one_input.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ff::studies;
    StudySpec spec;
    try {
        spec = parse_study({reinterpret_cast<const char*>(data), size}, "study.toml");
    } catch (const ff::UserError&) {
        return 0;
    } catch (const ff::IoError&) {
        return 0;
    }
    StudySpec again = parse_study(to_toml(spec), "canonical.toml");
    if (again.published && spec.published) again.published->text = spec.published->text;
    if (again != spec) std::abort();
    try {
        plan_study(std::move(spec));
    } catch (const ff::UserError&) {
    }
    return 0;
}
