#include "core/support/error.hpp"
#include "samplers/sampler.hpp"

#include <gmock/gmock.h>

namespace ff::samplers {
namespace {

std::string message_for(std::string_view name) {
    try {
        find(name);
    } catch (const UserError& error) {
        return error.what();
    }
    return "found";
}

TEST(Find, KnowsEverySamplerOfTheCatalogue) {
    for (const CatalogueEntry& sampler : catalogue()) EXPECT_EQ(find(sampler.info.name).info.name, sampler.info.name);
}

TEST(Find, SuggestsTheNearestName) {
    EXPECT_THAT(message_for("sobel"), testing::HasSubstr("Did you mean \"sobol\"?"));
}

TEST(Find, ListsAllNamesWhereNoneIsNear) {
    const std::string message = message_for("quasi");
    EXPECT_THAT(message, testing::Not(testing::HasSubstr("Did you mean")));
    for (const CatalogueEntry& sampler : catalogue()) {
        EXPECT_THAT(message, testing::HasSubstr(std::string(sampler.info.name)));
    }
}

}  // namespace
}  // namespace ff::samplers
