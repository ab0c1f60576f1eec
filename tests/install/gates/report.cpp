#include <ffstudy/gate.hpp>

#include <cstdio>
#include <cstdlib>
#include <random>

// The output of a Monte Carlo code: means of bins with their errors.
int main(int count, char** arguments) {
    if (count < 2 || ff::gate::normal_critical(0.5) != 0) return 1;
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(std::atof(arguments[1]), 0.01);
    std::puts("quantity,bin,mean,standard_error");
    for (int bin = 0; bin < 50; ++bin) std::printf("flux,%d,%.17g,0.01\n", bin, normal(engine));
}
