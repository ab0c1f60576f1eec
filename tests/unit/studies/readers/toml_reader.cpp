#include "studies/readers/toml_reader.hpp"

#include "core/support/error.hpp"
#include "studies/spec/spec.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>

namespace ff::studies {
namespace {

using test::study_text;
using testing::HasSubstr;

std::string refusal(std::string_view text) {
    return test::message_of<UserError>([&] { static_cast<void>(parse_study(text, "study.toml")); });
}

// Each part of a key is a table in a table, and those are removed by recursion.
TEST(ParseToml, RefusesKeysOfManyParts) {
    const auto repeated = [](std::string_view part, std::size_t times) {
        std::string text(part);
        for (std::size_t i = 1; i < times; ++i) text += "." + std::string(part);
        return text;
    };
    constexpr std::size_t many = 100'000;
    for (const std::string_view part : {"a", "a ", "'#'", R"("\"=")", "\t\"\""}) {
        for (const auto& [before, after] :
             {std::pair("", " = 1\n"), {"[", "]\n"}, {"[[", "]]\n"}, {"b = {", " = 1}\n"}}) {
            EXPECT_THAT(refusal("# 1.2\n" + std::string(before) + repeated(part, many) + after),
                        testing::StartsWith("study.toml:2: a key of more than 33 parts"))
                << part << before;
        }
    }
    // Strings, comments and numbers may contain any number of points, whatever else is in them.
    const std::string dots(many, '.');
    for (const std::string& fine :
         {"# " + dots + "'\na = \"" + dots + "\\\"" + dots + "\" # \"" + dots, "a = '" + dots + "\\'",
          "a = [" + repeated("1, 0", many) + "]", "a = \"\"\"" + dots + "\n\\\"\"\"" + dots + "\"\"\"\"\"",
          "a = '''" + dots + "\n\\''" + dots + "\n''''"})
        EXPECT_THAT(refusal(fine), HasSubstr("unknown key 'a'")) << fine.substr(0, 10);
}

TEST(TomlReader, QuotesOnlyTheBeginningOfALongText) {
    const std::string text(1'000'000, 'x');
    std::string list = "[1";
    for (int i = 0; i < 100'000; ++i) list += ", 1";
    const std::string method = "[[method]]\nname = \"a\"\nestimator = ";
    for (const std::string& wrong :
         {study_text(text + " = 1", test::random_rays), study_text("trials = " + list + "]", test::random_rays),
          study_text("trials = \"" + text + "\"", test::random_rays),
          study_text("trials = 9", method + "\"" + text + "\"\n"),
          study_text("trials = 9", method + "\"ray_shooting\"\nsampler = \"" + text + "\"\n"),
          "[study]\nname = \"x\"\nscene = \"" + text + "\"\n"}) {
        const std::string message = refusal(wrong);
        EXPECT_THAT(message, testing::StartsWith("study.toml:"));
        EXPECT_LT(message.size(), 2000u) << message.substr(0, 300);
    }
}

}  // namespace
}  // namespace ff::studies
