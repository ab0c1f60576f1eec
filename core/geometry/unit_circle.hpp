#pragma once

namespace ff {

struct CirclePoint {
    double cosine = 1;
    double sine = 0;
};

/// The point of the unit circle at an azimuth in turns, 0 <= turns <= 1, within 3e-16 and the same to the bit on every
/// CPU, which the C library does not promise.
CirclePoint unit_circle(double turns);

}  // namespace ff
