#include "core/support/excerpt.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

TEST(Excerpt, IsAllOfAShortText) {
    EXPECT_EQ(excerpt(""), "");
    EXPECT_EQ(excerpt(std::string(200, 'x')), std::string(200, 'x'));
}

TEST(Excerpt, EndsBetweenCharacters) {
    EXPECT_EQ(excerpt(std::string(201, 'x')), std::string(200, 'x') + "…");
    EXPECT_EQ(excerpt(std::string(199, 'x') + "éé"), std::string(199, 'x') + "…");
    EXPECT_EQ(excerpt(std::string(198, 'x') + "éé"), std::string(198, 'x') + "é…");
}

}  // namespace
}  // namespace ff
