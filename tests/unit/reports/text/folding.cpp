#include "reports/text/folding.hpp"

#include <gtest/gtest.h>

#include <string>

namespace ff::reports {
namespace {

TEST(Folded, BreaksLinesBetweenWords) {
    EXPECT_EQ(folded("one two three\nfour\n", 8), "one two\nthree\nfour\n");
    EXPECT_EQ(folded("unbreakable word", 4), "unbreakable\nword");
    EXPECT_EQ(folded("short\n\n  and indented, though not by much", 20),
              "short\n\n  and indented,\n  though not by much");
}

TEST(Folded, IndentsContinuationLinesOfADescription) {
    EXPECT_EQ(folded("sobol   points of a net, scrambled", 20), "sobol   points of a\n        net,\n        scrambled");
    EXPECT_EQ(folded("a name that takes most of it  text", 30), "a name that takes most of it\n    text");
}

TEST(Folded, CountsVisibleCharactersOnly) {
    EXPECT_EQ(folded("\033[32mnone\033[0m Šidák", 10), "\033[32mnone\033[0m Šidák");
    EXPECT_EQ(visible_length("\033[32mnone\033[0m Šidák"), 10u);
}

TEST(Folded, LeavesOtherTextAsItIs) {
    const std::string text = "a  b\n\n   c d  \n";
    EXPECT_EQ(folded(text, 80), text);
    EXPECT_EQ(folded("", 80), "");
}

}  // namespace
}  // namespace ff::reports
