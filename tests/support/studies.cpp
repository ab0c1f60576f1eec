#include "tests/support/studies.hpp"

#include "core/geometry/scene.hpp"
#include "core/visibility/facing.hpp"
#include "studies/run/run.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace ff::test {
namespace {

using studies::Cell;
using studies::Store;
using studies::StudyPlan;
using studies::StudySpec;
using studies::UnitRecord;

void add_estimate(const StudyPlan& plan, const Cell& cell, int from, int to, std::uint64_t trial, double value,
                  UnitRecord& record) {
    if (plan.spec.methods[cell.method].estimator != "ray_shooting") {
        record.observations.push_back({studies::observable::estimate, from, to, trial, value});
        return;
    }
    const auto rays = static_cast<double>(cell.samples_per_patch * cell.subdivision.per_part());
    record.observations.push_back(
        {studies::observable::hits, from, to, trial, static_cast<std::int64_t>(std::llround(value * rays))});
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "ffstudy-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string study_text(std::string_view lines, std::string_view methods) {
    return fmt::format("[study]\nname = \"test\"\nscene = \"cube\"\nseed = 7\n{}\n{}\n", lines, methods);
}

StudyPlan plan_of(std::string_view text) {
    return studies::plan_study(studies::parse_study(text, "study.toml"));
}

StudyPlan plan_in(std::string_view scene, std::string_view text) {
    StudySpec spec = studies::parse_study(text, "study.toml");
    spec.scenes = {studies::source_of_file("scene.toml", scene)};
    return studies::plan_study(std::move(spec));
}

Store run(const StudyPlan& plan, const std::filesystem::path& file, unsigned threads) {
    Store store = Store::create_or_resume(file, plan);
    studies::RunOptions options;
    options.threads = threads;
    studies::run_study(store, options);
    return store;
}

Store fill(const StudyPlan& plan, const Estimate& estimate) {
    Store store = Store::create_or_resume(in_memory, plan);
    for (const studies::WorkUnit& unit : plan.units) {
        const Cell& cell = plan.cells[unit.cell];
        const int faces = static_cast<int>(plan.scenes[cell.scene].faces.size());
        UnitRecord record;
        record.unit = unit.index;
        for (std::uint64_t trial = unit.first_trial; trial < unit.first_trial + unit.trials; ++trial) {
            for (int from = 1; from <= faces; ++from) {
                for (int to = 1; to <= faces; ++to) {
                    if (from != to || sees_itself(plan.scenes[cell.scene], from - 1))
                        add_estimate(plan, cell, from, to, trial, estimate(unit.cell, trial, from, to), record);
                }
            }
        }
        store.commit(record);
    }
    return store;
}

std::vector<std::string> rows_of(const std::filesystem::path& file) {
    const studies::Database database(file, studies::Database::Mode::read_only);
    constexpr std::array queries{
        "SELECT key || '=' || value FROM meta ORDER BY key",
        "SELECT printf('%d|%s|%s', cell, scene, method) FROM cells ORDER BY cell",
        "SELECT printf('%d|%d|%d|%d|', unit, cell, first_trial, trials) || hex(patch_hits) || '|' || "
        "hex(patch_hits_squared) FROM units ORDER BY unit",
        "SELECT printf('%d|%s|%d|%d|%d|%s|%!.17g', cell, observable, from_face, to_face, trial, typeof(value), value) "
        "FROM observations ORDER BY cell, observable, from_face, to_face, trial",
    };
    std::vector<std::string> rows;
    for (const char* query : queries) {
        studies::Statement statement(database.handle(), query);
        while (statement.step()) rows.push_back(statement.text(0));
    }
    return rows;
}

}  // namespace ff::test
