#include "studies/spec/study_difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ff::studies {
namespace {

const std::string study_section = "[study]\nname = \"s\"\ntrials = 3\n";
const std::string method_a =
    "\n[[method]]\nname = \"a\"\nsampler = \"random\"\nsizes = [\n    { patches_per_face = 1 },\n]\n";
const std::string method_b =
    "\n[[method]]\nname = \"b\"\nsampler = \"sobol\"\nsizes = [\n    { patches_per_face = 4 },\n]\n";

TEST(StudyDifference, NamesSectionKeyAndBothValues) {
    EXPECT_EQ(first_difference(study_section + method_a, study_section + method_a), "");
    EXPECT_EQ(first_difference("[study]\ntrials = 3\n", "[study]\ntrials = 4\n"),
              "[study]: 'trials = 3' there, 'trials = 4' here");
}

TEST(StudyDifference, NamesWhatOnlyOneStudyHas) {
    EXPECT_EQ(first_difference(study_section, study_section + "level = 0.9\n"),
              "[study]: no 'level' there, 'level = 0.9' here");
    EXPECT_EQ(first_difference(study_section + "\n[radiosity]\nemission = [1]\n", study_section),
              "[radiosity]: 'emission = [1]' there, no 'emission' here");
}

TEST(StudyDifference, MatchesMethodsByNameAndJoinsLines) {
    std::string changed = method_b;
    changed.replace(changed.find('4'), 1, "9");
    EXPECT_EQ(
        first_difference(study_section + method_a + method_b, study_section + method_a + changed),
        "[[method]] \"b\": 'sizes = [{ patches_per_face = 4 },]' there, 'sizes = [{ patches_per_face = 9 },]' here");
    EXPECT_EQ(first_difference(study_section + method_a, study_section + method_a + method_b),
              "[[method]] \"b\": no 'name' there, 'name = \"b\"' here, and in 2 more keys");
    EXPECT_EQ(first_difference(study_section + method_a + method_b, study_section + method_b + method_a),
              "the order of its methods");
}

TEST(StudyDifference, ShowsOnlyTheSurroundingsOfADifferenceInLongValues) {
    const std::string begin = "[study]\nscene = [\"" + std::string(500, 'x');
    EXPECT_THAT(first_difference(begin + "1\"]\n", begin + "2\"]\n"),
                testing::AllOf(testing::HasSubstr("'scene = ...xxx"), testing::HasSubstr("x1\"]' there"),
                               testing::HasSubstr("x2\"]' here")));
}

}  // namespace
}  // namespace ff::studies
