#include "stats/distributions.hpp"

#include "core/contract.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>

namespace ff::stats {

namespace math = boost::math;

double normal_critical(double tail) {
    FF_EXPECT(0 < tail && tail < 1);
    return math::quantile(math::complement(math::normal(), tail));
}

double normal_tail(double z) {
    return math::cdf(math::complement(math::normal(), z));
}

double normal_two_sided_p(double z) {
    return 2 * normal_tail(std::abs(z));
}

double student_critical(double freedom, double tail) {
    FF_EXPECT(freedom > 0 && 0 < tail && tail < 1);
    return math::quantile(math::complement(math::students_t(freedom), tail));
}

double student_tail(double t, double freedom) {
    FF_EXPECT(freedom > 0);
    return math::cdf(math::complement(math::students_t(freedom), t));
}

double student_two_sided_p(double t, double freedom) {
    return 2 * student_tail(std::abs(t), freedom);
}

double chi_squared_critical(double freedom, double tail) {
    FF_EXPECT(freedom > 0 && 0 < tail && tail < 1);
    return math::quantile(math::complement(math::chi_squared(freedom), tail));
}

double chi_squared_tail(double x, double freedom) {
    FF_EXPECT(x >= 0 && freedom > 0);
    return math::cdf(math::complement(math::chi_squared(freedom), x));
}

double fisher_tail(double f, double freedom_above, double freedom_below) {
    FF_EXPECT(f >= 0);
    return math::cdf(math::complement(math::fisher_f(freedom_above, freedom_below), f));
}

double fisher_critical(double tail, double freedom_above, double freedom_below) {
    FF_EXPECT(0 < tail && tail < 1);
    return math::quantile(math::complement(math::fisher_f(freedom_above, freedom_below), tail));
}

}  // namespace ff::stats
