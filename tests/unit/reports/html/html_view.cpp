#include "reports/html/html_view.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff::reports {
namespace {

TEST(SecurityPolicy, AllowsStylesAndScriptsByTheirHash) {
    // printf abc | openssl dgst -sha256 -binary | base64
    const std::array<std::string_view, 1> styles{"abc"};
    const std::array<std::string_view, 1> scripts{""};
    EXPECT_EQ(security_policy(styles, scripts),
              "default-src 'none'; style-src 'sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0='; "
              "script-src 'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='; base-uri 'none'; form-action 'none'");
}

TEST(SecurityPolicy, AllowsNothingByDefault) {
    EXPECT_EQ(security_policy({}, {}),
              "default-src 'none'; style-src 'none'; script-src 'none'; base-uri 'none'; form-action 'none'");
}

}  // namespace
}  // namespace ff::reports
