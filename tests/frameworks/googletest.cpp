#include <gtest/gtest.h>

#include <ffstudy/gate.hpp>

#include "gated.hpp"

ff::gate::Options band(double width) {
    ff::gate::Options options;
    options.band = width;
    return options;
}

TEST(Gate, Passes) {
    GATE_MEAN(trials(0), 0.2, band(1e-3));
    GATE_STD(trials(0), 1e-3, band(0.5));
}

TEST(Gate, Fails) {
    GATE_MEAN(trials(0.1), 0.2, band(1e-3));
}

TEST(Gate, IsInconclusive) {
    GATE_MEAN(trials(0), 0.2, band(1e-5));
}
