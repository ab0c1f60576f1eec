#include "studies/verdicts/bands_file.hpp"

#include "core/support/error.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

constexpr std::string_view rays_in_cube =
    "scene = \"cube\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 64\n";

std::string gate(std::string_view kind, std::string_view lines) {
    return fmt::format("[[gate]]\nname = \"g\"\nkind = \"{}\"\n{}{}\n", kind, rays_in_cube, lines);
}

Band band_of(std::string_view kind, std::string_view lines) {
    return parse_bands(gate(kind, lines), "bands.toml", read_experiment).gates.front().band;
}

std::string refusal_of_bands(std::string_view text) {
    return test::message_of<UserError>([&] { static_cast<void>(parse_bands(text, "bands.toml", read_experiment)); });
}

TEST(BandsFile, ReadsTheExampleOfTheDocumentation) {
    const Spec spec = parse_bands(R"([gates]
alpha = 1e-3
power = 0.8
seed = 7
looks = 2
max_trials = 500

[[gate]]
name = "SR is unbiased"
kind = "bias"
scene = "cube"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = 169
samples_per_patch = 625
pairs = "parallel"
band = 5e-5

[[gate]]
name = "my renderer"
kind = "bias"
quantity = "F16"
reference = 0.19982489569838738
reference_se = 1e-9
band = 1e-3
)",
                                  "folder/push.toml", read_experiment);
    EXPECT_EQ(spec.name, "push");
    EXPECT_EQ(spec.alpha, 1e-3);
    EXPECT_EQ(spec.power, 0.8);
    EXPECT_EQ(spec.seed.value, 7u);
    EXPECT_EQ(spec.looks, 2u);
    EXPECT_EQ(spec.max_trials, 500u);
    ASSERT_EQ(spec.gates.size(), 2u);
    const Gate& first = spec.gates[0];
    EXPECT_EQ(first.name, "SR is unbiased");
    EXPECT_EQ(first.kind, GateKind::bias);
    EXPECT_EQ(first.against, Against::exact);
    EXPECT_EQ(experiment_of(first).scenes, std::vector{scene_source("cube")});
    EXPECT_EQ(experiment_of(first).method.sampler, "random");
    EXPECT_EQ(experiment_of(first).method.sizes.front().patches_per_face, 169u);
    EXPECT_EQ(first.pairs, std::vector<std::string>{"parallel"});
    EXPECT_EQ(first.band, (Band{-5e-5, 5e-5}));
    EXPECT_EQ(first.place, "folder/push.toml:17:8");
    EXPECT_FALSE(first.from_estimates());
    EXPECT_TRUE(spec.gates[1].from_estimates());
    EXPECT_EQ(spec.gates[1].against, Against::number);
    EXPECT_EQ(spec.gates[1].reference, 0.19982489569838738);
    EXPECT_EQ(spec.gates[1].reference_se, 1e-9);
}

TEST(BandsFile, RefusesAlphaOutOfRange) {
    const auto with_alpha = [](std::string_view alpha) {
        return refusal_of_bands(fmt::format("[gates]\nalpha = {}\n{}", alpha, gate("bias", "band = 1e-3")));
    };
    for (const std::string_view alpha : {"5e-324", "1e-16", "9e-13", "0.0", "-1.0", "0.5", "nan"})
        EXPECT_THAT(with_alpha(alpha), HasSubstr("bands.toml:2:9: alpha")) << alpha;
    EXPECT_EQ(with_alpha("1e-12"), "nothing thrown");
}

TEST(BandsFile, RefusesNumbersWhosePowersOverflow) {
    for (const std::string_view band : {"1e80", "1e-80", "5e-324"})
        EXPECT_THAT(refusal_of_bands(gate("bias", fmt::format("band = {}", band))), HasSubstr("Choose another unit"))
            << band;
    EXPECT_THAT(refusal_of_bands(gate("bias", "band = 1\nreference = 1e200")), HasSubstr("reference"));
    EXPECT_THAT(refusal_of_bands(gate("std", "band = 1e-13")), HasSubstr("narrower than 1e-12"));
    EXPECT_THAT(refusal_of_bands(gate("coverage", "band = 1e-13")), HasSubstr("narrower than 1e-12"));
    EXPECT_THAT(refusal_of_bands(gate("coverage", "band = 0.01\nlevel = 0.9999999999")), HasSubstr("at most 1 - 1e-9"));
}

TEST(BandsFile, GivesEachKindItsBand) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(band_of("bias", "band = 0.5"), (Band{-0.5, 0.5}));
    EXPECT_EQ(band_of("closure", "band = 0.5"), (Band{-0.5, 0.5}));
    EXPECT_EQ(band_of("reciprocity", "band = 0.5"), (Band{-0.5, 0.5}));
    EXPECT_EQ(band_of("std", "band = 0.25"), (Band{0.8, 1.25}));
    EXPECT_EQ(band_of("rmse", "band = [0, 1.5]"), (Band{0, 1.5}));
    EXPECT_EQ(band_of("efficiency", "band = 0.25"), (Band{0.8, infinity}));
    EXPECT_EQ(band_of("lost_rays", "band = 0"), (Band{0, 0}));
    EXPECT_EQ(band_of("coverage", "level = 0.9\nband = [0.85, 0.95]"), (Band{0.85, 0.95}));
    EXPECT_EQ(band_of("coverage", "level = 0.75\nband = 0.5"), (Band{0.25, 1}));
    EXPECT_EQ(band_of("slope", "expected = -0.5\nband = 0.25"), (Band{-0.75, -0.25}));
    EXPECT_EQ(band_of("slope", "band = [-0.6, -0.4]"), (Band{-0.6, -0.4}));
}

TEST(BandsFile, RefusesBandsThatNoNumberOfTrialsCanDecide) {
    for (const char* kind : {"bias", "closure", "reciprocity", "std", "rmse", "efficiency", "coverage"}) {
        EXPECT_THAT(refusal_of_bands(gate(kind, "band = 0")),
                    HasSubstr("bands.toml:8:8: band = 0 (a band of zero width"))
            << kind;
        EXPECT_THAT(refusal_of_bands(gate(kind, "band = -1")), HasSubstr("positive")) << kind;
        EXPECT_THAT(refusal_of_bands(gate(kind, "")), HasSubstr("band: missing")) << kind;
    }
    EXPECT_THAT(refusal_of_bands(gate("slope", "expected = -0.5\nband = 0")), HasSubstr("zero width"));
    EXPECT_THAT(refusal_of_bands(gate("slope", "band = [-0.5, -0.5]")), HasSubstr("zero width"));
    EXPECT_THAT(refusal_of_bands(gate("slope", "band = [-0.4, -0.5]")), HasSubstr("lower end comes first"));
    EXPECT_THAT(refusal_of_bands(gate("slope", "band = 0.1")), HasSubstr("expected: missing"));
    EXPECT_THAT(refusal_of_bands(gate("slope", "expected = 1e300\nband = 0.1")), HasSubstr("rounding closes it"));
    EXPECT_THAT(refusal_of_bands(gate("std", "band = [1.1, 1.2]")), HasSubstr("has to lie inside"));
    EXPECT_THAT(refusal_of_bands(gate("coverage", "band = [0.5, 0.6]")), HasSubstr("has to lie inside"));
    EXPECT_THAT(refusal_of_bands(gate("bias", "band = [-1, 1]")), HasSubstr("not a list"));
    EXPECT_THAT(refusal_of_bands(gate("bias", "band = nan")), HasSubstr("finite"));
    EXPECT_THAT(refusal_of_bands(gate("lost_rays", "band = 1")), HasSubstr("share of lost rays"));
}

TEST(BandsFile, NamesPlaceAndNearestNameOfUnknownThings) {
    EXPECT_THAT(refusal_of_bands("[gates]\nalhpa = 1e-4\n"), HasSubstr("bands.toml:2:1: unknown key 'alhpa'"));
    EXPECT_THAT(refusal_of_bands("[gates]\nalhpa = 1e-4\n"), HasSubstr("Did you mean 'alpha'?"));
    EXPECT_THAT(refusal_of_bands(gate("bais", "band = 1")),
                HasSubstr("bands.toml:3:8: kind = 'bais' is unknown. Did you mean 'bias'?"));
    EXPECT_THAT(refusal_of_bands(gate("bias", "bnad = 1")), HasSubstr("Did you mean 'band'?"));
    EXPECT_THAT(refusal_of_bands(
                    "[[gate]]\nname = \"g\"\nkind = \"bias\"\nscene = \"cueb\"\nestimator = \"closed_form\"\nband = 1"),
                HasSubstr("bands.toml:4:9: scene = 'cueb' is refused"));
    EXPECT_THAT(refusal_of_bands("[[gate]]\nname = \"g\"\nkind = \"bias\"\nscene = \"cube\"\nsampler = \"sobl\"\n"
                                 "estimator = \"ray_shooting\"\nband = 1"),
                HasSubstr("Did you mean \"sobol\"?"));
}

TEST(BandsFile, RefusesKeysAndValuesUnfitForTheKind) {
    EXPECT_THAT(refusal_of_bands(gate("bias", "band = 1\nexpected = 2")), HasSubstr("it is for slope"));
    EXPECT_THAT(refusal_of_bands(gate("closure", "band = 1\npairs = \"all\"")), HasSubstr("Remove the key"));
    EXPECT_THAT(refusal_of_bands(gate("efficiency", "band = 1\nreference = 2")), HasSubstr("compared with a baseline"));
    EXPECT_THAT(refusal_of_bands(gate("std", "band = 1\nreference = 0")), HasSubstr("positive"));
    EXPECT_THAT(refusal_of_bands(gate("std", "band = 1\nreference = \"basline\"")), HasSubstr("\"baseline\""));
    EXPECT_THAT(refusal_of_bands(gate("bias", "band = 1\nreference_se = 1")), HasSubstr("belongs to a reference"));
    EXPECT_THAT(refusal_of_bands(gate("coverage", "band = 0.1\ninterval = \"wald\"\nreplicates = 5")),
                HasSubstr("one trial"));
    EXPECT_THAT(refusal_of_bands(gate("coverage", "band = 0.1\nreplicates = 1")), HasSubstr("2 to 100000"));
}

TEST(BandsFile, TakesOneNumberOfTrialsForAllSizes) {
    const auto with = [](std::string_view second) {
        return fmt::format(
            "[[gate]]\nname = \"g\"\nkind = \"bias\"\nscene = \"cube\"\nsampler = \"random\"\n"
            "estimator = \"ray_shooting\"\nband = 1\n"
            "sizes = [{{ samples_per_patch = 64, trials = 9 }}, {{ samples_per_patch = 128{} }}]\n",
            second);
    };
    EXPECT_EQ(parse_bands(with(", trials = 9"), "bands.toml", read_experiment).gates.front().trials, 9u);
    EXPECT_THAT(refusal_of_bands(with("")), HasSubstr("one number of trials"));
    EXPECT_THAT(refusal_of_bands(with(", trials = 8")), HasSubstr("bands.toml:8:"));
}

TEST(BandsFile, RefusesOptionsOutOfRange) {
    const auto with = [](std::string_view line) {
        return fmt::format("[gates]\n{}\n{}", line, gate("bias", "band = 1"));
    };
    EXPECT_EQ(refusal_of_bands(with("alpha = 0.01")), "nothing thrown");
    for (const char* line : {"alpha = 0", "alpha = 0.5", "power = 1", "power = 0.4", "looks = 0", "looks = 11",
                             "max_trials = 1", "seed = -1", "alpha = \"x\""}) {
        EXPECT_THAT(refusal_of_bands(with(line)), HasSubstr("bands.toml:2:")) << line;
    }
    EXPECT_THAT(refusal_of_bands("[gates]\n"), HasSubstr("gate: missing"));
    EXPECT_THAT(refusal_of_bands(""), HasSubstr("gate: missing"));
    EXPECT_THAT(refusal_of_bands(gate("bias", "band = 1") + gate("bias", "band = 1")), HasSubstr("used twice"));
    EXPECT_THAT(refusal_of_bands("[[gate]\n"), HasSubstr("bands.toml:1:"));
    EXPECT_THAT(refusal_of_bands("[[gate]\n"), HasSubstr("See docs/gates.md."));
}

TEST(BandsFile, AcceptsReportedQuantitiesWithTheirOwnKeysOnly) {
    const auto foreign = [](std::string_view lines) {
        return fmt::format("[[gate]]\nname = \"g\"\nquantity = \"F16\"\n{}\n", lines);
    };
    EXPECT_EQ(refusal_of_bands(foreign("kind = \"bias\"\nreference = 0.2\nband = 1e-3")), "nothing thrown");
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"std\"\nband = 0.5")), HasSubstr("reference: missing"));
    const auto with_kurtosis = [&](std::string_view kind, std::string_view kurtosis) {
        return refusal_of_bands(foreign(fmt::format("kind = \"{}\"\nband = 0.5\nkurtosis = {}", kind, kurtosis)));
    };
    EXPECT_EQ(with_kurtosis("efficiency", "3"), "nothing thrown");
    EXPECT_THAT(with_kurtosis("efficiency", "0.9"), HasSubstr("normal samples have 3"));
    EXPECT_THAT(with_kurtosis("equal", "3"), HasSubstr("it is for std, efficiency"));
    EXPECT_EQ(refusal_of_bands(foreign("kind = \"equal\"\nband = 1e-3\ncombine = \"cauchy\"\nrelative = true")),
              "nothing thrown");
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"equal\"\nband = 1e-3\ncombine = \"fisher\"")), HasSubstr("combine"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"equal\"\nband = 1e-3\ncombine = \"chi_squared\"")),
                HasSubstr("covariance: missing"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"equal\"\nband = 1e-3\ncovariance = \"c.csv\"")),
                HasSubstr("it belongs to combine"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"bias\"\nreference = 1\nreference_se = 0.1\nband = 1e-3\n"
                                         "combine = \"chi_squared\"\ncovariance = \"independent\"")),
                HasSubstr("all bins share the error of the reference"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"std_error\"\nband = 0.5\ncombine = \"chi_squared\"")),
                HasSubstr("covariances are of means"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"std_error\"\nband = 0.5\nrelative = true")), HasSubstr("relative"));
    EXPECT_THAT(refusal_of_bands(gate("equal", "band = 1")), HasSubstr("quantity"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"closure\"\nreference = 1\nband = 1e-3")),
                HasSubstr("bias, std, equal"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"bias\"\nreference = \"baseline\"\nband = 1e-3")),
                HasSubstr("Give a number"));
    EXPECT_THAT(refusal_of_bands(foreign("kind = \"bias\"\nscene = \"cube\"\nreference = 1\nband = 1")),
                HasSubstr("unknown key"));
}

TEST(BandsFile, RefusesGatesThatNeedARunWithoutExperiments) {
    EXPECT_THAT([] { static_cast<void>(parse_bands(gate("bias", "band = 1e-3"), "bands.toml", nullptr)); },
                testing::ThrowsMessage<UserError>(HasSubstr("it runs nothing")));
}

TEST(BandsFile, ReadsDistributionsAndAnytimeGates) {
    const auto reported = [](std::string_view lines) {
        return fmt::format("[[gate]]\nname = \"g\"\nquantity = \"x\"\nband = 0.1\n{}\n", lines);
    };
    const auto read = [&](std::string_view lines) {
        return parse_bands(reported(lines), "bands.toml", nullptr).gates.front();
    };
    const Gate known = read("kind = \"distribution\"\nreference = \"normal(1, 2)\"");
    ASSERT_TRUE(known.law);
    EXPECT_EQ(known.law->second, 2);
    EXPECT_EQ(known.band, (Band{0, 0.1}));
    EXPECT_EQ(read("kind = \"distribution\"").against, Against::file);
    const Gate bounded = read("kind = \"bias\"\nreference = 0.5\nanytime = \"bounded\"\nbounds = [0, 1]");
    EXPECT_EQ(bounded.anytime, Anytime::bounded);
    EXPECT_EQ(bounded.bounds, (Band{0, 1}));
    EXPECT_THAT(refusal_of_bands(reported("kind = \"distribution\"\nreference = \"normal\"")),
                HasSubstr("fitted to the values"));
    EXPECT_THAT(refusal_of_bands(reported("kind = \"distribution\"\ncombine = \"holm\"")), HasSubstr("one comparison"));
    EXPECT_THAT(refusal_of_bands(reported("kind = \"bias\"\nreference = 1\nanytime = \"bounded\"")),
                HasSubstr("missing"));
    EXPECT_THAT(refusal_of_bands(reported("kind = \"bias\"\nanytime = \"normal\"")), HasSubstr("exact reference"));
    EXPECT_THAT(refusal_of_bands(reported("kind = \"bias\"\nreference = 1\nbounds = [0, 1]")),
                HasSubstr("belongs to 'anytime'"));
    EXPECT_THAT(refusal_of_bands(reported("kind = \"equal\"\nreference = 1")), HasSubstr("has none"));
}

}  // namespace
}  // namespace ff::studies::gates
