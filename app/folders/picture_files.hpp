#pragma once

#include "app/folders/result_files.hpp"

#include "reports/pictures/drawing_request.hpp"

namespace ff::app {

/// Pictures of a report as files of FOLDER/pictures, drawn without a browser: Vega under Node.js makes SVG of them, and
/// rsvg-convert PDF of that.

/// @throws UserError with what has to be installed
void expect_svg_programs();
void expect_pdf_programs();

/// @throws IoError
void write_svg(OutputFolder& folder, const ResultSources& sources);
void write_pdf(OutputFolder& folder, const ResultSources& sources);

/// Draws one picture into a file: .svg, .pdf or .png (at 300 dots per inch).
/// @throws IoError; UserError for another extension, and for a height that the picture cannot have
void write_figure(const std::filesystem::path& file, const reports::Picture& picture,
                  const reports::Templates& templates, const reports::FigureStyle& style);

}  // namespace ff::app
