#include "core/radiosity/linear_map.hpp"

#include <Eigen/IterativeLinearSolvers>

namespace ff {
namespace {

class MapMatrix;

}  // namespace
}  // namespace ff

// What Eigen asks of a matrix that is no array of numbers.
template <>
struct Eigen::internal::traits<ff::MapMatrix> : Eigen::internal::traits<Eigen::SparseMatrix<double>> {};

namespace ff {
namespace {

class MapMatrix : public Eigen::EigenBase<MapMatrix> {
  public:
    using Scalar = double;
    using RealScalar = double;
    using StorageIndex = int;
    enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = false };

    MapMatrix(const LinearMap& map, Eigen::Index size) : map_(map), size_(size) {}

    [[nodiscard]] Eigen::Index rows() const { return size_; }
    [[nodiscard]] Eigen::Index cols() const { return size_; }
    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const { return map_(x); }

    template <class Operand>
    Eigen::Product<MapMatrix, Operand, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<Operand>& x) const {
        return {*this, x.derived()};
    }

  private:
    const LinearMap& map_;
    Eigen::Index size_;
};

}  // namespace
}  // namespace ff

template <class Operand>
struct Eigen::internal::generic_product_impl<ff::MapMatrix, Operand, Eigen::SparseShape, Eigen::DenseShape,
                                             Eigen::GemvProduct>
    : generic_product_impl_base<ff::MapMatrix, Operand, generic_product_impl<ff::MapMatrix, Operand>> {
    template <class Result>
    static void scaleAndAddTo(Result& result, const ff::MapMatrix& matrix, const Operand& x, double scale) {
        result += scale * matrix.times(x);
    }
};

namespace ff {

Eigen::VectorXd solve(const LinearMap& map, const Eigen::VectorXd& right, const Eigen::VectorXd& guess,
                      double tolerance, Eigen::Index most_iterations) {
    const MapMatrix matrix(map, right.size());
    Eigen::BiCGSTAB<MapMatrix, Eigen::IdentityPreconditioner> solver;
    solver.setTolerance(tolerance);
    solver.setMaxIterations(most_iterations);
    solver.compute(matrix);
    return solver.solveWithGuess(right, guess);
}

}  // namespace ff
