#include "studies/outside/outside_code.hpp"

#include "core/support/error.hpp"
#include "studies/spec/spec.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ff::studies {
namespace {

std::string study(const std::string& sampler, const std::string& line = "") {
    return "[study]\nname = \"s\"\nscene = \"cube\"\ntrials = 4\nseed = 1\n" + line +
           "\n[[method]]\nname = \"m\"\nsampler = \"" + sampler +
           "\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 16\n";
}

TEST(OutsideCode, IsFoundInStudiesAndBandsWithItsPlace) {
    const auto found = outside_code(study("command:./mine {n}", "plugins = [\"a.so\", \"b.so\"]"), "s.toml");
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].text, "a.so");
    EXPECT_EQ(found[0].place, "s.toml:6:11");
    EXPECT_EQ(found[1].text, "b.so");
    EXPECT_EQ(found[2].kind, OutsideCode::Kind::sampler);
    EXPECT_EQ(found[2].text, "command:./mine {n}");
    EXPECT_EQ(found[2].place, "s.toml:9:11");
    EXPECT_EQ(outside_code("[gates]\nplugins = \"a.so\"\n[[gate]]\nsampler = \"command:x\"\n", "b.toml").size(), 2u);
    EXPECT_TRUE(outside_code(study("sobol"), "s.toml").empty());
}

TEST(OutsideCode, IsNotRunByReadingAStudy) {
    const test::TemporaryFolder folder;
    const auto mark = folder.path() / "outside_code_was_run";
    const std::string text = study("command:touch " + mark.string());
    EXPECT_THROW(parse_study(text, "s.toml"), UserError);
    for (const auto& code : outside_code(text, "s.toml")) admit(code, {});
    EXPECT_EQ(parse_study(text, "s.toml").methods.front().sampler, "command:touch " + mark.string());
    EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST(Command, IsNamedAfterTheFilesAmongItsWords) {
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    const auto write = [&](const std::string& text) { std::ofstream(folder / "script of mine") << text; };
    write("one");
    const std::string command = "command:python3 'script of mine' {n}";
    const std::string first = full_command_name(command, folder);
    EXPECT_EQ(first.substr(0, command.size() + 1), command + "#");
    EXPECT_EQ(full_command_name(first, folder), first);
    write("two");
    EXPECT_NE(full_command_name(command, folder), first);
    EXPECT_THROW(load_command_sampler(first, folder), UserError);
    EXPECT_EQ(full_command_name("command:python3 {n}", folder), "command:python3 {n}");
    for (const char* wrong : {"command:", "command:  ", "command:a 'b", "command:a | b", "command:a\nb"})
        EXPECT_THROW(full_command_name(wrong, folder), UserError) << wrong;
}

TEST(Command, IsDeterministicWithoutASeed) {
    EXPECT_FALSE(load_command_sampler("command:echo {n} {d}", {}).info.randomised);
    EXPECT_TRUE(load_command_sampler("command:echo {n} {seed}", {}).info.randomised);
    EXPECT_TRUE(load_command_sampler("command:echo {n} {trial}", {}).info.randomised);
}

TEST(CommandEstimator, DeclaresItselfByItsPlaceholders) {
    const EstimatorInfo& fixed = load_command_estimator("command:echo {scene}", {}).info;
    EXPECT_FALSE(fixed.own_points);
    EXPECT_FALSE(fixed.randomised);
    const EstimatorInfo& sampled = load_command_estimator("command:echo {vs3} {samples} {seed}", {}).info;
    EXPECT_TRUE(sampled.own_points);
    EXPECT_TRUE(sampled.randomised);
    EXPECT_EQ(find_estimator("command:echo {scene}").info.name, "command:echo {scene}");
    EXPECT_THROW(load_command_estimator("command:echo {seed}", {}), UserError);
    EXPECT_EQ(outside_code("[[method]]\nestimator = \"command:x {scene}\"\n", "s.toml").front().kind,
              OutsideCode::Kind::estimator);
}

}  // namespace
}  // namespace ff::studies
