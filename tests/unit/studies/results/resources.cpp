#include "studies/results/resources.hpp"

#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace ff::studies {
namespace {

double seconds_of_results(int patches_per_face, int trials) {
    return expected_seconds_of_results(test::plan_of(test::study_text(
        fmt::format("trials = {}", trials), fmt::format("[[method]]\nname = \"m\"\nsampler = \"random\"\nestimator = "
                                                        "\"ray_shooting\"\npatches_per_face = {}\nsamples_per_patch = "
                                                        "1\n",
                                                        patches_per_face))));
}

// `ffstudy report` took 6.2 s of processor time for 65 536 patches on each face of a cube, 0.4 s for 4096: their exact
// factors, whatever the number of trials.
TEST(ExpectedSecondsOfResults, GrowWithTheNumberOfPatches) {
    EXPECT_GT(seconds_of_results(65536, 4), 6.2 / 2);
    EXPECT_LT(seconds_of_results(65536, 4), 6.2 * 2);
    EXPECT_GT(seconds_of_results(4096, 16), 0.4 / 2);
    EXPECT_LT(seconds_of_results(4096, 16), 0.4 * 2);
    EXPECT_LT(seconds_of_results(1, 4), 0.01);
}

}  // namespace
}  // namespace ff::studies
