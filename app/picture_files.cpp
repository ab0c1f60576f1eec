#include "app/picture_files.hpp"

#include "app/child_process.hpp"
#include "app/template_files.hpp"

#include "core/error.hpp"
#include "reports/drawing_request.hpp"
#include "reports/output_file.hpp"

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

/// An empty folder for what is made on the way, removed with all that is in it.
class Workshop {
  public:
    Workshop() {
        std::error_code missing;  // then the path is empty
        const auto folder = std::filesystem::temp_directory_path(missing);
        std::string name = (folder / "ffstudy-XXXXXX").string();
        if (missing || ::mkdtemp(name.data()) == nullptr)
            throw IoError(
                "no temporary folder can be made for pictures (TMPDIR names none that can be written to). "
                "Set TMPDIR.");
        path_ = name;
    }
    ~Workshop() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Draws all pictures into a folder. @return the files, by name
std::vector<std::filesystem::path> draw(const ResultSources& sources, const Workshop& workshop) {
    const auto request = workshop.path() / "pictures.json";
    reports::write_file(request, reports::drawing_request(sources.results, sources.templates));
    run_program(expect_program("node", "nodejs", "svg"),
                {find_template_file(script_name).string(), request.string(), workshop.path().string()});
    std::vector<std::filesystem::path> drawn;
    for (const auto& entry : std::filesystem::directory_iterator(workshop.path())) {
        if (entry.path().extension() == ".svg") drawn.push_back(entry.path());
    }
    std::sort(drawn.begin(), drawn.end());
    return drawn;
}

/// Copies what was made to its place, whole or not at all.
void deliver(const std::filesystem::path& file, const std::filesystem::path& folder) {
    reports::write_file(folder / file.filename(),
                        [&](std::ostream& out) { out << std::ifstream(file, std::ios::binary).rdbuf(); });
}

std::filesystem::path pictures_folder(const std::filesystem::path& folder) {
    auto pictures = folder / "pictures";
    make_folder(pictures);
    return pictures;
}

}  // namespace

void expect_svg_programs() {
    expect_program("node", "nodejs", "svg");
    if (find_template_file(script_name).empty()) {
        throw UserError(
            "--format svg, pdf: this program was built without pictures (Node.js, npm or its registry were missing). "
            "Install nodejs and npm, configure and build again.");
    }
}

void expect_pdf_programs() {
    expect_svg_programs();
    expect_program("rsvg-convert", "librsvg2-bin", "pdf");
}

void write_svg(const std::filesystem::path& folder, const ResultSources& sources) {
    const Workshop workshop;
    const auto pictures = pictures_folder(folder);
    for (const auto& file : draw(sources, workshop)) deliver(file, pictures);
}

void write_pdf(const std::filesystem::path& folder, const ResultSources& sources) {
    const Workshop workshop;
    const auto pictures = pictures_folder(folder);
    const auto convert = expect_program("rsvg-convert", "librsvg2-bin", "pdf");
    // The date that stands in the file. NOLINTNEXTLINE(concurrency-mt-unsafe): there is one thread
    ::setenv("SOURCE_DATE_EPOCH", "0", 1);
    for (auto file : draw(sources, workshop)) {
        const std::string drawing = file.string();
        file.replace_extension(".pdf");
        run_program(convert, {"--format", "pdf", "--output", file.string(), drawing});
        deliver(file, pictures);
    }
}

}  // namespace ff::app
