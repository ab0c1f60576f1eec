#include "reports/files/sparse_npz.hpp"

#include "core/support/contract.hpp"
#include "reports/files/npz_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ff::reports {

void write_sparse_npz(std::ostream& out, const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix) {
    FF_EXPECT(matrix.isCompressed());
    const auto entries = static_cast<std::size_t>(matrix.nonZeros());
    const auto rows = static_cast<std::size_t>(matrix.rows());
    const std::array shape{std::int64_t{matrix.rows()}, std::int64_t{matrix.cols()}};
    const std::string of_entries = fmt::format("({},)", entries);
    NpzFile file(out, entries * (sizeof(double) + sizeof(int)) + (rows + 1) * sizeof(int),
                 fmt::format("a matrix of {} entries", entries));
    file.add("indices", of_entries, std::span<const int>(matrix.innerIndexPtr(), entries));
    file.add("indptr", fmt::format("({},)", rows + 1), std::span<const int>(matrix.outerIndexPtr(), rows + 1));
    file.add("format", "csr");
    file.add("shape", "(2,)", std::span<const std::int64_t>(shape));
    file.add("data", of_entries, std::span<const double>(matrix.valuePtr(), entries));
    file.finish();
}

void write_randomisations(std::ostream& out, const studies::form_factors::Matrix& matrix) {
    using studies::form_factors::randomisations;
    std::vector<std::int32_t> from, to, rays_of;
    std::vector<float> values;
    for (const studies::form_factors::PairRandomisations& pair : matrix.randomisations) {
        from.push_back(static_cast<std::int32_t>(pair.from));
        to.push_back(static_cast<std::int32_t>(pair.to));
        rays_of.push_back(pair.rays_of ? static_cast<std::int32_t>(*pair.rays_of) : -1);
        values.insert(values.end(), pair.values.begin(), pair.values.end());
    }
    const std::size_t pairs = from.size();
    const std::string of_pairs = fmt::format("({},)", pairs);
    NpzFile file(out, pairs * (3 * sizeof(std::int32_t) + randomisations * sizeof(float)),
                 fmt::format("randomisations of {} pairs", pairs));
    file.add("from", of_pairs, std::span<const std::int32_t>(from));
    file.add("to", of_pairs, std::span<const std::int32_t>(to));
    file.add("rays_of", of_pairs, std::span<const std::int32_t>(rays_of));
    file.add("values", fmt::format("({}, {})", pairs, randomisations), std::span<const float>(values));
    file.finish();
}

}  // namespace ff::reports
