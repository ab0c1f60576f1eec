#pragma once

#include "reports/words/scene_reports.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// Form factors handed to another program, row by row.
struct HandedOn {
    const Scene& scene;
    const studies::form_factors::Matrix& matrix;
    studies::form_factors::Matrix::Sparse factors;    ///< repaired where requested and possible, otherwise estimates
    std::vector<std::optional<double>> emissivities;  ///< of all faces, as far as the scene file gives them
};

HandedOn hand_on(const Scene& scene, const studies::form_factors::Matrix& matrix,
                 std::vector<std::optional<double>> emissivities);

/// A file in the format of another program. docs/form-factors.md has the formats, with their sources.
struct ProgramFile {
    std::string_view format;
    std::string_view name;  ///< name of the file, possibly in a folder
    /// @throws UserError where the format cannot express the scene
    void (*expect)(const Scene& scene);
    void (*write)(std::ostream& out, const HandedOn& handed);
};

/// Names of the formats as a list in words.
std::string program_formats_in_words();

/// The files of these formats. @throws UserError for an unknown format, and for a scene that one of them cannot express
std::vector<ProgramFile> files_of_formats(const std::vector<std::string>& formats, const Scene& scene);

/// The same factors with their intervals, as CSV: row, column (from 1), from, to, factor, low, high.
void write_intervals(std::ostream& out, const HandedOn& handed);

}  // namespace ff::reports
