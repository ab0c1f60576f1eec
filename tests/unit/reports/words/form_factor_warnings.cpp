#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "reports/words/scene_reports.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ff::reports {
namespace {

using studies::form_factors::Matrix;
using studies::form_factors::Request;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Warnings of a cube, the sum of whose first row has this interval.
std::vector<std::string> warnings(double low, double high, bool closed = true) {
    Scene scene = make_box(1, 1, 1);
    scene.closed = closed;
    Matrix matrix;
    matrix.rows.assign(scene.faces.size(), {1, 0.9999, 1});
    matrix.rows.front() = {(low + high) / 2, low, high};
    Request request;
    request.tolerance = 1e-3;
    return form_factor_warnings({scene, request, matrix});
}

TEST(FormFactorWarnings, NameTheRowThatMayMissOneByMoreThanTheTolerance) {
    EXPECT_THAT(
        warnings(0.9965, 0.9985),
        ElementsAre(HasSubstr("may not add up to 1: 0.9975 [0.9965, 0.9985] (a gap or an overlap, or chance)")));
    EXPECT_THAT(warnings(1.0015, 1.0035), ElementsAre(HasSubstr("may not add up to 1: 1.0025 [1.0015, 1.0035]")));
    EXPECT_THAT(warnings(0.9965, 0.9995), IsEmpty()) << "by less";
    EXPECT_THAT(warnings(0.9965, 0.9985, false), IsEmpty()) << "an open scene";
}

}  // namespace
}  // namespace ff::reports
