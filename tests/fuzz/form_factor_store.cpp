// A damaged store of a matrix is refused with a UserError or an IoError, or gives reports without NaN and infinity.
//
// The input is a list of changes to a small sound store (damaged_file.hpp); values are those of a column of pairs or
// faces.

#include "core/support/error.hpp"
#include "reports/csv/scene_csv.hpp"
#include "reports/json/form_factors_json.hpp"
#include "reports/terminal/scene_terminal.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/form_factors/store/store.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/fuzz/damaged_file.hpp"
#include "tests/fuzz/no_number.hpp"
#include "tests/fuzz/one_input.hpp"
#include "tests/support/earlier_stores.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

namespace {

using namespace ff::studies;

void set_value(const Database& database, std::uint8_t which, double value) {
    constexpr std::array columns{"UPDATE pairs SET exchange_area = ? WHERE to_face = ?",
                                 "UPDATE pairs SET low = ? WHERE to_face = ?",
                                 "UPDATE pairs SET high = ? WHERE to_face = ?",
                                 "UPDATE pairs SET samples = ? WHERE to_face = ?",
                                 "UPDATE faces SET area = ? WHERE face = ?",
                                 "UPDATE faces SET row_sum = ? WHERE face = ?",
                                 "UPDATE faces SET row_sum_low = ? WHERE face = ?",
                                 "UPDATE repaired SET factor = ? WHERE to_face = ?"};
    Statement(database.handle(), columns.at(which % columns.size()))
        .bind(0, value)
        .bind(1, std::int64_t{which} / 8 % 6)
        .run();
}

void save_cube(const std::filesystem::path& path) {
    form_factors::KeptMatrix kept;
    kept.source.name = "cube";
    kept.scene = make_scene(kept.source);
    kept.request.repair = true;
    kept.matrix = form_factors::find_matrix(kept.scene, kept.request);
    kept.warnings = {"first"};
    form_factors::save_matrix(path, kept);
    // With a checksum, no changed file would get any further.
    Database(path, Database::Mode::create_or_open).execute(ff::test::form_factors_as_version_1);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const DamagedFile file(save_cube);
    try {
        file.damage(data, size, set_value);
        form_factors::KeptMatrix kept = form_factors::load_matrix(file.path());
        kept.matrix.repaired = form_factors::repair(kept.matrix);
        const ff::reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
        std::ostringstream csv;
        ff::reports::write_form_factors_csv(csv, report);
        if (has_no_number(csv.str()) || has_no_number(ff::reports::form_factors_json(report))) std::abort();
        ff::reports::form_factors_text(report);
    } catch (const ff::UserError&) {
    } catch (const ff::IoError&) {
    }
    return 0;
}
