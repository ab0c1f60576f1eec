#include "core/estimators/rays/ray_shooting.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/support/philox_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ff {
namespace {

constexpr StreamKey key{17, 23};

std::uint64_t total(const std::vector<std::uint64_t>& values) {
    return std::accumulate(values.begin(), values.end(), std::uint64_t{0});
}

RayTally one_trial(const Scene& scene, std::uint32_t m, std::uint64_t samples, Allocation allocation,
                   const PointSource& points, PatchSums& sums, std::uint32_t trial = 0) {
    RayTally tally;
    ray_shooting(scene, {m}, *make_tracer(scene, TracerChoice::automatic), points, samples, allocation, key, trial,
                 tally, &sums);
    return tally;
}

TEST(RayShooting, AccountsForEveryRay) {
    const Scene box = make_box(3, 2, 1);
    for (const std::uint64_t samples : {1u, 625u, 1024u, 5000u}) {
        PatchSums sums;
        const RayTally tally = one_trial(box, 3, samples, Allocation::patch, test::PhiloxPoints(samples), sums);
        for (std::size_t face = 0; face < 6; ++face) {
            EXPECT_EQ(tally.rays[face], 9 * samples);
            EXPECT_EQ(tally.lost[face], 0u);
            EXPECT_EQ(tally.hits[face * 6 + face], 0u);
        }
        EXPECT_EQ(total(tally.hits), total(tally.rays));
        EXPECT_EQ(total(sums.hits), total(tally.rays));
    }
}

TEST(RayShooting, ReplacesTheTallyAndAddsToTheSums) {
    const Scene box = make_box(3, 2, 1);
    PatchSums sums;
    const RayTally first = one_trial(box, 2, 100, Allocation::patch, test::PhiloxPoints(100), sums, 0);
    const PatchSums after_first = sums;
    const RayTally second = one_trial(box, 2, 100, Allocation::patch, test::PhiloxPoints(100), sums, 1);
    EXPECT_NE(first.hits, second.hits) << "trials differ";
    EXPECT_EQ(total(second.hits), 2400u);
    EXPECT_EQ(total(sums.hits), 4800u);
    for (std::size_t i = 0; i < sums.hits.size(); ++i) {
        const std::uint64_t hits = sums.hits[i] - after_first.hits[i];
        EXPECT_EQ(after_first.hits_squared[i], after_first.hits[i] * after_first.hits[i]);
        EXPECT_EQ(sums.hits_squared[i] - after_first.hits_squared[i], hits * hits);
    }
}

/// Remembers every (source, first, size) it was asked for.
class SequenceRecorder : public test::PhiloxPoints {
  public:
    using PhiloxPoints::fill;
    SequenceRecorder() : PhiloxPoints(1) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        EXPECT_EQ(stream.key, key);
        EXPECT_EQ(stream.target, 0u);
        asked.push_back({stream.source, first, block.size});
        PhiloxPoints::fill(stream, first, block);
    }
    mutable std::vector<std::array<std::uint64_t, 3>> asked;
};

TEST(RayShooting, GivesEveryPatchItsOwnSequence) {
    SequenceRecorder points;
    PatchSums sums;
    one_trial(make_box(1, 1, 1), 2, 1500, Allocation::patch, points, sums);
    ASSERT_EQ(points.asked.size(), 48u);
    for (std::uint64_t patch = 0; patch < 24; ++patch) {
        EXPECT_EQ(points.asked[2 * patch], (std::array<std::uint64_t, 3>{patch, 0, 1024}));
        EXPECT_EQ(points.asked[2 * patch + 1], (std::array<std::uint64_t, 3>{patch, 1024, 476}));
    }
}

TEST(RayShooting, ContinuesOneSequenceOverAFace) {
    SequenceRecorder points;
    PatchSums sums;
    one_trial(make_box(1, 1, 1), 2, 100, Allocation::face, points, sums);
    ASSERT_EQ(points.asked.size(), 24u);
    for (std::uint64_t patch = 0; patch < 24; ++patch) {
        EXPECT_EQ(points.asked[patch], (std::array<std::uint64_t, 3>{patch / 4, patch % 4 * 100, 100}));
    }
}

/// z scores of trial means against exact factors, and the ratio of sampled to exact variance, over the ordered pairs.
struct Comparison {
    double largest_z = 0;
    double smallest_ratio = 1e9;
    double largest_ratio = 0;
    double largest_standard_error = 0;
};

/// Exact variance of one trial: (1/P^2) sum_p F_p (1 - F_p) / n over the patches p of the face.
double exact_variance(const Eigen::MatrixXd& patch_factors, Eigen::Index patches, int from, int to, double samples) {
    double sum = 0;
    for (Eigen::Index p = 0; p < patches; ++p) {
        const double factor = patch_factors(from * patches + p, to);
        sum += factor * (1 - factor) / samples;
    }
    return sum / static_cast<double>(patches * patches);
}

Comparison compare_with_exact(const Scene& scene, std::uint32_t m, std::uint64_t samples, std::uint32_t trials,
                              const PointSource& points) {
    const auto tracer = make_tracer(scene, TracerChoice::automatic);
    const Eigen::MatrixXd exact = exact_form_factors(scene).value();
    const Eigen::MatrixXd patch_factors = exact_patch_to_face(scene, {m}).value();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(6, 6);
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(6, 6);
    RayTally tally;
    PatchSums sums;
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        ray_shooting(scene, {m}, *tracer, points, samples, Allocation::patch, key, trial, tally, &sums);
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < 6; ++j) {
                const std::size_t at = std::size_t{6} * static_cast<std::size_t>(i) + static_cast<std::size_t>(j);
                const double error =
                    static_cast<double>(tally.hits[at]) / static_cast<double>(tally.rays[static_cast<std::size_t>(i)]) -
                    exact(i, j);
                sum(i, j) += error;
                squares(i, j) += error * error;
            }
        }
    }
    Comparison result;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            if (i == j) continue;
            const double variance =
                exact_variance(patch_factors, Eigen::Index{m} * m, i, j, static_cast<double>(samples));
            const double standard_error = std::sqrt(variance / trials);
            const double ratio = squares(i, j) / trials / variance;
            result.largest_z = std::max(result.largest_z, std::abs(sum(i, j) / trials) / standard_error);
            result.smallest_ratio = std::min(result.smallest_ratio, ratio);
            result.largest_ratio = std::max(result.largest_ratio, ratio);
            result.largest_standard_error = std::max(result.largest_standard_error, standard_error);
        }
    }
    return result;
}

// Thirty pairs at a family level of 1e-6: each two-sided at 3.3e-8, |z| < 5.523.
//   scipy.stats.norm.isf(1e-6 / 30 / 2)
constexpr double z_limit = 5.523;
// Mean squared errors about the exact value, over the exact variance, are chi^2 / T for T = 400 independent trials:
//   scipy.stats.chi2.ppf([1e-6 / 60, 1 - 1e-6 / 60], 400) / 400 = 0.657, 1.441
constexpr double ratio_low = 0.657, ratio_high = 1.441;

// 400 trials of 9 x 200 rays per face. The standard error is at most 6e-4 (checked), so that a bias of 5e-3 in one pair
// shows with probability above .99; a variance wrong by a factor of 1.7 does as well.
TEST(RayShooting, IsUnbiasedAndHasTheExactStratifiedVariance) {
    const Comparison c = compare_with_exact(make_box(3, 2, 1), 3, 200, 400, test::PhiloxPoints(200));
    EXPECT_LT(c.largest_z, z_limit);
    EXPECT_GT(c.smallest_ratio, ratio_low);
    EXPECT_LT(c.largest_ratio, ratio_high);
    EXPECT_LT(c.largest_standard_error, 5e-3 / (z_limit + 2.4));
}

/// Broken on purpose: all rays start at the centre of their patch.
class CentredPoints : public test::PhiloxPoints {
  public:
    using PhiloxPoints::fill;
    using PhiloxPoints::PhiloxPoints;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        PhiloxPoints::fill(stream, first, block);
        for (std::size_t i = 0; i < block.size; ++i) block.coordinate[0][i] = block.coordinate[1][i] = 0x80000000u;
    }
};

TEST(RayShooting, IsFoundBiasedWhenRaysStartAtPatchCentres) {
    EXPECT_GT(compare_with_exact(make_box(3, 2, 1), 3, 200, 400, CentredPoints(200)).largest_z, z_limit);
}

/// Broken on purpose: the same points in every trial.
class StuckPoints : public test::PhiloxPoints {
  public:
    using PhiloxPoints::fill;
    using PhiloxPoints::PhiloxPoints;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        Stream stuck = stream;
        stuck.trial = 0;
        PhiloxPoints::fill(stuck, first, block);
    }
};

TEST(RayShooting, IsFoundWrongWhenTrialsRepeatThemselves) {
    const Comparison c = compare_with_exact(make_box(3, 2, 1), 3, 200, 400, StuckPoints(200));
    EXPECT_TRUE(c.largest_z > z_limit || c.smallest_ratio < ratio_low || c.largest_ratio > ratio_high);
}

}  // namespace
}  // namespace ff
