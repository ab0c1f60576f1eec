#include "studies/spec/spec.hpp"

#include "core/support/error.hpp"
#include "samplers/sampler.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

namespace ff::studies {
namespace {

using test::random_rays;
using test::study_text;
using testing::HasSubstr;

std::string refusal_of_study(std::string_view text) {
    return test::message_of<UserError>([&] { static_cast<void>(parse_study(text, "study.toml")); });
}

struct Wrong {
    std::string_view name;
    std::string_view study;    ///< lines of [study]
    std::string_view methods;  ///< the rest of the file
    std::string_view place;    ///< line:column
    std::string_view problem;  ///< what the message has to say
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name
void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << wrong.name;
}

/// The study's own lines begin in line 5, the methods in line 6.
constexpr std::array wrong_studies{
    Wrong{"unknown key", "trails = 10", random_rays, "5:1",
          "unknown key 'trails' (it would be ignored). Did you mean 'trials'?"},
    Wrong{"no trials at all", "", random_rays, "1:1", "trials: missing"},
    Wrong{"zero trials", "trials = 0", random_rays, "5:10", "trials = 0 (nothing would be run). Try 64."},
    Wrong{"one trial", "trials = 1", random_rays, "5:10",
          "trials = 1 (a confidence interval needs at least 2). Try 64."},
    Wrong{"negative trials", "trials = -5", random_rays, "5:10", "trials = -5 (not a whole number"},
    Wrong{"half a trial", "trials = 2.5", random_rays, "5:10", "trials = 2.5 (not a whole number"},
    Wrong{"trials as text", "trials = \"64\"", random_rays, "5:10", "not a whole number"},
    Wrong{"too many trials", "trials = 4294967297", random_rays, "5:10", "at most 4294967296"},
    Wrong{"level of one", "trials = 9\nlevel = 1.0", random_rays, "6:9", "but not always"},
    Wrong{"level below one half", "trials = 9\nlevel = 0.3", random_rays, "6:9", "more often than not"},
    Wrong{"power of zero", "trials = 9\npower = 0", random_rays, "6:9", "at least 0.5"},
    Wrong{"power of one", "trials = 9\npower = 1.0", random_rays, "6:9", "no finite number of trials"},
    Wrong{"margin of zero", "trials = 9\nequivalence_margin = 0.0", random_rays, "6:22", "bias of exactly 0"},
    Wrong{"infinite margin", "trials = 9\nequivalence_margin = inf", random_rays, "6:22", "not a finite number"},
    Wrong{"malformed TOML", "trials = = 9", random_rays, "5:10", "docs/study-files.md"},
    Wrong{"no method", "trials = 9", "", "1:1", "method: missing (nothing would be run)"},
    Wrong{"method that is no list", "trials = 9", "[method]\nname = \"SR\"", "6:1", "Write [[method]]"},
    Wrong{"unknown section", "trials = 9", "[publisched]\ntables = \"t.json\"", "6:2", "Did you mean 'published'?"},
    Wrong{"published without tables", "trials = 9", "[[method]]\nname=\"e\"\nestimator=\"closed_form\"\n[published]",
          "9:1", "tables: missing"},
};

constexpr std::array wrong_methods{
    Wrong{"unknown key", "", "sampler = \"random\"\nsample_per_patch = 10", "10:1",
          "Did you mean 'samples_per_patch'?"},
    Wrong{"unknown sampler", "", "sampler = \"sobool\"\nsamples_per_patch = 16", "9:11", "sobol"},
    Wrong{"no sampler", "", "samples_per_patch = 16", "6:1", "sampler: missing"},
    Wrong{"unknown completion", "", "sampler = \"random\"\nsamples_per_patch = 16\ncompletion = \"reciprokal\"",
          "11:14", "Did you mean 'reciprocal'? Known: direct, reciprocal."},
    Wrong{"unknown allocation", "", "sampler = \"random\"\nsamples_per_patch = 16\nallocation = \"faces\"", "11:14",
          "Did you mean 'face'?"},
    Wrong{"no samples", "", "sampler = \"random\"", "6:1", "samples_per_patch: missing"},
    Wrong{"zero samples", "", "sampler = \"random\"\nsamples_per_patch = 0", "10:21", "samples_per_patch = 0"},
    Wrong{"negative samples", "", "sampler = \"random\"\nsamples_per_patch = -1", "10:21", "not a whole number"},
    Wrong{"no size in a list", "", "sampler = \"random\"\nsamples_per_patch = []", "10:21", "an empty list"},
    Wrong{"a sequence that is too long", "", "sampler = \"random\"\nsamples_per_patch = 4294967297", "10:21",
          "at most 4294967296 points"},
    Wrong{"patches that are not square", "", "sampler = \"random\"\nsamples_per_patch = 16\npatches_per_face = 10",
          "11:20", "10 is not a square; faces are divided into m x m patches). Try 9 or 16."},
    Wrong{"no patches", "", "sampler = \"random\"\nsamples_per_patch = 16\npatches_per_face = [4, 0]", "11:20",
          "1 to 1048576 patches"},
    Wrong{"nodes for rays", "", "sampler = \"random\"\nsamples_per_patch = 16\nnodes = 5", "11:9",
          "only quadrature rules have nodes"},
    Wrong{"weighted points as rays", "", "sampler = \"gauss_legendre\"\nnodes = 5", "9:11", "unequal weights"},
    Wrong{"a size for each and for all", "",
          "sampler = \"random\"\nsamples_per_patch = 16\nsizes = [{ samples_per_patch = 9 }]", "10:21",
          "beside 'sizes'"},
    Wrong{"no sizes", "", "sampler = \"random\"\nsizes = []", "10:9", "an empty list"},
    Wrong{"an unknown key of a size", "", "sampler = \"random\"\nsizes = [{ samples_per_patch = 9, trial = 2 }]",
          "10:35", "Did you mean 'trials'?"},
    Wrong{"one trial of a size", "", "sampler = \"random\"\nsizes = [{ samples_per_patch = 9, trials = 1 }]", "10:44",
          "needs at least 2"},
    Wrong{"the same size twice", "", "sampler = \"random\"\nsamples_per_patch = [9, 16, 9]", "7:8",
          "has the same size twice"},
};

class WrongStudy : public testing::TestWithParam<Wrong> {};

TEST_P(WrongStudy, IsRefusedWithPlaceProblemAndSuggestion) {
    const std::string message = refusal_of_study(study_text(GetParam().study, GetParam().methods));
    EXPECT_THAT(message, testing::StartsWith("study.toml:" + std::string(GetParam().place) + ": "));
    EXPECT_THAT(message, HasSubstr(std::string(GetParam().problem)));
    EXPECT_THAT(message, testing::Not(HasSubstr("''")));
}

INSTANTIATE_TEST_SUITE_P(Spec, WrongStudy, testing::ValuesIn(wrong_studies));

class WrongMethod : public testing::TestWithParam<Wrong> {};

/// The method begins in line 6; its lines after the estimator in line 9.
TEST_P(WrongMethod, IsRefusedWithPlaceProblemAndSuggestion) {
    const std::string method =
        "[[method]]\nname = \"SR\"\nestimator = \"ray_shooting\"\n" + std::string(GetParam().methods);
    const std::string message = refusal_of_study(study_text("trials = 9", method));
    EXPECT_THAT(message, testing::StartsWith("study.toml:" + std::string(GetParam().place) + ": "));
    EXPECT_THAT(message, HasSubstr(std::string(GetParam().problem)));
    EXPECT_THAT(message, testing::Not(HasSubstr("''")));
}

INSTANTIATE_TEST_SUITE_P(Spec, WrongMethod, testing::ValuesIn(wrong_methods));

TEST(Spec, AcceptsTheStudyThatTheWrongOnesAreMadeFrom) {
    EXPECT_EQ(refusal_of_study(study_text("trials = 9", random_rays)), "nothing thrown");
}

TEST(Spec, RefusesSizesThatTheSamplerCannotMake) {
    std::size_t refused = 0;
    for (const auto& entry : samplers::catalogue()) {
        if (entry.info.sizes == samplers::Sizes::nodes) continue;
        const std::string message = refusal_of_study(
            study_text("trials = 9", "[[method]]\nname = \"a\"\nestimator = \"ray_shooting\"\nsampler = \"" +
                                         std::string(entry.info.name) + "\"\nsamples_per_patch = 624"));
        const auto problem = samplers::check_size(entry.info, 624);
        EXPECT_EQ(message == "nothing thrown", !problem.fatal) << message;
        if (!problem.fatal) continue;
        ++refused;
        EXPECT_THAT(message, testing::StartsWith("study.toml:10:21: samples_per_patch = 624"));
        EXPECT_THAT(message, HasSubstr("625"));
    }
    EXPECT_GE(refused, 1u);
}

TEST(Spec, SizesASequenceForTheWholeFaceIfOneServesIt) {
    const auto refusal_of = [](std::string_view allocation) {
        return refusal_of_study(
            study_text("trials = 9",
                       "[[method]]\nname = \"a\"\nestimator = \"ray_shooting\"\nsampler = \"random\"\n"
                       "patches_per_face = 4\nsamples_per_patch = 2147483648\nallocation = \"" +
                           std::string(allocation) + "\""));
    };
    EXPECT_EQ(refusal_of("patch"), "nothing thrown");
    EXPECT_THAT(refusal_of("face"),
                HasSubstr("study.toml:11:21: samples_per_patch = 2147483648 (a sequence has at most"));
}

TEST(Spec, RefusesASharedSequenceWhosePartsAreBiased) {
    std::size_t refused = 0;
    for (const auto& entry : samplers::catalogue()) {
        if (entry.info.sizes != samplers::Sizes::fourth_power) continue;
        ++refused;
        EXPECT_THAT(
            refusal_of_study(study_text(
                "trials = 9", "[[method]]\nname = \"a\"\nestimator = \"ray_shooting\"\nsampler = \"" +
                                  std::string(entry.info.name) + "\"\nsamples_per_patch = 16\nallocation = \"face\"")),
            HasSubstr("study.toml:11:14: allocation = 'face' (each point"));
    }
    EXPECT_GE(refused, 1u);
}

TEST(Spec, RefusesNodesOutOfRange) {
    const auto message = [](std::string_view nodes) {
        return refusal_of_study(study_text("trials = 9",
                                           "[[method]]\nname = \"PDM\"\nsampler = \"gauss_legendre\"\nestimator = "
                                           "\"area_kernel\"\nnodes = " +
                                               std::string(nodes)));
    };
    EXPECT_EQ(message("64"), "nothing thrown");
    EXPECT_EQ(message("[1, 64]"), "nothing thrown");
    EXPECT_THAT(message("0"), HasSubstr("study.toml:10:9: nodes = 0 (1 to 64 nodes a side are possible). Try 5."));
    EXPECT_THAT(message("[5, 65]"), HasSubstr("1 to 64 nodes"));
    EXPECT_THAT(message("[5, 5, 5]"), HasSubstr("source and target patch"));
    EXPECT_THAT(message("5\nsamples_per_patch = 10"), HasSubstr("takes no samples"));
    EXPECT_THAT(message("5\nallocation = \"face\""),
                HasSubstr("only ray_shooting, point_to_polygon and visible_polygon have it"));
}

TEST(Spec, PutsThePointsOfPointToPolygonOnTheSourceAlone) {
    const auto text = [](std::string_view lines) {
        return study_text("trials = 9",
                          "[[method]]\nname = \"p\"\nestimator = \"point_to_polygon\"\n" + std::string(lines));
    };
    const Method nodes = parse_study(text("sampler = \"gauss_legendre\"\nnodes = 5"), "study.toml").methods.front();
    EXPECT_EQ(nodes.nodes, (Nodes{5, 0}));
    EXPECT_THAT(refusal_of_study(text("sampler = \"gauss_legendre\"\nnodes = [5, 6]")),
                HasSubstr("study.toml:10:9: nodes = [ 5, 6 ] (point_to_polygon has points of two coordinates)"));
    EXPECT_THAT(refusal_of_study(text("sampler = \"gauss_legendre\"\nnodes = 5\nallocation = \"face\"")),
                HasSubstr("the nodes of a rule belong to one patch"));
    EXPECT_EQ(refusal_of_study(text("sampler = \"stratified\"\nsamples_per_patch = 25")), "nothing thrown")
        << "5 x 5 cells";
    EXPECT_THAT(refusal_of_study(text("sampler = \"stratified\"\nsamples_per_patch = 26")),
                HasSubstr("25 = 5^2 or 36 = 6^2"));
    EXPECT_EQ(refusal_of_study(text("sampler = \"sobol\"\nsamples_per_patch = 16\nallocation = \"face\"")),
              "nothing thrown");
    EXPECT_THAT(refusal_of_study(text("sampler = \"sobol\"\nsamples_per_patch = 16\ntracer = \"box\"")),
                HasSubstr("only ray_shooting, hemicube, cubic_tetrahedron and single_plane have it"));
}

TEST(Spec, TakesTheResolutionOfAProjection) {
    const auto text = [](std::string_view estimator, std::string_view size) {
        return study_text("trials = 9", "[[method]]\nname = \"p\"\nestimator = \"" + std::string(estimator) + "\"\n" +
                                            std::string(size));
    };
    const auto samples = [&](std::string_view estimator) {
        const Method method = parse_study(text(estimator, "resolution = [16, 32]"), "study.toml").methods.front();
        return std::pair(method.sizes.at(0).samples_per_patch, method.sizes.at(1).samples_per_patch);
    };
    EXPECT_EQ(samples("hemicube"), std::pair(std::optional<std::uint64_t>(768), std::optional<std::uint64_t>(3072)));
    EXPECT_EQ(samples("cubic_tetrahedron").second, 1488u);
    EXPECT_EQ(samples("single_plane").first, 256u);
    EXPECT_EQ(parse_study(text("hemicube", "sizes = [{ patches_per_face = 4, resolution = 512 }]"), "study.toml")
                  .methods.front()
                  .sizes.front()
                  .samples_per_patch,
              786432u);
    for (const char* none : {"resolution = 7", "resolution = 0", "resolution = 1000000000000"})
        EXPECT_THAT(refusal_of_study(text("hemicube", none)), HasSubstr("hemicube has no resolution")) << none;
    EXPECT_THAT(refusal_of_study(text("hemicube", "resolution = 16\nsamples_per_patch = 768")), HasSubstr("Keep one."));
    EXPECT_THAT(refusal_of_study(text("ray_shooting", "sampler = \"random\"\nresolution = 16")),
                HasSubstr("ray_shooting has none"));
}

TEST(Spec, AcceptsAMapForTheAreaKernelOnly) {
    const auto text = [](std::string_view estimator, std::string_view map) {
        return study_text("trials = 9",
                          "[[method]]\nname = \"a\"\nsampler = \"random\"\nsamples_per_patch = 4\n"
                          "map = \"" +
                              std::string(map) + "\"\nestimator = \"" + std::string(estimator) + "\"");
    };
    EXPECT_EQ(parse_study(text("area_kernel", "graded"), "study.toml").methods.front().map, PointMap::graded);
    EXPECT_THAT(refusal_of_study(text("ray_shooting", "graded")),
                HasSubstr("study.toml:10:7: map = 'graded' (only area_kernel"));
    EXPECT_THAT(refusal_of_study(text("area_kernel", "grated")), HasSubstr("Did you mean 'graded'?"));
}

TEST(Spec, RefusesAClosedFormWithASampler) {
    EXPECT_THAT(refusal_of_study(study_text("trials = 9",
                                            "[[method]]\nname = \"e\"\nestimator = \"closed_form\"\nsampler = "
                                            "\"random\"")),
                HasSubstr("evaluates a formula at no points"));
}

TEST(Spec, RefusesTwoMethodsWithTheSameName) {
    EXPECT_THAT(refusal_of_study(study_text("trials = 9", std::string(random_rays) + std::string(random_rays))),
                testing::AllOf(HasSubstr("study.toml:12:8: name = "), HasSubstr("is used twice")));
}

TEST(Spec, RefusesAnUnknownOrMissingEstimator) {
    EXPECT_THAT(refusal_of_study(study_text("trials = 9", "[[method]]\nname = \"a\"\nestimator = \"ray_shoting\"")),
                HasSubstr("Did you mean 'ray_shooting'? Known: ray_shooting, global_lines, area_kernel, "));
    EXPECT_THAT(refusal_of_study(study_text("trials = 9", "[[method]]\nname = \"a\"")),
                HasSubstr("Choose one of ray_shooting"));
}

TEST(Spec, DoesNotSuggestControlTracers) {
    const std::string method = "[[method]]\nname = \"a\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n";
    EXPECT_THAT(refusal_of_study(study_text("trials = 9", method + "tracer = \"leakey\"\n")),
                HasSubstr("is unknown. Known: automatic, box, embree."));
}

TEST(Spec, MakesNoSuggestionWithoutANearName) {
    const auto unlike = refusal_of_study(study_text("trials = 9\nqwertzuiop = 1", random_rays));
    EXPECT_THAT(unlike, HasSubstr("unknown key 'qwertzuiop'"));
    EXPECT_THAT(unlike, testing::Not(HasSubstr("''")));
    const auto choice =
        refusal_of_study(study_text("trials = 9", std::string(random_rays) + "completion = \"qwertzuiop\""));
    EXPECT_THAT(choice, HasSubstr("Known: direct, reciprocal"));
    EXPECT_THAT(choice, testing::Not(HasSubstr("''")));
}

TEST(Spec, RefusesScenesThatDoNotExist) {
    const auto message = [](std::string_view scene) {
        return refusal_of_study("[study]\nname = \"t\"\ntrials = 9\nseed = 1\nscene = " + std::string(scene) + "\n" +
                                std::string(random_rays));
    };
    EXPECT_EQ(message("[\"cube\", \"box:1x2x3\"]"), "nothing thrown");
    EXPECT_THAT(message("\"cub\""), HasSubstr("study.toml:5:9: scene = "));
    EXPECT_THAT(message("\"box:1x-2x3\""), HasSubstr("finite, positive length"));
    EXPECT_THAT(message("[\"cube\", \"cube\"]"), HasSubstr("names a scene twice"));
    EXPECT_THAT(message("[\"cube\", \"box:6x6x6\"]"), HasSubstr("names a scene twice"));
    EXPECT_THAT(message("[]"), HasSubstr("an empty list"));
    EXPECT_THAT(message("7"), HasSubstr("not a text"));
}

TEST(Spec, RefusesNamesThatWouldBreakTablesOrFolders) {
    const auto method = [](std::string_view name) {
        return refusal_of_study(
            study_text("trials = 9", "[[method]]\nestimator = \"closed_form\"\nname = \"" + std::string(name) + "\""));
    };
    EXPECT_EQ(method("a/b, c"), "nothing thrown");
    EXPECT_THAT(method("a|b"), HasSubstr("would break tables"));
    EXPECT_THAT(method("a\\nb"), HasSubstr("would break tables"));
    const auto study = [](const std::string& name, const std::string& scene = "cube") {
        return refusal_of_study("[study]\nscene = \"" + scene + "\"\nseed = 1\ntrials = 9\nname = \"" + name + "\"\n" +
                                std::string(random_rays));
    };
    EXPECT_THAT(study("a", "a|b.obj"), HasSubstr("would break tables"));
    EXPECT_EQ(study("a b"), "nothing thrown");
    EXPECT_THAT(study("a|b"), HasSubstr("would break tables"));
    EXPECT_THAT(study("../x"), HasSubstr("names the folder"));
    EXPECT_THAT(study(".x"), HasSubstr("names the folder"));
    EXPECT_THAT(study("x\"\ntitle = \"a\\n## b"), HasSubstr("would break reports"));
    EXPECT_THAT(study("x\"\ntitle = \"a\\u0000b"), HasSubstr("would break reports"));
    EXPECT_EQ(study("x\"\ntitle = \"|a| <b> [c]"), "nothing thrown");
}

TEST(Spec, RefusesANegativeSeed) {
    EXPECT_THAT(
        refusal_of_study("[study]\nname = \"t\"\ntrials = 9\nseed = -1\nscene = \"cube\"\n" + std::string(random_rays)),
        HasSubstr("study.toml:4:8: seed = -1 (not a whole number from 0 up)"));
}

TEST(Spec, ListsFormAProduct) {
    const StudySpec spec =
        parse_study(study_text("trials = 9",
                               "[[method]]\nname = \"a\"\nestimator = \"ray_shooting\"\nsampler = \"random\"\n"
                               "patches_per_face = [1, 4]\nsamples_per_patch = [10, 20, 30]"),
                    "study.toml");
    ASSERT_EQ(spec.methods.front().sizes.size(), 6u);
    EXPECT_EQ(spec.methods.front().sizes[4], (Size{4, 20, std::nullopt}));
}

TEST(Spec, DefaultsAreDirectPatchAndNinetyFivePercent) {
    const StudySpec spec = parse_study(study_text("trials = 9", random_rays), "study.toml");
    EXPECT_EQ(spec.title, "test");
    EXPECT_EQ(spec.level, 0.95);
    EXPECT_EQ(spec.power, 0.9);
    EXPECT_EQ(spec.equivalence_margin, std::nullopt);
    EXPECT_EQ(spec.methods.front().completion, Completion::direct);
    EXPECT_EQ(spec.methods.front().allocation, Allocation::patch);
    EXPECT_EQ(spec.methods.front().sizes.front(), (Size{1, 10, std::nullopt}));
}

}  // namespace
}  // namespace ff::studies
