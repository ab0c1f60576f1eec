#include "reports/markdown/enclosure_text.hpp"

#include "reports/markdown/markdown_text.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/radiosity_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

using studies::radiosity::Consequences;
using studies::radiosity::EnclosureRequest;
using studies::radiosity::EnclosureResults;

std::string reflectance(const EnclosureRequest& request, std::size_t setting) {
    return studies::in_words(request.light.reflectance[setting]);
}

std::string section(const Table& table) {
    return fmt::format("## {}\n\n{}", table.title, markdown_table(table));
}

Table factors_table(const EnclosureResults& results) {
    Table table{"factors", "Exact form factors", {}, columns({"from", ">area"})};
    const auto& [description, surfaces, enclosure] = results.of;
    for (const std::string& surface : surfaces) table.columns.push_back({"to " + surface, true});
    for (Eigen::Index i = 0; i < enclosure.areas.size(); ++i) {
        std::vector<TableCell> row{surfaces[static_cast<std::size_t>(i)], exact(enclosure.areas[i])};
        for (const double factor : enclosure.factors.row(i)) row.push_back(exact(factor));
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table solutions_table(const EnclosureRequest& request, const EnclosureResults& results) {
    Table table{"solutions", "Exact solutions", {}, columns({">reflectance"})};
    for (const std::string& surface : results.of.surfaces) table.columns.push_back({"exitance of " + surface, true});
    for (const char* title : {"spectral radius", "dominance", "Jacobi iterations"})
        table.columns.push_back({title, true});
    for (const studies::radiosity::ExactSystem& system : results.exact) {
        std::vector<TableCell> row{reflectance(request, system.setting)};
        for (const double value : system.exitance) row.push_back(brief(value, 8));
        row.push_back(brief(system.properties.spectral_radius.middle(), 6));
        row.push_back(brief(system.properties.dominance, 6));
        row.push_back(iterations_text(system.solvers.front()));
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table trials_table(const EnclosureRequest& request, const EnclosureResults& results) {
    Table table{"trials",
                "What rays make of them",
                {},
                columns({">reflectance", "treatment", ">dominant", ">spectral radius", ">bias of mean exitance",
                         ">exitance error", ">on the worst surface", ">largest correction"})};
    for (std::size_t setting = 0; setting < results.exact.size(); ++setting) {
        for (const Consequences& found : results.consequences) {
            if (found.settings.empty()) continue;
            const studies::radiosity::SettingStatistics& at = found.settings[setting];
            const auto* worst = worst_element(at);
            table.rows.push_back(
                {reflectance(request, setting), studies::radiosity::name(found.treatment),
                 fmt::format("{} of {}", at.dominant, at.trials), over_trials_text(at.spectral_radius, at.trials, 5),
                 at.exitance.empty() ? "no mean" : bias_text(at.exitance.front()),
                 at.light_error ? percent(*at.light_error) : "–",
                 worst == nullptr
                     ? "–"
                     : fmt::format("{} ({})", percent(relative_error(*worst)), results.of.surfaces[worst->element - 1]),
                 brief(found.correction.largest, 2)});
        }
    }
    for (const Consequences& found : results.consequences) {
        if (found.not_balanced == 0) continue;
        table.remarks.push_back(fmt::format("{}: {} of {} trials have no closed reciprocal matrix near.",
                                            studies::radiosity::name(found.treatment), found.not_balanced,
                                            found.not_balanced + found.trials));
    }
    return table;
}

}  // namespace

std::string enclosure_text(const EnclosureRequest& request, const EnclosureResults& results) {
    std::string text =
        fmt::format("{}: {}\n\n{}", request.name, results.of.description, section(factors_table(results)));
    text += section(solutions_table(request, results));
    if (results.consequences.empty()) return text;
    return text +
           fmt::format("{} trials of {} rays from each surface, seed {}\n\n", request.trials, request.rays,
                       request.seed.value) +
           section(trials_table(request, results));
}

}  // namespace ff::reports
