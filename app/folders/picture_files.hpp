#pragma once

#include "app/folders/result_files.hpp"

namespace ff::app {

/// Pictures of a report as files of FOLDER/pictures, drawn without a browser: Vega under Node.js makes SVG of them, and
/// rsvg-convert PDF of that.

/// @throws UserError that names what has to be installed
void expect_svg_programs();
void expect_pdf_programs();

/// @throws IoError
void write_svg(OutputFolder& folder, const ResultSources& sources);
void write_pdf(OutputFolder& folder, const ResultSources& sources);

}  // namespace ff::app
