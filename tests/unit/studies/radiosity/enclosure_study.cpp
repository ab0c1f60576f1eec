#include "studies/radiosity/enclosure_study.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ff::studies::radiosity {
namespace {

EnclosureRequest request(const std::string& name, std::uint64_t trials = 0) {
    EnclosureRequest made;
    made.name = name;
    made.light.reflectance = {{0.5}, {0.9}};
    made.rays = 200;
    made.trials = trials;
    made.seed = Seed{1};
    return made;
}

EnclosureRequest mirrored(const std::string& name, std::uint64_t trials = 0) {
    EnclosureRequest made = request(name, trials);
    made.mirror = "6";
    return made;
}

// In a furnace every surface has the exitance e / (1 - rho), whatever sees itself or a mirror, and with factors of rays
// as well: their rows sum to 1.
TEST(EnclosureStudy, IsExactForAFurnace) {
    for (EnclosureRequest furnace : {request("cylinder:1x2", 5), request("cap:1x0.5", 5), request("cone:1x1", 5),
                                     request("spheres:2x1", 5), mirrored("cube", 5), mirrored("box:2x1x0.5", 5)}) {
        furnace.light.emission = {3};
        const EnclosureResults results = study_enclosure(furnace);
        for (const ExactSystem& system : results.exact) {
            const double expected = 3 / (1 - furnace.light.reflectance[system.setting].front());
            for (const double exitance : system.exitance) EXPECT_NEAR(exitance / expected, 1, 1e-13) << furnace.name;
            EXPECT_NEAR(system.properties.spectral_radius.middle(), furnace.light.reflectance[system.setting].front(),
                        1e-11);
        }
        for (const SettingStatistics& at : results.consequences[0].settings) {
            const double expected = 3 / (1 - furnace.light.reflectance[at.setting].front());
            for (const ExitanceStatistics& e : at.exitance) EXPECT_NEAR(e.q975 / expected, 1, 1e-12) << furnace.name;
        }
    }
}

// Rays drawn from the factors have them as their mean, the diagonal too. Of the base of a lit cylinder: the interval of
// the bias at level 1 - 1e-7 holds 0 and is narrower than a hundredth of the exitance, so that a wrong draw would show.
TEST(EnclosureStudy, DrawsRaysWithTheExactFactors) {
    EnclosureRequest drawn = request("cylinder:1x2", 2000);
    drawn.rays = 2000;
    drawn.light.reflectance = {{0.5}};
    drawn.light.solver_trials = 0;
    const EnclosureResults results = study_enclosure(drawn);
    const SettingStatistics& at = results.consequences[0].settings[0];
    for (const ExitanceStatistics& e : at.exitance) {
        const double error = *e.std / std::sqrt(2000.0);
        EXPECT_LT(5.4 * error, 0.01 * e.exact);
        EXPECT_LT(std::abs(*e.bias), 5.4 * error + 5e-4 * e.exact) << "a bias of order 1/N is there";
    }
}

TEST(EnclosureStudy, KeepsDominanceWithDirectRowsAndBalances) {
    const EnclosureResults results = study_enclosure(mirrored("cube", 50));
    ASSERT_EQ(results.of.surfaces.size(), 5u);
    EXPECT_GT(results.of.enclosure.factors(0, 0), 0.06) << "the floor sees itself in the ceiling";
    for (const Consequences& found : results.consequences) {
        if (found.treatment == Treatment::direct) {
            EXPECT_NEAR(found.dominant_below.least, 1, 1e-13);
        }
        if (found.treatment == Treatment::reciprocal) {
            EXPECT_LT(found.dominant_below.least, 0.999);
        }
        if (found.treatment == Treatment::balanced) {
            EXPECT_EQ(found.not_balanced, 0u);
            EXPECT_LT(found.closure_defect.largest, 1e-11);
            EXPECT_LT(found.reciprocity_defect.largest, 1e-12);
            EXPECT_LT(found.factor_error.median, results.consequences[0].factor_error.median);
        }
    }
}

TEST(EnclosureStudy, DependsOnTheSeed) {
    EnclosureRequest other = request("cone:1x1", 10);
    const auto error = [&] { return study_enclosure(other).consequences[0].factor_error.median; };
    const double first = error();
    EXPECT_EQ(error(), first);
    other.seed = Seed{2};
    EXPECT_NE(error(), first);
}

TEST(FindEnclosure, RefusesUnknownEnclosures) {
    const auto message = [](const std::string& name, const std::optional<std::string>& mirror = {}) {
        return test::message_of<UserError>([&] { (void)find_enclosure(name, mirror); });
    };
    using testing::HasSubstr;
    EXPECT_THAT(message("cilinder:1x2"), HasSubstr("Did you mean cylinder?"));
    EXPECT_THAT(message("cylinder"), HasSubstr("two lengths"));
    EXPECT_THAT(message("cylinder:1"), HasSubstr("two lengths"));
    EXPECT_THAT(message("cylinder:1x-2"), HasSubstr("two lengths"));
    EXPECT_THAT(message("cylinder:1x2x3"), HasSubstr("two lengths"));
    EXPECT_THAT(message("cylinder:nanx1"), HasSubstr("two lengths"));
    EXPECT_THAT(message("cap:1x2"), HasSubstr("higher than its sphere"));
    EXPECT_THAT(message("spheres:1x1"), HasSubstr("no smaller"));
    EXPECT_THAT(message("cube"), HasSubstr("Add --mirror"));
    EXPECT_THAT(message("cube", "7"), HasSubstr("no face '7'"));
    EXPECT_THAT(message("cone:1x1", "base"), HasSubstr("only a face of a box"));
    EXPECT_EQ(message("box:2x1x0.5", "1"), "nothing thrown");
}

TEST(EnclosureStudy, RefusesMismatchedSurfaceCountsAndZeroRays) {
    EnclosureRequest wrong = request("cylinder:1x2");
    wrong.light.emission = {1, 0};
    EXPECT_THROW((void)study_enclosure(wrong), UserError);
    wrong = request("cylinder:1x2", 10);
    wrong.rays = 0;
    EXPECT_THROW((void)study_enclosure(wrong), UserError);
    wrong.rays = 10;
    wrong.trials = 1;
    EXPECT_THROW((void)study_enclosure(wrong), UserError);
}

}  // namespace
}  // namespace ff::studies::radiosity
