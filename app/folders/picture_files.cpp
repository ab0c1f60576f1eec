#include "app/folders/picture_files.hpp"

#include "app/folders/template_files.hpp"
#include "app/process/child_process.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "reports/pictures/drawing_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <vector>

namespace ff::app {
namespace {

constexpr std::string_view script_name = "draw_svg.mjs";

/// @throws UserError where there is no such program
std::filesystem::path expect_program(std::string_view name, std::string_view package, std::string_view format) {
    auto program = find_program(name);
    if (program.empty()) {
        throw UserError(fmt::format(
            "--format {}: needs {} (it is not on PATH). Install it (Debian: apt install {}), or save pictures "
            "from report.html.",
            format, name, package));
    }
    return program;
}

/// Draws all pictures into a folder. @return the files, by name
std::vector<std::filesystem::path> draw(const ResultSources& sources, const std::filesystem::path& workshop) {
    const auto request = workshop / "pictures.json";
    reports::write_file(request, reports::drawing_request(sources.results, sources.templates));
    run_program(expect_program("node", "nodejs", "svg"),
                {find_template_file(script_name).string(), request.string(), workshop.string()});
    std::vector<std::filesystem::path> drawn;
    for (const auto& entry : std::filesystem::directory_iterator(workshop)) {
        if (entry.path().extension() == ".svg") drawn.push_back(entry.path());
    }
    std::sort(drawn.begin(), drawn.end());
    return drawn;
}

/// Copies what was made to its place, whole or not at all.
void deliver(const std::filesystem::path& file, OutputFolder& folder) {
    folder.write("pictures/" + file.filename().string(),
                 [&](std::ostream& out) { out << std::ifstream(file, std::ios::binary).rdbuf(); });
}

}  // namespace

void expect_svg_programs() {
    expect_program("node", "nodejs", "svg");
    if (find_template_file(script_name).empty()) {
        throw UserError(
            "--format svg, pdf: this program was built without pictures (Node.js, npm or its registry were missing). "
            "Install nodejs and node-registry-url, configure and build again.");
    }
}

void expect_pdf_programs() {
    expect_svg_programs();
    expect_program("rsvg-convert", "librsvg2-bin", "pdf");
}

void write_svg(OutputFolder& folder, const ResultSources& sources) {
    const auto workshop = folder.make_workshop();
    for (const auto& file : draw(sources, workshop)) deliver(file, folder);
}

void write_pdf(OutputFolder& folder, const ResultSources& sources) {
    const auto workshop = folder.make_workshop();
    const auto convert = expect_program("rsvg-convert", "librsvg2-bin", "pdf");
    // The date that stands in the file. NOLINTNEXTLINE(concurrency-mt-unsafe): there is one thread
    ::setenv("SOURCE_DATE_EPOCH", "0", 1);
    for (auto file : draw(sources, workshop)) {
        const std::string drawing = file.string();
        file.replace_extension(".pdf");
        run_program(convert, {"--format", "pdf", "--output", file.string(), drawing});
        deliver(file, folder);
    }
}

}  // namespace ff::app
