#include "studies/readers/printable.hpp"

#include <gtest/gtest.h>

#include <string>

namespace ff::studies {
namespace {

TEST(Printable, EscapesCharactersThatMoveOrHideText) {
    EXPECT_EQ(visible_text("a\x1b[31m\n\x7f"), "a\\x1b[31m\\x0a\\x7f");
    EXPECT_EQ(visible_text("a\u202eb\u2028c\u009b\u2066\ufeff"), "a\\u202eb\\u2028c\\u009b\\u2066\\ufeff");
    EXPECT_EQ(visible_text(std::string("\xff\0\xe2\x80", 4)), "\\xff\\x00\\xe2\\x80");
    EXPECT_EQ(visible_text("Σ of face 1, žluťoučký, 面 🙂"), "Σ of face 1, žluťoučký, 面 🙂");
}

TEST(Printable, FindsTheFirstByteOfInvalidUtf8) {
    EXPECT_EQ(find_no_utf8("Σ"), std::string::npos);
    EXPECT_EQ(find_no_utf8("Σ\xff"), 2U);
    EXPECT_EQ(find_no_utf8("a\xc0\x80"), 1U) << "an overlong form";
    EXPECT_EQ(find_no_utf8("a\xed\xa0\x80"), 1U) << "a surrogate";
}

TEST(Printable, RefusesNamesThatSpreadsheetsReadAsFormulas) {
    for (const char* name : {"=1", "=x", "@SUM(A1)", "+1+1", "-2*3", "+cmd(1)", "-A1:B2", "+\"x\""})
        EXPECT_NE(problem_with_name(name), "") << name;
    for (const char* name : {"+x", "-x", "-z wall", "+1.5", "-1e-5", "a=b", "x@y", "1+1", ""})
        EXPECT_EQ(problem_with_name(name), "") << name;
}

TEST(Printable, RefusesNamesThatPicturesCannotHave) {
    EXPECT_NE(problem_with_name("__proto__"), "");
    EXPECT_EQ(problem_with_name("proto"), "");
}

}  // namespace
}  // namespace ff::studies
