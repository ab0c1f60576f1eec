#include "app/folders/folder_lock.hpp"

#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>

namespace ff::app {
namespace {

/// Reports are written within this time; a run is not waited for.
constexpr std::chrono::seconds patience{10};
constexpr std::chrono::milliseconds lock_pause{20};

/// The command line, without what could play tricks on a terminal.
std::string command_line() {
    std::ifstream in("/proc/self/cmdline", std::ios::binary);
    std::string words{std::istreambuf_iterator<char>(in), {}};
    while (!words.empty() && words.back() == '\0') words.pop_back();
    std::replace(words.begin(), words.end(), '\0', ' ');
    std::replace_if(
        words.begin(), words.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
    return words;
}

std::string this_process() {
    utsname host{};
    return fmt::format("process {} on {} since {:%Y-%m-%dT%H:%M:%SZ}: {}\n", ::getpid(),
                       ::uname(&host) == 0 ? host.nodename : "an unknown host", fmt::gmtime(std::time(nullptr)),
                       command_line());
}

std::string holder(const std::filesystem::path& file) {
    constexpr std::size_t shown = 300;
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    if (line.size() > shown) line = line.substr(0, shown) + "...";
    return line.empty() ? "another program" : line;
}

bool is_still_there(const std::filesystem::path& file, int descriptor) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
           opened.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / ".ffstudy.lock") {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        constexpr mode_t all_that_the_user_allows = 0666;
        descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, all_that_the_user_allows);
        if (descriptor_ < 0) reports::fail_to_write(file_, errno);
        const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
        const int error = errno;
        if (locked && is_still_there(file_, descriptor_)) break;
        if (!locked && error != EWOULDBLOCK && error != EINTR) {
            say("note: {}: its file system has no locks ({}). Start no other ffstudy that writes there.\n",
                folder.string(), std::generic_category().message(error));
            break;
        }
        ::close(descriptor_);
        if (locked) continue;  // its holder removed it in between
        if (std::chrono::steady_clock::now() > end) {
            throw IoError("{}: in use ({}). Wait until it has ended, or choose another --out.", folder.string(),
                          holder(file_));
        }
        std::this_thread::sleep_for(lock_pause);
    }
    const std::string words = this_process();
    // The lock holds without these words.
    if (::ftruncate(descriptor_, 0) == 0 && ::write(descriptor_, words.data(), words.size()) < 0) return;
}

FolderLock::~FolderLock() {
    remove_file();
    ::close(descriptor_);
}

void FolderLock::remove_file() const {
    if (is_still_there(file_, descriptor_)) ::unlink(file_.c_str());
}

}  // namespace ff::app
