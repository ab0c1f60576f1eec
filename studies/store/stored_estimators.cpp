#include "studies/store/stored_estimators.hpp"

#include "core/estimators/added.hpp"

#include <memory>
#include <string>

namespace ff::studies {
namespace {

/// Made only where a study has such estimators.
constexpr const char* outside_estimators_table =
    "CREATE TABLE IF NOT EXISTS outside_estimators(estimator TEXT PRIMARY KEY, summary TEXT NOT NULL, details TEXT NOT "
    "NULL, sizes INTEGER NOT NULL, randomised INTEGER NOT NULL) WITHOUT ROWID";

}  // namespace

void write_added_estimators(Database& database, const StudySpec& spec) {
    for (const Method& method : spec.methods) {
        const auto* const added = find_added_estimator(method.estimator);
        if (added == nullptr) continue;
        const EstimatorInfo& info = added->entry().info;
        database.execute(outside_estimators_table);
        Statement(database.handle(), "INSERT OR IGNORE INTO outside_estimators VALUES(?, ?, ?, ?, ?)")
            .bind(0, info.name)
            .bind(1, info.summary)
            .bind(2, info.details)
            .bind(3, std::int64_t{info.own_points})
            .bind(4, std::int64_t{info.randomised})
            .run();
    }
}

void restore_added_estimators(const Database& database) {
    if (!database.has_table("outside_estimators")) return;
    Statement rows(database.handle(), "SELECT estimator, summary, details, sizes, randomised FROM outside_estimators");
    while (rows.step()) {
        add(std::make_unique<AddedEstimator>(AddedEstimator::Texts{rows.text(0), rows.text(1), rows.text(2)},
                                             program_traits(rows.integer(3) != 0, rows.integer(4) != 0), nullptr,
                                             nullptr));
    }
}

}  // namespace ff::studies
