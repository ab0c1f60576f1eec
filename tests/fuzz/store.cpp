// A damaged store is refused with a UserError or an IoError, or gives reports in which every number is one.
//
// The input is a list of changes to a small sound store: 'b' and five bytes overwrite a byte of the file, 'v' and nine
// bytes set a value of an observation, 'c' cuts the file off.

#include "studies/store.hpp"
#include "core/error.hpp"
#include "reports/csv.hpp"
#include "reports/json.hpp"
#include "reports/markdown.hpp"
#include "studies/results.hpp"
#include "studies/run.hpp"
#include "tests/fuzz/no_number.hpp"
#include "tests/fuzz/one_input.hpp"

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
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

/// A sound store and a place for damaged ones; removed at the end.
struct Place {
    std::filesystem::path folder;
    std::string sound;

    Place() {
        std::string name = (std::filesystem::temp_directory_path() / "ffstudy-fuzz-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
        folder = name;
        {
            Store store = Store::create_or_resume(file(), plan_study(parse_study(study, "fuzz")));
            run_study(store, {});
            store.seal();
        }
        std::ifstream in(file(), std::ios::binary);
        sound.assign(std::istreambuf_iterator<char>(in), {});
    }
    ~Place() {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    [[nodiscard]] std::filesystem::path file() const { return folder / "results.sqlite"; }
};

std::uint32_t number(const std::uint8_t* bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

void set_value(const std::filesystem::path& file, std::uint8_t row, const std::uint8_t* bytes) {
    double value = 0;
    std::memcpy(&value, bytes, sizeof value);
    const Database database(file, Database::Mode::create_or_open);
    Statement(database.handle(),
              "UPDATE observations SET value = ? WHERE (cell, observable, from_face, to_face, trial) = "
              "(SELECT cell, observable, from_face, to_face, trial FROM observations LIMIT 1 OFFSET ?)")
        .bind(0, value)
        .bind(1, std::int64_t{row})
        .run();
}

void damage(const Place& place, const std::uint8_t* data, std::size_t size) {
    std::string bytes = place.sound;
    const auto write = [&] {
        std::ofstream(place.file(), std::ios::binary | std::ios::trunc)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    };
    // Changes to bytes come first: SQL needs a file.
    for (std::size_t i = 0; i + 6 <= size && data[i] != 'v'; i += 6) {
        if (bytes.empty()) break;
        const std::size_t at = number(data + i + 1) % bytes.size();
        if (data[i] == 'b') bytes[at] = static_cast<char>(data[i + 5]);
        if (data[i] == 'c') bytes.resize(at);
    }
    write();
    if (bytes != place.sound) return;
    for (std::size_t i = 0; i + 10 <= size && data[i] == 'v'; i += 10)
        set_value(place.file(), data[i + 1], data + i + 2);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Place place;
    for (const char* name : {"results.sqlite", "results.sqlite-wal", "results.sqlite-shm", "results.sqlite-journal"})
        std::filesystem::remove(place.folder / name);
    try {
        damage(place, data, size);
        const Store store = Store::open(place.file());
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
