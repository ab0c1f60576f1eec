#include "reports/programs/writers.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

// For each face, of those that it sees: their factors (F), and their numbers from 0 (globalFaceFaces). @see [openfoam]

using Row = studies::form_factors::Matrix::Sparse::InnerIterator;

template <class Entry>
void write_lists(std::ostream& out, const HandedOn& handed, std::string_view type, std::string_view object,
                 Entry entry_of) {
    out << fmt::format(
        "FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       {};\n"
        "    location    \"constant\";\n    object      {};\n}}\n\n{}\n(\n",
        type, object, handed.factors.rows());
    for (Eigen::Index i = 0; i < handed.factors.rows(); ++i) {
        std::vector<decltype(entry_of(Row(handed.factors, i)))> list;
        for (Row entry(handed.factors, i); entry; ++entry) list.push_back(entry_of(entry));
        out << fmt::format("{}({})\n", list.size(), fmt::join(list, " "));
    }
    out << ")\n";
}

}  // namespace

void write_openfoam_factors(std::ostream& out, const HandedOn& handed) {
    write_lists(out, handed, "scalarListList", "F", [](const Row& entry) { return entry.value(); });
}

void write_openfoam_faces(std::ostream& out, const HandedOn& handed) {
    write_lists(out, handed, "labelListList", "globalFaceFaces", [](const Row& entry) { return entry.col(); });
}

}  // namespace ff::reports
