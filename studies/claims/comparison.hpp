#pragma once

#include "stats/basics/quantiles.hpp"
#include "stats/goodness_of_fit/chi_squared.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/published/published.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// One printed figure beside what the study found for the same quantity.
struct FigureComparison {
    std::size_t figure = 0;           ///< index into PublishedTables::figures
    std::optional<std::size_t> cell;  ///< index of the study's cell; empty where it has no such method and size
    Quantity quantity;
    double printed = 0;
    bool deterministic = false;
    std::optional<double> ours;                     ///< value of a deterministic method, mean over trials otherwise
    std::optional<stats::CentralRange> single_run;  ///< 95 % range of one trial
    std::optional<double> z;           ///< (printed - ours) / standard deviation of one trial; form factors and sums
    std::optional<stats::Rank> rank;   ///< among the trials, values equal at the printed precision counted as ties
    std::optional<double> adjusted_p;  ///< Holm over the table's sampled figures; 0 where no trial can give it
};

/// A table's figures of one column taken together.
struct ColumnChiSquared {
    std::size_t column = 0;
    std::size_t figures = 0;    ///< including those that are equal in every run, which the form leaves out
    stats::QuadraticForm form;  ///< printed - mean, with the covariance of the trials; p by Hotelling's T^2
};

struct TableComparison {
    std::string table;
    std::vector<FigureComparison> figures;  ///< in the order of the publication
    std::vector<ColumnChiSquared> chi_squared;
    std::optional<stats::ChiSquared> together;  ///< Fisher's combination of several columns, which are independent runs
};

/// The study's scene that the tables are about; empty where it has none.
std::optional<std::size_t> find_scene(const StudyPlan& plan, const PublishedTables& tables);

/// The cell for a method of this name and size.
std::optional<std::size_t> find_cell(const StudyPlan& plan, std::size_t scene, std::string_view method,
                                     std::uint32_t patches_per_face, std::optional<std::uint64_t> samples_per_patch);

/// Every printed figure against the trials of the study.
std::vector<TableComparison> compare_with_published(const CellReader& cells, const Analysis& findings,
                                                    const PublishedTables& tables);

/// Half a unit of the last printed digit: "0.61" -> 0.005.
double half_printed_unit(const std::string& printed);

}  // namespace ff::studies
