#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <ffstudy/gate.hpp>

#include "gated.hpp"

ff::gate::Options band(double width) {
    ff::gate::Options options;
    options.band = width;
    return options;
}

TEST_CASE("Passes") {
    GATE_MEAN(trials(0), 0.2, band(1e-3));
    GATE_STD(trials(0), 1e-3, band(0.5));
}

TEST_CASE("Fails") {
    GATE_MEAN(trials(0.1), 0.2, band(1e-3));
}

TEST_CASE("IsInconclusive") {
    GATE_MEAN(trials(0), 0.2, band(1e-5));
}
