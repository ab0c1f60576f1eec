#include "reports/words/findings/choice_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ClausesWithOneMethod, PreferTheMethodThatIsBestInMostCasesOfAllKinds) {
    EXPECT_THAT(clauses_with_one_method({{{"a", "b"}, {"parallel"}, 5, 5},
                                         {{"b"}, {"adjacent"}, 5, 6},
                                         {{"c"}, {"curved"}, 7, 8},
                                         {{"a", "b", "c"}, {"far"}, 1, 1}}),
                ElementsAre("at equal evaluations take b on parallel, adjacent and far pairs",
                            "c on curved pairs: best in 18 of 20 cases"));
    EXPECT_THAT(clauses_with_one_method({}), IsEmpty());
}

}  // namespace
}  // namespace ff::reports
