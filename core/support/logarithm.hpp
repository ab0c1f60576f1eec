#pragma once

namespace ff {

/// The natural logarithm of a positive finite number, within 3e-16 of max(1, |ln x|) and the same to the bit on every
/// CPU, which the C library does not promise.
double logarithm(double x);

}  // namespace ff
