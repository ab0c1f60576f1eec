#include "studies/store/sqlite.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

TEST(Journal, IsARollbackJournalOnNetworkFileSystems) {
    for (const std::uint64_t type : {0x6969u, 0xff534d42u, 0x0bd00bd0u, 0x65735546u})
        EXPECT_EQ(journal_for(type), Journal::rollback) << type;
}

TEST(Journal, IsAWriteAheadLogOnLocalOnes) {
    // ext4, XFS, Btrfs, tmpfs, overlayfs
    for (const std::uint64_t type : {0xef53u, 0x58465342u, 0x9123683eu, 0x01021994u, 0x794c7630u})
        EXPECT_EQ(journal_for(type), Journal::write_ahead) << type;
}

TEST(Journal, IsChosenByTheFolder) {
    EXPECT_EQ(journal_in("/proc"), Journal::write_ahead);  // never on a network, wherever this test runs
    EXPECT_THROW(journal_in("/proc/no/such/folder"), IoError);
}

}  // namespace
}  // namespace ff::studies
