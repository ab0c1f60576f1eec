#pragma once

#include <random>
#include <vector>

/// 100 trials of mean 0.2 + bias and standard deviation 0.001.
inline std::vector<double> trials(double bias) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(0.2 + bias, 1e-3);
    std::vector<double> values(100);
    for (double& value : values) value = normal(engine);
    return values;
}
