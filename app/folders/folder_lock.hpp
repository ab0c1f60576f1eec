#pragma once

#include <filesystem>

namespace ff::app {

/// The right to write into a folder, which one process has at a time: a lock of the system (flock), gone with its
/// process however it ends, on a file that says who has it. Those who only read need none.
class FolderLock {
  public:
    /// Waits a little for another process that has it. @throws IoError that names that one
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Removes the file; only while the lock is held, so that no other's is removed.
    void remove_file() const;

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace ff::app
