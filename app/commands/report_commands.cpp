#include "app/commands/commands.hpp"

#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/folders/picture_files.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "reports/pictures/drawing_request.hpp"
#include "reports/terminal/terminal.hpp"
#include "reports/text/text_table.hpp"
#include "studies/results/results.hpp"
#include "studies/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace ff::app {
namespace {

struct ReportCommand {
    std::filesystem::path results;  ///< folder or store
    std::filesystem::path out;      ///< empty: the folder of the store
    std::vector<std::string> formats;
    std::vector<std::string> pictures;  ///< pictures to draw as files: names or their beginnings; empty: all
    std::filesystem::path templates;    ///< folder of custom templates; empty: none
    bool quiet = false;
};

ExitCode report(const ReportCommand& command) {
    const auto templates = find_templates(command.templates);
    const auto file = store_of(command.results);
    const auto out = command.out.empty() ? file.parent_path() : command.out;
    const std::vector<std::string_view> named(command.formats.begin(), command.formats.end());
    std::span<const std::string_view> formats = usual_formats;
    if (!named.empty()) formats = named;
    expect_formats(formats);
    std::error_code missing;
    const auto store = open_results(file);
    const auto [results, to_the_end] = evaluate_until_stopped(store, command.quiet);
    if (!to_the_end) {
        say("No report is written.\n");
        return ExitCode::interrupted;
    }
    OutputFolder folder(out.empty() ? "." : out, owner_of(store.plan().spec));
    if (std::filesystem::equivalent(file, folder.path() / "results.sqlite", missing)) folder.inherit("study ");
    const bool draws = std::any_of(formats.begin(), formats.end(),
                                   [](std::string_view format) { return format == "svg" || format == "pdf"; });
    if (draws) {
        const std::size_t count = chosen_pictures(results, command.pictures).size();
        if (!command.quiet && command.pictures.empty())
            say("note: drawing all {} pictures of the report; --pictures answer,convergence draws fewer.\n", count);
    } else if (!command.pictures.empty()) {
        throw UserError("--pictures (says which are drawn by --format svg or pdf). Add one of these.");
    }
    write_results(folder, {store, results, templates, command.pictures, command.quiet}, formats);
    if (!command.quiet)
        print_folded("{}\nResults: {}\n", reports::terminal_summary(results, style_of_stdout()), out.string());
    return ExitCode::passed;
}

struct FigureCommand {
    std::filesystem::path results;     ///< folder or store
    std::string picture;               ///< its name or the beginning of it; empty: list all
    std::vector<std::string> methods;  ///< empty: all
    std::string pairs;                 ///< class of pairs; empty: any
    std::string width = "120mm";
    std::string height;  ///< empty: the default of the kind of picture
    double font_size = 8;
    std::string font;
    std::filesystem::path out;        ///< .svg, .pdf or .png; empty: the picture's name, .pdf
    std::filesystem::path templates;  ///< folder of custom templates; empty: none
};

struct LengthUnit {
    std::string_view name;
    double mm;
};
constexpr std::array length_units{LengthUnit{"mm", 1}, LengthUnit{"cm", 10}, LengthUnit{"in", 25.4},
                                  LengthUnit{"pt", 25.4 / 72}};

/// Sizes of figures that can be read and printed.
constexpr double least_mm = 20;
constexpr double most_mm = 2000;

double length_in_mm(const std::string& option, const std::string& text) {
    for (const LengthUnit& unit : length_units) {
        if (!text.ends_with(unit.name)) continue;
        const std::string_view number(text.data(), text.size() - unit.name.size());
        const double mm = parse_bare_number<double>(number).value_or(0) * unit.mm;
        if (mm >= least_mm && mm <= most_mm) return mm;
    }
    throw UserError(R"({} {} (a length from {:g} to {:g} mm, in mm, cm, in or pt). Write it like "84mm" or "3.3in".)",
                    option, text, least_mm, most_mm);
}

reports::FigureStyle style_of(const FigureCommand& command) {
    reports::FigureStyle style{length_in_mm("--width", command.width), std::nullopt, command.font_size, command.font};
    if (!command.height.empty()) style.height = length_in_mm("--height", command.height);
    if (!(style.font_size >= 4 && style.font_size <= 40))
        throw UserError("--font-size {:g} (from 4 to 40 points). Take another.", style.font_size);
    if (command.font.find_first_of("\"<>&") != std::string::npos)
        throw UserError("--font {} (no font has such a name). Name a family, like \"Latin Modern Roman\".",
                        command.font);
    return style;
}

void expect_methods(const std::vector<std::string>& wanted, const studies::StudyPlan& plan) {
    std::vector<std::string_view> known;
    for (const studies::Method& method : plan.spec.methods) known.push_back(method.name);
    for (const std::string& name : wanted) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw UserError("--methods {} (the study has none of this name). {}Its methods: {}.", name,
                            did_you_mean(name, known), fmt::join(known, ", "));
    }
}

std::string names_of_pictures(const std::vector<reports::Picture>& pictures) {
    std::vector<std::string> names;
    for (const reports::Picture& picture : pictures) names.push_back(picture.id);
    constexpr std::size_t most = 12;
    const std::string more = names.size() > most ? fmt::format(" and {} more", names.size() - most) : "";
    names.resize(std::min(names.size(), most));
    return fmt::format("{}{}", fmt::join(names, ", "), more);
}

bool is_named(const reports::Picture& picture, const FigureCommand& command) {
    const bool begins = picture.id == command.picture || picture.id.starts_with(command.picture + "-");
    return begins && (command.pairs.empty() || picture.id.find("-" + command.pairs + "-pairs") != std::string::npos);
}

/// The one picture that the command names. @throws UserError where it names none or several
reports::Picture find_picture(const std::vector<reports::Picture>& all, const FigureCommand& command) {
    std::vector<reports::Picture> found;
    std::copy_if(all.begin(), all.end(), std::back_inserter(found),
                 [&](const reports::Picture& picture) { return is_named(picture, command); });
    const auto exact = std::find_if(found.begin(), found.end(),
                                    [&](const reports::Picture& picture) { return picture.id == command.picture; });
    if (exact != found.end()) return *exact;
    if (found.size() == 1) return found.front();
    const std::string what =
        command.pairs.empty() ? command.picture : fmt::format("{} --pairs {}", command.picture, command.pairs);
    if (found.empty())
        throw UserError("{} (there is no such picture). There are: {}; 'ffstudy figure {}' says what they show.", what,
                        names_of_pictures(all), command.results.string());
    throw UserError("{} (that can be {} pictures: {}). Name one, or its class with --pairs.", what, found.size(),
                    names_of_pictures(found));
}

void list_pictures(const std::vector<reports::Picture>& all) {
    reports::Table table{"pictures", "", "", reports::columns({"picture", "what it shows"})};
    for (const reports::Picture& picture : all) table.rows.push_back({picture.id, picture.title});
    print_folded(reports::text_table(table, style_of_stdout()));
}

/// Draws one picture of a study in a size for a paper, or lists the available ones.
ExitCode figure(const FigureCommand& command) {
    const auto templates = find_templates(command.templates);
    const auto style = style_of(command);
    const auto store = open_results(command.results);
    expect_methods(command.methods, store.plan());
    const auto evaluated = evaluate_until_stopped(store, false);
    const auto all = reports::all_pictures(evaluated.results, {command.methods});
    if (command.picture.empty()) {
        list_pictures(all);
        return ExitCode::passed;
    }
    const auto picture = find_picture(all, command);
    const auto out = command.out.empty() ? std::filesystem::path(picture.id + ".pdf") : command.out;
    write_figure(out, picture, templates, style);
    print_folded("{}\n{}\n{}\n", picture.title, picture.finding, out.string());
    return evaluated.to_the_end ? ExitCode::passed : ExitCode::interrupted;
}

}  // namespace

void add_report(ProgramDefinition& program) {
    const auto [sub, command] =
        program.command<ReportCommand>(everyday, "report", "Write the reports of a finished study again", report);
    sub.option("RESULTS", command.results, "Folder of a study, or its results.sqlite", {.is_required = true});
    sub.option("--format", command.formats,
               fmt::format("{} (default: {})", names_in_words("formats"), fmt::join(usual_formats, ", ")),
               {.type = "FORMAT", .delimiter = ','});
    sub.option("--pictures", command.pictures,
               "Pictures for svg and pdf: names as 'ffstudy figure' lists them, or how they begin (default: all)",
               {.type = "PICTURE", .delimiter = ','});
    sub.option("--out", command.out, "Folder for the files (default: where the results lie)", {.type = "DIR"});
    sub.option("--templates", command.templates, "Folder of custom templates for report.html", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
}

void add_figure(ProgramDefinition& program) {
    const auto [sub, command] =
        program.command<FigureCommand>(everyday, "figure", "Draw one picture of a study for a paper", figure);
    sub.option("RESULTS", command.results, "Folder of a study, or its results.sqlite", {.is_required = true});
    sub.option("PICTURE", command.picture, "Its name, or how that begins (default: list them)");
    sub.option("--methods", command.methods, "Methods, separated by commas (default: all)",
               {.type = "METHOD", .delimiter = ','});
    sub.option("--pairs", command.pairs, "Class of pairs of faces",
               {.type = "CLASS", .choices = {"parallel", "adjacent", "other"}});
    sub.option("--width", command.width, "Width, in mm, cm, in or pt", {.type = "LENGTH", .shows_default = true});
    sub.option("--height", command.height, "Height (default: as the picture has it)", {.type = "LENGTH"});
    sub.option("--font-size", command.font_size, "Font size, in points", {.shows_default = true});
    sub.option("--font", command.font, "Font family (default: that of reports)", {.type = "FONT"});
    sub.option("--out", command.out, "File: .pdf, .svg or .png (default: PICTURE.pdf)", {.type = "FILE"});
    sub.option("--templates", command.templates, "Folder of custom templates", {.type = "DIR"});
}

}  // namespace ff::app
