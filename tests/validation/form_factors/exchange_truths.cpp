#include "tests/validation/form_factors/exchange_truths.hpp"

#include "core/visibility/visible_polygon.hpp"

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <numbers>

namespace ff::studies::form_factors {

using Eigen::Vector3d;

BoundedValue<long double> polygon_exchange(const Surface& a, const Surface& b) {
    return polygon_exchange_area<long double>(corners_of<long double>(a), corners_of<long double>(b));
}

double disc_exchange(const Surface& disc, const Surface& far) {
    const VisiblePolygon target(far, {});
    const double radius = std::get<Disc>(disc.shape).outer_radius;
    constexpr int rings = 48;
    constexpr int spokes = 192;
    double sum = 0;
    double weights = 0;
    for (int i = -3 * rings; i <= 3 * rings; ++i) {
        const double x = 3.2 * i / (3.0 * rings);
        const double inner = std::numbers::pi / 2 * std::sinh(x);
        const double r2 = 0.5 * (1 + std::tanh(inner));
        const double weight = std::cosh(x) / (std::cosh(inner) * std::cosh(inner));
        double ring = 0;
        for (int k = 0; k < spokes; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / spokes;
            const Vector3d place = radius * std::sqrt(r2) * Vector3d(std::cos(angle), std::sin(angle), 0);
            ring += target.from(place, Vector3d::UnitZ()).whole;
        }
        sum += weight * ring / spokes;
        weights += weight;
    }
    return std::numbers::pi * radius * radius * sum / weights;
}

double ball_exchange(const SphereZone& ball, const Surface& far) {
    using Gauss = boost::math::quadrature::gauss<double, 10>;
    const auto& p = parallelogram(far);
    constexpr int panels = 12;
    double sum = 0;
    for (int i = 0; i < panels; ++i) {
        for (int j = 0; j < panels; ++j) {
            sum += Gauss::integrate(
                [&](double s) {
                    return Gauss::integrate(
                        [&](double t) {
                            const Vector3d ray = ball.centre - (p.corner + s * p.edge_u + t * p.edge_v);
                            return far.normal.dot(ray) / (ray.squaredNorm() * ray.norm());
                        },
                        j / double{panels}, (j + 1) / double{panels});
                },
                i / double{panels}, (i + 1) / double{panels});
        }
    }
    return sum * ball.radius * ball.radius * area(far.shape);
}

}  // namespace ff::studies::form_factors
