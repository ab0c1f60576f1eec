#include "reports/files/array_files.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace ff::reports {
namespace {

std::string sparse(const Eigen::MatrixXd& matrix, const std::string& comment) {
    std::ostringstream out;
    write_sparse_matrix_market(out, matrix.sparseView(), comment);
    return out.str();
}

TEST(MatrixMarket, IsSparseWhereFewEntriesAreNotZero) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
    matrix(2, 0) = 0.1;
    matrix(0, 3) = 1;
    EXPECT_EQ(sparse(matrix, "few"), "%%MatrixMarket matrix coordinate real general\n% few\n4 4 2\n3 1 0.1\n1 4 1\n");
    matrix.row(1).setOnes();
    EXPECT_EQ(sparse(matrix, "many"), matrix_market(matrix, "many"));
}

}  // namespace
}  // namespace ff::reports
