#pragma once

#include <filesystem>

namespace ff::app {

/// The exclusive right to write into a folder: a system lock (flock), released when its process ends in any way, on a
/// file that names the owner. Readers need none.
class FolderLock {
  public:
    /// Waits a little for another process that holds it. @throws IoError that names that one
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Removes the file; only while the lock is held, so that no other process's file is removed.
    void remove_file() const;

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace ff::app
