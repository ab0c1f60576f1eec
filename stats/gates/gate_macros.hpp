#pragma once

// GATE_MEAN(estimates, reference, {.band = 1e-3}) and GATE_STD(...): assertions of whichever of GoogleTest, Catch2 (2
// or 3) and doctest was included before. A test fails unless the gate passes: inconclusive is not a pass. The message
// has effect, interval, band, both risks, how many trials would decide, and the option that repeats this test alone.
// Designated initialisers need C++20, g++ or clang; otherwise set members of ff::gate::Options.

#include "stats/gates/gate.hpp"

#include <string>

#if defined(DOCTEST_LIBRARY_INCLUDED)
#define FF_GATE_REPEAT \
    (" Repeat with --test-case=\"" + std::string(doctest::getContextOptions()->currentTest->m_name) + "\"")
#define FF_GATE_CHECK(result) CHECK_MESSAGE(bool(result), (ff::gate::message(result) + FF_GATE_REPEAT))
#elif defined(CATCH_VERSION_MAJOR) || defined(TWOBLUECUBES_CATCH_HPP_INCLUDED) || \
    defined(CATCH_TEST_MACROS_HPP_INCLUDED)
#define FF_GATE_REPEAT (" Repeat with \"" + std::string(Catch::getResultCapture().getCurrentTestName()) + "\"")
#define FF_GATE_CHECK(result)                         \
    INFO(ff::gate::message(result) + FF_GATE_REPEAT); \
    CHECK(bool(result))
#elif defined(EXPECT_TRUE) && defined(ADD_FAILURE)
#define FF_GATE_REPEAT                                                                               \
    (" Repeat with --gtest_filter=" +                                                                \
     std::string(::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name()) + "." + \
     ::testing::UnitTest::GetInstance()->current_test_info()->name())
#define FF_GATE_CHECK(result) EXPECT_TRUE(bool(result)) << ff::gate::message(result) + FF_GATE_REPEAT
#endif

#if defined(FF_GATE_CHECK)
// Once: estimates may be a call that takes an hour.
#define FF_GATE_ASSERT(judge, ...)                               \
    do {                                                         \
        const ff::gate::Result gate_result = judge(__VA_ARGS__); \
        FF_GATE_CHECK(gate_result);                              \
    } while (false)

#define GATE_MEAN(...) FF_GATE_ASSERT(ff::gate::mean, __VA_ARGS__)
#define GATE_STD(...) FF_GATE_ASSERT(ff::gate::spread, __VA_ARGS__)
#endif
