// A damaged store is refused with a UserError or an IoError, or gives reports without NaN and infinity.
//
// The input is a list of changes to a small sound store (damaged_file.hpp); values are those of observations.

#include "studies/store/store.hpp"
#include "core/support/error.hpp"
#include "reports/csv/csv.hpp"
#include "reports/json/json.hpp"
#include "reports/markdown/markdown.hpp"
#include "studies/results/results.hpp"
#include "studies/run/run.hpp"
#include "tests/fuzz/damaged_file.hpp"
#include "tests/fuzz/no_number.hpp"
#include "tests/fuzz/one_input.hpp"
#include "tests/support/earlier_stores.hpp"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

namespace {

using namespace ff::studies;

constexpr std::string_view study = R"([study]
name = "fuzz"
scene = "cube"
trials = 4
seed = 1
[[method]]
name = "rays"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
samples_per_patch = 50
[[method]]
name = "kernel"
sampler = "random"
estimator = "area_kernel"
samples_per_patch = 5
)";

void set_value(const Database& database, std::uint8_t row, double value) {
    Statement(database.handle(),
              "UPDATE observations SET value = ? WHERE (cell, observable, from_face, to_face, trial) = "
              "(SELECT cell, observable, from_face, to_face, trial FROM observations LIMIT 1 OFFSET ?)")
        .bind(0, value)
        .bind(1, std::int64_t{row})
        .run();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const DamagedFile file([](const std::filesystem::path& path) {
        {
            Store store = Store::create_or_resume(path, plan_study(parse_study(study, "fuzz")));
            run_study(store, {});
            store.seal();
        }
        // With checksums, no changed file would get any further.
        Database(path, Database::Mode::create_or_open).execute(ff::test::store_as_version_1);
    });
    try {
        file.damage(data, size, set_value);
        const Store store = Store::open(file.path());
        const StudyResults results = evaluate(store);
        std::ostringstream csv;
        ff::reports::write_summary_csv(csv, results.findings);
        ff::reports::write_trials_csv(csv, store);
        if (has_no_number(csv.str()) || has_no_number(ff::reports::results_json(results))) std::abort();
        ff::reports::markdown_report(results);
    } catch (const ff::UserError&) {
    } catch (const ff::IoError&) {
    }
    return 0;
}
