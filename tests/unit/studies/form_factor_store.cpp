#include "studies/form_factors/store.hpp"

#include "core/error.hpp"
#include "studies/form_factors/repair.hpp"
#include "studies/form_factors/words.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <tuple>
#include <utility>

namespace ff::studies {
namespace {

using test::message_of;
using testing::HasSubstr;

/// Two triangles face each other past a third; the file says that they are closed, which they are not.
constexpr const char* text = R"(# closed
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

KeptFormFactors found(std::string source, bool repaired) {
    KeptFormFactors kept;
    kept.source = std::move(source);
    kept.scene = make_scene(kept.source);
    kept.request.tolerance = 0.01;
    kept.request.level = 0.9;
    kept.request.level_of = LevelOf::matrix;
    kept.request.seed = Seed{7};
    kept.request.repair = repaired;
    kept.matrix = find_form_factors(kept.scene, kept.request);
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

void expect_equal(const FormFactorMatrix& a, const FormFactorMatrix& b) {
    EXPECT_EQ(a.areas, b.areas);
    EXPECT_EQ(std::tuple(a.surfaces, a.samples, a.rays, a.lost_rays, a.interrupted, a.entry_level),
              std::tuple(b.surfaces, b.samples, b.rays, b.lost_rays, b.interrupted, b.entry_level));
    ASSERT_EQ(a.exchanges.size(), b.exchanges.size());
    for (std::size_t p = 0; p < a.exchanges.size(); ++p) expect_equal(a.exchanges[p], b.exchanges[p]);
    ASSERT_EQ(a.rows.size(), b.rows.size());
    for (std::size_t i = 0; i < a.rows.size(); ++i) {
        EXPECT_EQ(std::tuple(a.rows[i].value, a.rows[i].low, a.rows[i].high, a.rows[i].excludes_one),
                  std::tuple(b.rows[i].value, b.rows[i].low, b.rows[i].high, b.rows[i].excludes_one));
    }
    ASSERT_EQ(a.repaired.has_value(), b.repaired.has_value());
    if (!a.repaired) return;
    EXPECT_EQ(a.repaired->factors, b.repaired->factors);
    EXPECT_EQ(a.repaired->possible, b.repaired->possible);
    EXPECT_EQ(a.repaired->largest_change, b.repaired->largest_change);
    EXPECT_EQ(a.repaired->outside, b.repaired->outside);
}

class FormFactorStore : public testing::Test {
  protected:
    std::filesystem::path file() const { return folder.path() / "form_factors.sqlite"; }
    void save(const KeptFormFactors& what) const {
        std::filesystem::remove(file());
        save_form_factors(file(), what);
    }
    template <typename Error>
    std::string refusal() const {
        return message_of<Error>([&] { load_form_factors(file()); });
    }
    /// What is said of the file when this has been done to it.
    std::string refusal_after(const std::string& sql) const {
        save(kept);
        Database(file(), Database::Mode::create_or_open).execute(sql.c_str());
        return refusal<IoError>();
    }
    test::TemporaryFolder folder;
    KeptFormFactors kept = found("squares_blocked", false);
};

TEST_F(FormFactorStore, GivesBackWhatWasSaved) {
    for (const auto& [source, repaired] :
         {std::pair(std::string("squares_blocked"), false), std::pair(std::string("nested_cubes"), true),
          std::pair(with_scene_text("room.obj", text), false)}) {
        const KeptFormFactors saved = found(source, repaired);
        save(saved);
        const KeptFormFactors read = load_form_factors(file());
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
    for (const ExchangeMethod method :
         {ExchangeMethod::closed_form, ExchangeMethod::contour, ExchangeMethod::points, ExchangeMethod::rays}) {
        for (int reason = 0; reason <= static_cast<int>(ExchangeReason::many_surfaces); ++reason) {
            FaceExchange& pair = kept.matrix.exchanges[1];
            pair.method = method;
            pair.by_rays_of_row = false;
            pair.reason = static_cast<ExchangeReason>(reason);
            pair.contradicted = pair.clipped = reason % 2 == 0;
            save(kept);
            expect_equal(load_form_factors(file()).matrix, kept.matrix);
        }
    }
    kept.matrix.exchanges[1].by_rays_of_row = true;
    save(kept);
    expect_equal(load_form_factors(file()).matrix, kept.matrix);
    kept.matrix.exchanges[1].method.reset();
    kept.matrix.interrupted = true;
    save(kept);
    expect_equal(load_form_factors(file()).matrix, kept.matrix);
}

TEST_F(FormFactorStore, IsRepairedAfterwardsAsTheRunWouldHave) {
    KeptFormFactors plain = found("nested_cubes", false);
    save(plain);
    EXPECT_EQ(repair(load_form_factors(file()).matrix).factors, found("nested_cubes", true).matrix.repaired->factors);
}

TEST_F(FormFactorStore, IsRefusedWhereItIsSomethingElse) {
    EXPECT_THAT(refusal<IoError>(), HasSubstr("no such file"));
    std::ofstream(file()) << "this is a text, long enough to be taken for something else than an empty file";
    EXPECT_THAT(refusal<UserError>(), HasSubstr("no SQLite file"));
    std::filesystem::remove(file());
    test::run(test::plan_of(test::study_text("trials = 2", test::random_rays)), file());
    EXPECT_THAT(refusal<UserError>(), HasSubstr("not a matrix of form factors (no table 'about')"));
    save(kept);
    EXPECT_THAT(message_of<UserError>([&] { Store::open(file()); }), HasSubstr("not a result store (no table 'meta')"));
    Database(file(), Database::Mode::create_or_open).execute("UPDATE about SET value = 2 WHERE key = 'schema_version'");
    EXPECT_THAT(refusal<UserError>(), HasSubstr("schema version 2 (this program reads 1)"));
}

TEST_F(FormFactorStore, IsRefusedWhereItIsDamaged) {
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
    EXPECT_THAT(refusal_after("DROP TABLE pairs"), HasSubstr("pairs"));
    // Bytes that are overwritten, as by a failing disk: of the middle of the file.
    kept = found("nested_cubes", true);
    save(kept);
    std::fstream(file(), std::ios::in | std::ios::out | std::ios::binary)
        .seekp(static_cast<std::streamoff>(std::filesystem::file_size(file()) / 2))
        .write(std::string(4096, 'x').data(), 4096);
    EXPECT_THAT(refusal<IoError>(), HasSubstr("damaged"));
}

}  // namespace
}  // namespace ff::studies
