#include "core/support/processor_time.hpp"

#include "core/support/child_process.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

/// Python computes until it has used 0.2 s of processor time.
void use_processor_in_a_child() {
    const ChildOutput output =
        read_from_child({{"python3", "-c", "import time\nwhile time.process_time() < 0.2: pass"}, {}}, 1 << 16, 60);
    ASSERT_EQ(output.code, 0) << output.errors;
}

TEST(ProcessorTime, CoversTheThreadAndProgramsThatItWaitedFor) {
    const double begin = processor_seconds();
    use_processor_in_a_child();
    EXPECT_GE(processor_seconds() - begin, 0.199);
    const double before_work = processor_seconds();
    while (processor_seconds() - before_work < 0.01) {
    }
    EXPECT_GE(processor_seconds() - begin, 0.209);
}

TEST(ProcessorTime, ExcludesUncountedWork) {
    const double begin = processor_seconds();
    {
        const UncountedTime checks;
        use_processor_in_a_child();
    }
    EXPECT_LT(processor_seconds() - begin, 0.1);
}

}  // namespace
}  // namespace ff
