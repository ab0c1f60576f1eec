#include "studies/form_factors/store/store.hpp"

#include "core/support/error.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/earlier_stores.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <tuple>
#include <utility>

namespace ff::studies::form_factors {
namespace {

using test::message_of;
using testing::HasSubstr;

/// Two triangles face each other past a third; the file says that they are closed, which they are not.
constexpr const char* triangles_obj = R"(# closed
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 0.3 0.3 0.5
v 0.5 0.3 0.5
v 0.3 0.5 0.5
g floor
f 1 2 3
g roof
f 4 6 5
g between
f 7 8 9
)";

KeptMatrix found(SceneSource source, bool repaired, double drop = 0) {
    KeptMatrix kept;
    kept.source = std::move(source);
    kept.scene = make_scene(kept.source);
    kept.request.tolerance = 0.01;
    kept.request.level = 0.9;
    kept.request.level_of = LevelOf::matrix;
    kept.request.seed = Seed{7};
    kept.request.repair = repaired;
    kept.request.drop = drop;
    kept.request.randomisations = repaired;
    kept.matrix = find_matrix(kept.scene, kept.request);
    kept.warnings = {"first", "second"};
    kept.context = {{"host", "here"}};
    return kept;
}

void expect_equal(const FaceExchange& a, const FaceExchange& b) {
    EXPECT_EQ(std::pair(a.from, a.to), std::pair(b.from, b.to));
    EXPECT_EQ(std::tuple(a.value, a.low, a.high), std::tuple(b.value, b.low, b.high));
    EXPECT_EQ(method_of(a), method_of(b));
    EXPECT_EQ(reason_of(a), reason_of(b));
    EXPECT_EQ(std::tuple(a.samples, a.clipped, a.within, a.contradicted),
              std::tuple(b.samples, b.clipped, b.within, b.contradicted));
}

void expect_equal(const Matrix& a, const Matrix& b) {
    EXPECT_EQ(a.areas, b.areas);
    EXPECT_EQ(std::tuple(a.surfaces, a.samples, a.rays, a.lost_rays, a.interrupted, a.entry_level, a.dropped),
              std::tuple(b.surfaces, b.samples, b.rays, b.lost_rays, b.interrupted, b.entry_level, b.dropped));
    ASSERT_EQ(a.exchanges.size(), b.exchanges.size());
    for (std::size_t p = 0; p < a.exchanges.size(); ++p) expect_equal(a.exchanges[p], b.exchanges[p]);
    ASSERT_EQ(a.rows.size(), b.rows.size());
    for (std::size_t i = 0; i < a.rows.size(); ++i) {
        EXPECT_EQ(std::tuple(a.rows[i].value, a.rows[i].low, a.rows[i].high, a.rows[i].excludes_one),
                  std::tuple(b.rows[i].value, b.rows[i].low, b.rows[i].high, b.rows[i].excludes_one));
        const DroppedExchange& c = a.rows[i].dropped;
        const DroppedExchange& d = b.rows[i].dropped;
        EXPECT_EQ(std::tuple(c.pairs, c.value, c.low, c.high), std::tuple(d.pairs, d.value, d.low, d.high));
    }
    ASSERT_EQ(a.randomisations.size(), b.randomisations.size());
    for (std::size_t i = 0; i < a.randomisations.size(); ++i) {
        const PairRandomisations& c = a.randomisations[i];
        const PairRandomisations& d = b.randomisations[i];
        EXPECT_EQ(std::tuple(c.from, c.to, c.rays_of, c.values, c.hidden),
                  std::tuple(d.from, d.to, d.rays_of, d.values, d.hidden));
    }
    ASSERT_EQ(a.repaired.has_value(), b.repaired.has_value());
    if (!a.repaired) return;
    EXPECT_EQ(Eigen::MatrixXd(a.repaired->factors), Eigen::MatrixXd(b.repaired->factors));
    EXPECT_EQ(a.repaired->possible, b.repaired->possible);
    EXPECT_EQ(a.repaired->largest_change, b.repaired->largest_change);
    EXPECT_EQ(a.repaired->outside, b.repaired->outside);
}

class FormFactorStore : public testing::Test {
  protected:
    std::filesystem::path file() const { return folder.path() / "form_factors.sqlite"; }
    void save(const KeptMatrix& what) const {
        std::filesystem::remove(file());
        save_matrix(file(), what);
    }
    template <typename Error>
    std::string refusal() const {
        return message_of<Error>([&] { load_matrix(file()); });
    }
    /// The message about the file after this has been done to it.
    std::string refusal_after(const std::string& sql) const {
        save(kept);
        Database database(file(), Database::Mode::create_or_open);
        database.execute(test::form_factors_as_version_1);
        database.execute(sql.c_str());
        return refusal<IoError>();
    }
    test::TemporaryFolder folder;
    KeptMatrix kept = found(scene_source("squares_blocked"), false);
};

TEST_F(FormFactorStore, RestoresTheSavedMatrix) {
    for (const auto& [source, repaired] :
         {std::pair(scene_source("squares_blocked"), false), std::pair(scene_source("nested_cubes"), true),
          std::pair(source_of_file("room.obj", triangles_obj), false)}) {
        const KeptMatrix saved = found(source, repaired);
        save(saved);
        const KeptMatrix read = load_matrix(file());
        EXPECT_EQ(read.source, source);
        EXPECT_EQ(read.scene.faces, saved.scene.faces);
        EXPECT_EQ(read.request.tolerance, 0.01);
        EXPECT_EQ(read.request.level, 0.9);
        EXPECT_EQ(read.request.level_of, LevelOf::matrix);
        EXPECT_EQ(read.request.seed, Seed{7});
        EXPECT_EQ(read.request.repair, repaired);
        EXPECT_EQ(read.warnings, saved.warnings);
        EXPECT_EQ(read.context, saved.context);
        expect_equal(read.matrix, saved.matrix);
    }
}

TEST_F(FormFactorStore, KeepsEveryMethodAndReason) {
    for (const ExchangeMethod method : {ExchangeMethod::closed_form, ExchangeMethod::contour, ExchangeMethod::cells,
                                        ExchangeMethod::points, ExchangeMethod::rays}) {
        for (int reason = 0; reason <= static_cast<int>(ExchangeReason::many_surfaces); ++reason) {
            FaceExchange& pair = kept.matrix.exchanges.front();
            pair.method = method;
            pair.reason = static_cast<ExchangeReason>(reason);
            pair.contradicted = pair.clipped = reason % 2 == 0;
            save(kept);
            expect_equal(load_matrix(file()).matrix, kept.matrix);
        }
    }
    kept.matrix.exchanges.front().method.reset();
    kept.matrix.interrupted = true;
    save(kept);
    expect_equal(load_matrix(file()).matrix, kept.matrix);
}

TEST(FormFactorWords, ReadReasonsOfEarlierVersions) {
    FaceExchange pair;
    for (const auto& [reason, meaning] :
         {std::pair{"the rays of its row do as well", ExchangeReason::blocked},
          std::pair{"polygons, something may stand in between", ExchangeReason::blocked},
          std::pair{"aligned rectangles with nothing in between", ExchangeReason::aligned},
          std::pair{"polygons with nothing in between", ExchangeReason::polygons},
          std::pair{"polygons far apart with nothing in between", ExchangeReason::far},
          std::pair{"less than the tolerance, whatever stands in between", ExchangeReason::small},
          std::pair{"much may stand in between", ExchangeReason::many_blockers},
          std::pair{"with a disc or a sphere, nothing in between", ExchangeReason::round},
          std::pair{"round surfaces about one axis with nothing in between", ExchangeReason::coaxial}}) {
        EXPECT_TRUE(set_method(pair, "rays", reason)) << reason;
        EXPECT_EQ(pair.method, ExchangeMethod::rays);
        EXPECT_EQ(pair.reason, meaning) << reason;
    }
    EXPECT_FALSE(set_method(pair, "rays", "the rays of its rows do as well"));
}

TEST_F(FormFactorStore, IsReadFromAnEarlierVersion) {
    save(kept);
    EXPECT_TRUE(load_matrix(file()).was_checked);
    Database(file(), Database::Mode::create_or_open).execute(test::form_factors_as_version_1);
    const KeptMatrix read = load_matrix(file());
    EXPECT_FALSE(read.was_checked);
    expect_equal(read.matrix, kept.matrix);
}

/// The whole content of a file as text; empty where it is refused.
std::string read_or_refused(const std::filesystem::path& file) {
    try {
        const KeptMatrix kept = load_matrix(file);
        std::string words = kept.source.written() + kept.context.at("host") + kept.warnings.at(0) + kept.warnings.at(1);
        const auto add = [&](double value) { words += fmt::format("{} ", value); };
        for (const FaceExchange& pair : kept.matrix.exchanges) {
            for (const double value : {pair.value, pair.low, pair.high}) add(value);
            words += fmt::format("{} {} {} ", method_of(pair), reason_of(pair), pair.samples);
        }
        for (const RowSum& row : kept.matrix.rows) add(row.value), add(row.low), add(row.high);
        for (const double value : {kept.request.tolerance, kept.request.level, kept.matrix.entry_level}) add(value);
        words += fmt::format("{} {}", kept.request.seed.value, kept.matrix.samples);
        return words;
    } catch (const UserError&) {
        return {};
    } catch (const IoError&) {
        return {};
    }
}

TEST_F(FormFactorStore, IsRefusedOrUnchangedAfterABitFlip) {
    save(kept);
    const std::string sound = read_or_refused(file());
    ASSERT_FALSE(sound.empty());
    std::ifstream in(file(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::mt19937_64 random(17);
    for (int copy = 0; copy < 1000; ++copy) {
        // Most of the pages are empty: bits that are used are taken.
        std::size_t bit = random() % (8 * bytes.size());
        while (bytes[bit / 8] == '\0') bit = random() % (8 * bytes.size());
        std::string flipped = bytes;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        std::ofstream(file(), std::ios::binary) << flipped;
        const std::string words = read_or_refused(file());
        EXPECT_TRUE(words.empty() || words == sound) << "bit " << bit;
    }
}

TEST_F(FormFactorStore, RestoresDroppedPairs) {
    const KeptMatrix saved = found(scene_source("nested_cubes"), false, 0.2);
    ASSERT_GT(saved.matrix.dropped, 0u);
    save(saved);
    const KeptMatrix read = load_matrix(file());
    EXPECT_EQ(read.request.drop, 0.2);
    expect_equal(read.matrix, saved.matrix);
}

TEST_F(FormFactorStore, IsReadWithoutATableOfDroppedPairs) {
    save(kept);
    Database database(file(), Database::Mode::create_or_open);
    database.execute("DROP TABLE dropped");
    database.execute(test::form_factors_as_version_1);
    expect_equal(load_matrix(file()).matrix, kept.matrix);
}

TEST_F(FormFactorStore, IsRepairedLaterExactlyAsDuringTheRun) {
    KeptMatrix plain = found(scene_source("nested_cubes"), false);
    save(plain);
    EXPECT_EQ(Eigen::MatrixXd(repair(load_matrix(file()).matrix).factors),
              Eigen::MatrixXd(found(scene_source("nested_cubes"), true).matrix.repaired->factors));
}

TEST_F(FormFactorStore, IsRefusedIfItIsAnotherKindOfFile) {
    EXPECT_THAT(refusal<IoError>(), HasSubstr("no such file"));
    std::ofstream(file()) << "this is a text, long enough to be taken for something else than an empty file";
    EXPECT_THAT(refusal<UserError>(), HasSubstr("no SQLite file"));
    std::filesystem::remove(file());
    test::run(test::plan_of(test::study_text("trials = 2", test::random_rays)), file());
    EXPECT_THAT(refusal<UserError>(), HasSubstr("a result store (expected a store of form factors)"));
    save(kept);
    EXPECT_THAT(message_of<UserError>([&] { Store::open(file()); }),
                HasSubstr("a store of form factors (expected a result store)"));
    Database(file(), Database::Mode::create_or_open).execute("UPDATE about SET value = 5 WHERE key = 'schema_version'");
    EXPECT_THAT(refusal<UserError>(), HasSubstr("schema version 5 (this program reads 1 to 4)"));
}

TEST_F(FormFactorStore, IsRefusedIfDamaged) {
    EXPECT_EQ(refusal_after("SELECT 1"), "nothing thrown");
    EXPECT_THAT(refusal_after("UPDATE pairs SET low = 2"), HasSubstr("damaged (an interval that no run has written)"));
    EXPECT_THAT(refusal_after("UPDATE pairs SET high = 9e999"), HasSubstr("an interval"));
    EXPECT_THAT(refusal_after("UPDATE pairs SET from_face = 9"), HasSubstr("a number of a face"));
    EXPECT_THAT(refusal_after("UPDATE pairs SET from_face = 0"), HasSubstr("a number of a face"));
    EXPECT_THAT(refusal_after("UPDATE pairs SET from_face = to_face, to_face = from_face"), HasSubstr("a pair"));
    EXPECT_THAT(refusal_after("UPDATE pairs SET method = 'magic'"), HasSubstr("a method"));
    EXPECT_THAT(refusal_after("UPDATE pairs SET reason = ''"), HasSubstr("a method"));
    EXPECT_THAT(refusal_after("UPDATE faces SET area = 0"), HasSubstr("an area"));
    EXPECT_THAT(refusal_after("UPDATE faces SET name = 'x'"), HasSubstr("a face"));
    EXPECT_THAT(refusal_after("DELETE FROM faces WHERE face = 2"), HasSubstr("a number of faces"));
    EXPECT_THAT(refusal_after("DELETE FROM about WHERE key = 'level'"), HasSubstr("level"));
    EXPECT_THAT(refusal_after("UPDATE about SET value = -1 WHERE key = 'samples'"), HasSubstr("samples"));
    save(kept);
    Database(file(), Database::Mode::create_or_open).execute("DROP TABLE pairs");
    EXPECT_THAT(refusal<UserError>(), HasSubstr("table 'pairs' is missing"));
    save(kept);
    Database(file(), Database::Mode::create_or_open).execute("ALTER TABLE pairs ADD COLUMN more AS (low + high)");
    EXPECT_THAT(refusal<UserError>(), HasSubstr("table 'pairs' is defined otherwise"));
    // Bytes in the middle of the file are overwritten, as by a failing disk.
    kept = found(scene_source("nested_cubes"), true);
    save(kept);
    std::fstream(file(), std::ios::in | std::ios::out | std::ios::binary)
        .seekp(static_cast<std::streamoff>(std::filesystem::file_size(file()) / 2))
        .write(std::string(4096, 'x').data(), 4096);
    EXPECT_THAT(refusal<IoError>(), HasSubstr("damaged"));
}

}  // namespace
}  // namespace ff::studies::form_factors
