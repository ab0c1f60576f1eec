#include "core/support/logarithm.hpp"

#include "core/support/contract.hpp"

#include <cmath>
#include <numbers>

namespace ff {

double logarithm(double x) {
    FF_EXPECT(x > 0);
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < 0.5 * std::numbers::sqrt2) {
        mantissa *= 2;
        --exponent;
    }
    // ln m = 2 artanh(s): terms past s^21 are below 2e-18 of the first at |s| <= 0.172.
    const double s = (mantissa - 1) / (mantissa + 1);
    double sum = 0;
    for (int k = 10; k > 0; --k) sum = (sum + 1.0 / (2 * k + 1)) * (s * s);
    return exponent * std::numbers::ln2 + 2 * s * (1 + sum);
}

}  // namespace ff
