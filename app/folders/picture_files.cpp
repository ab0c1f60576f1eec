#include "app/folders/picture_files.hpp"

#include "app/folders/shipped_files.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/progress.hpp"

#include "core/support/child_process.hpp"
#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string_view>
#include <thread>
#include <vector>

namespace ff::app {
namespace {

constexpr std::string_view script_name = "draw_svg.mjs";

/// The path of a program on PATH; empty where there is none.
std::filesystem::path find_program(std::string_view name) {
    const char* const search = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it
    std::string_view rest = search == nullptr ? std::string_view() : search;
    while (!rest.empty()) {
        const auto end = std::min(rest.find(':'), rest.size());
        auto program = std::filesystem::path(rest.substr(0, end)) / name;
        if (end > 0 && ::access(program.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(program))
            return program;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

/// Runs a program and waits for it; its output goes to stderr.
/// @param meanwhile  called about ten times a second; may be empty
/// @throws IoError unless it ends with exit code 0
void run_drawing_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const std::function<void()>& meanwhile = {}) {
    ChildCommand command{{program.string()}, {}};
    command.words.insert(command.words.end(), arguments.begin(), arguments.end());
    const pid_t child = start_child(command, {STDIN_FILENO, STDERR_FILENO, STDERR_FILENO}, ChildSignals::as_usual);
    const OnEnd end_child([child] { ::kill(child, SIGKILL); });
    const auto runs = [child] {
        siginfo_t ended{};
        return ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    };
    while (meanwhile && runs()) {
        meanwhile();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    const int status = wait_for_child(child);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw IoError("{}: failed (its message is above). Check the disk and the memory.", program.string());
}

/// @throws UserError where there is no such program
std::filesystem::path expect_program(std::string_view name, std::string_view package) {
    auto program = find_program(name);
    if (program.empty()) {
        throw UserError(
            "Drawing pictures: needs {} (it is not on PATH). Install it (Debian: apt install {}), or save "
            "pictures from "
            "report.html.",
            name, package);
    }
    return program;
}

/// Draws pictures into a folder.
void draw(const std::string& request, const std::filesystem::path& workshop,
          const std::function<void()>& meanwhile = {}) {
    const auto file = workshop / "pictures.json";
    reports::write_file(file, request);
    run_drawing_program(expect_program("node", "nodejs"),
                        {find_template_file(script_name).string(), file.string(), workshop.string()}, meanwhile);
}

std::vector<std::filesystem::path> drawings_in(const std::filesystem::path& workshop) {
    std::vector<std::filesystem::path> drawn;
    for (const auto& entry : std::filesystem::directory_iterator(workshop)) {
        if (entry.path().extension() == ".svg") drawn.push_back(entry.path());
    }
    std::sort(drawn.begin(), drawn.end());
    return drawn;
}

/// Makes the requested pictures of a report. @return the files, by name
std::vector<std::filesystem::path> draw_all(const ResultSources& sources, const std::filesystem::path& workshop) {
    const auto pictures = chosen_pictures(sources.results, sources.pictures);
    ProgressDisplay progress(sources.quiet);
    draw(reports::drawing_request(pictures, sources.templates), workshop,
         [&] { progress.show(drawings_in(workshop).size(), pictures.size(), "pictures drawn"); });
    progress.finish();
    return drawings_in(workshop);
}

/// Makes an SVG another format. @param format  of rsvg-convert
void convert(const std::filesystem::path& drawing, std::string_view format, const std::filesystem::path& file) {
    // The date that stands in a PDF. NOLINTNEXTLINE(concurrency-mt-unsafe): there is one thread
    ::setenv("SOURCE_DATE_EPOCH", "0", 1);
    run_drawing_program(expect_program("rsvg-convert", "librsvg2-bin"),
                        {"--format", std::string(format), "--dpi-x", "300", "--dpi-y", "300", "--output", file.string(),
                         drawing.string()});
}

/// @throws UserError where it cannot be drawn in this size
void expect_drawable(const reports::Picture& picture, const reports::Templates& templates,
                     const reports::FigureStyle& style) {
    const std::string kind = templates.text(picture.kind + ".json");
    const bool follows =
        kind.find("\"y_step\"") != std::string::npos || picture.values.find("\"aspect\"") != std::string::npos;
    if (style.height && follows)
        throw UserError("--height (that of {} follows from what it shows). Leave it out.", picture.id);
}

/// Copies the result to its place, completely or not at all.
void deliver(const std::filesystem::path& file, OutputFolder& folder) {
    folder.write("pictures/" + file.filename().string(),
                 [&](std::ostream& out) { out << std::ifstream(file, std::ios::binary).rdbuf(); });
}

}  // namespace

void expect_svg_programs() {
    expect_program("node", "nodejs");
}

void expect_pdf_programs() {
    expect_svg_programs();
    expect_program("rsvg-convert", "librsvg2-bin");
}

void write_svg(OutputFolder& folder, const ResultSources& sources) {
    const auto workshop = folder.make_workshop();
    for (const auto& file : draw_all(sources, workshop)) deliver(file, folder);
}

void write_pdf(OutputFolder& folder, const ResultSources& sources) {
    const auto workshop = folder.make_workshop();
    const auto drawings = draw_all(sources, workshop);
    ProgressDisplay progress(sources.quiet);
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        const auto file = std::filesystem::path(drawings[i]).replace_extension(".pdf");
        convert(drawings[i], "pdf", file);
        deliver(file, folder);
        progress.show(i + 1, drawings.size(), "pictures converted to PDF");
    }
    progress.finish();
}

void write_figure(const std::filesystem::path& file, const reports::Picture& picture,
                  const reports::Templates& templates, const reports::FigureStyle& style) {
    const std::string format = file.extension().string();
    const bool converted = format == ".pdf" || format == ".png";
    if (!converted && format != ".svg")
        throw UserError("--out {} (a figure ends in .pdf, .svg or .png). Name it so.", file.string());
    converted ? expect_pdf_programs() : expect_svg_programs();
    expect_drawable(picture, templates, style);
    const OutputFolder folder(reports::folder_of(file), "figure");
    const auto workshop = folder.make_workshop();
    draw(reports::drawing_request({picture}, templates, style), workshop);
    const auto drawing = workshop / (picture.id + ".svg");
    reports::replace_file(file, [&](const std::filesystem::path& place) {
        if (converted) return convert(drawing, format.substr(1), place);
        std::filesystem::copy_file(drawing, place, std::filesystem::copy_options::overwrite_existing);
    });
}

}  // namespace ff::app
