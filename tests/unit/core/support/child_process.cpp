#include "core/support/child_process.hpp"

#include "core/support/error.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <string>

namespace ff {
namespace {

constexpr std::uint64_t much = 1u << 24;
constexpr double long_time = 60;

ChildOutput shell(const std::string& script, std::uint64_t most = much, double deadline = long_time) {
    return read_from_child({{"sh", "-c", script}, {}}, most, deadline);
}

TEST(ChildProcess, ReturnsTheOutputAndTheExitCode) {
    const auto output = shell("echo out; echo err >&2; exit 3");
    EXPECT_EQ(output.end, ChildOutput::End::exited);
    EXPECT_EQ(output.code, 3);
    EXPECT_EQ(output.output, "out\n");
    EXPECT_EQ(output.errors, "err\n");
}

TEST(ChildProcess, RunsInTheGivenFolderWithoutInput) {
    const auto output = read_from_child({{"sh", "-c", "pwd; cat"}, "/"}, much, long_time);
    EXPECT_EQ(output.output, "/\n");
}

TEST(ChildProcess, DistinguishesASignalFromAnExitCode) {
    const auto output = shell("kill -SEGV $$");
    EXPECT_EQ(output.end, ChildOutput::End::killed);
    EXPECT_EQ(output.code, SIGSEGV);
}

TEST(ChildProcess, ReadsMoreThanAPipeHolds) {
    const auto output = shell("head -c 1000000 /dev/zero; head -c 1000000 /dev/zero >&2");
    EXPECT_EQ(output.output.size(), 1000000u);
    EXPECT_GE(output.errors.size(), 1000u);
    EXPECT_LE(output.errors.size(), 100000u);
}

TEST(ChildProcess, StopsProgramsThatPrintTooMuchOrTakeTooLong) {
    EXPECT_EQ(shell("cat /dev/zero", 100000).end, ChildOutput::End::too_large);
    EXPECT_EQ(shell("sleep 1000", much, 0.1).end, ChildOutput::End::too_slow);
    EXPECT_EQ(shell("exec >&- 2>&-; sleep 1000", much, 0.1).end, ChildOutput::End::too_slow);
    EXPECT_EQ(shell("sleep 1000 & echo left behind", much, 0.1).end, ChildOutput::End::too_slow);
}

TEST(ChildProcess, ReportsProgramsThatCannotBeStarted) {
    EXPECT_THROW(read_from_child({{"./there_is_none"}, {}}, much, long_time), IoError);
    EXPECT_THROW(read_from_child({{"true"}, "/there/is/none"}, much, long_time), IoError);
}

}  // namespace
}  // namespace ff
