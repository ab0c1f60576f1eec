#include "reports/files/array_files.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace ff::reports {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

std::string npz(const Sparse& matrix) {
    std::ostringstream out;
    write_sparse_npz(out, matrix);
    return out.str();
}

// tests/cli/cases/form_factors_have_intervals.sh shows that NumPy reads it.
TEST(SparseNpz, HoldsTheValuesButNoTimes) {
    Sparse matrix(3, 3);
    const std::vector<Eigen::Triplet<double>> entries{{0, 2, 0.25}, {2, 0, 0.5}};
    matrix.setFromTriplets(entries.begin(), entries.end());
    const std::string bytes = npz(matrix);
    EXPECT_EQ(bytes.substr(0, 2), "PK");
    EXPECT_NE(bytes.find("'shape': (2,)"), std::string::npos);
    const double value = 0.25;
    EXPECT_NE(bytes.find(std::string(reinterpret_cast<const char*>(&value), sizeof value)), std::string::npos);
    EXPECT_EQ(npz(matrix), bytes);
}

TEST(SparseNpz, WritesAnArchiveForAnEmptyMatrix) {
    Sparse matrix(4, 4);
    EXPECT_NE(npz(matrix).find("'shape': (0,)"), std::string::npos);
}

}  // namespace
}  // namespace ff::reports
