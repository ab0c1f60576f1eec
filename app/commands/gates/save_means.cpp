#include "app/commands/gates/save_means.hpp"

#include "app/folders/output_folder.hpp"
#include "core/support/error.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/files/output_file.hpp"
#include "stats/basics/moments.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/reported/estimates_file.hpp"
#include "studies/verdicts/reported/reported_file.hpp"

#include <fmt/format.h>

#include <string>

namespace ff::app {

void save_means(const CheckCommand& command) {
    const auto text = studies::read_text_file(command.estimates, studies::FileKind::estimates);
    const std::string origin = command.estimates.string();
    std::string means = text;
    if (studies::gates::reports_means(text)) {
        static_cast<void>(studies::gates::parse_reported(text, origin, studies::gates::StandardErrors::optional));
    } else {
        means = "quantity,mean,standard_error,n\n";
        const auto file = studies::gates::parse_estimates(text, origin);
        for (const studies::gates::EstimateSeries& series : file.series) {
            const double first = series.values.front();
            const auto moments = stats::moments_of(series.values, first);
            const double error = *moments.standard_error();
            if (error == 0)
                throw UserError(
                    fmt::format("{}: all values of '{}' are equal (no spread is no evidence of precision). "
                                "Was every trial seeded alike?",
                                origin, series.quantity));
            means += fmt::format("{},{},{},{}\n", reports::csv_field(series.quantity), first + *moments.bias(), error,
                                 series.values.size());
        }
    }
    const OutputFolder lock(reports::folder_of(command.save_baseline), "baseline");
    reports::write_file(command.save_baseline, means);
    if (!command.quiet) fmt::print("Baseline: {} (compare with it by --against)\n", command.save_baseline.string());
}

}  // namespace ff::app
