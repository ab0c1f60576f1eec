#include "reports/programs/writers.hpp"

#include <fmt/format.h>

namespace ff::reports {

// For each boundary element how many factors follow, then on a line each: row, column (from 1), factor. @see [elmer]
void write_elmer(std::ostream& out, const HandedOn& handed) {
    using Row = studies::form_factors::Matrix::Sparse::InnerIterator;
    for (Eigen::Index i = 0; i < handed.factors.rows(); ++i) {
        std::size_t entries = 0;
        std::string lines;
        for (Row entry(handed.factors, i); entry; ++entry) {
            lines += fmt::format("{} {} {}\n", entry.row() + 1, entry.col() + 1, entry.value());
            ++entries;
        }
        out << fmt::format("{}\n{}", entries, lines);
    }
}

}  // namespace ff::reports
