#include "core/support/error.hpp"
#include "studies/run/run.hpp"
#include "studies/store/store.hpp"
#include "tests/support/earlier_stores.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

StudyPlan small_plan(int trials = 3) {
    return test::plan_of(test::study_text("trials = " + std::to_string(trials), test::random_rays));
}

class StoreChecksums : public testing::Test {
  protected:
    std::filesystem::path file() const { return folder.path() / "results.sqlite"; }
    void forget_checksums() const {
        Database(file(), Database::Mode::create_or_open).execute(test::store_as_version_1);
    }
    test::TemporaryFolder folder;
};

/// What is read from a store, and the message where it is refused.
std::vector<std::string> read_or_refused(const std::filesystem::path& file) {
    try {
        const Context context = Store::open(file).context();
        std::vector<std::string> rows = test::rows_of(file);
        for (const auto& [key, value] : context) rows.push_back(key + value);
        return rows;
    } catch (const UserError&) {
        return {};
    } catch (const IoError&) {
        return {};
    }
}

TEST_F(StoreChecksums, NoticeAFlippedBitThatChangesAnything) {
    {
        Store store = test::run(small_plan(60), file());
        store.set_context({{"host", "here"}, {"threads", "2"}});
        store.seal();
    }
    const auto sound = read_or_refused(file());
    ASSERT_FALSE(sound.empty());
    std::ifstream in(file(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::mt19937_64 random(17);
    int refused = 0;
    const auto copies = static_cast<int>(test::repetitions(300, 1000));
    for (int copy = 0; copy < copies; ++copy) {
        const std::size_t bit = random() % (8 * bytes.size());
        std::string flipped = bytes;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        std::ofstream(file(), std::ios::binary) << flipped;
        const auto rows = read_or_refused(file());
        if (rows.empty())
            ++refused;
        else
            EXPECT_EQ(rows, sound) << "bit " << bit;
    }
    EXPECT_GT(refused, copies / 2);
}

TEST_F(StoreChecksums, AreNotNeededToReadAnEarlierVersion) {
    test::run(small_plan(), file());
    const double before = Store::open(file()).series(0, observable::hits, 1, 2).value.front();
    EXPECT_TRUE(Store::open(file()).was_checked());
    forget_checksums();
    const Store store = Store::open(file());
    EXPECT_FALSE(store.was_checked());
    EXPECT_EQ(store.series(0, observable::hits, 1, 2).value.front(), before);
}

TEST_F(StoreChecksums, AreAddedWhenAnEarlierVersionIsResumed) {
    const auto whole = folder.path() / "whole.sqlite";
    test::run(small_plan(), whole);
    Store::create_or_resume(file(), small_plan());
    forget_checksums();
    {
        Store store = Store::create_or_resume(file(), small_plan());
        EXPECT_FALSE(store.was_checked());
        run_study(store, {});
    }
    EXPECT_TRUE(Store::open(file()).was_checked());
    EXPECT_EQ(test::rows_of(file()), test::rows_of(whole));
    forget_checksums();
    Store::create_or_resume(file(), small_plan());
    EXPECT_EQ(test::rows_of(file()), test::rows_of(whole));
}

}  // namespace
}  // namespace ff::studies
