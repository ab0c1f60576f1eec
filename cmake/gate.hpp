#pragma once

// Gates on Monte Carlo trials in unit tests. GATE_MEAN and GATE_STD are there where GoogleTest, Catch2 or doctest was
// included before.
#include <ffstudy/stats/gates/gate.hpp>
#include <ffstudy/stats/gates/gate_macros.hpp>
