#pragma once

#include "app/folders/folder_lock.hpp"
#include "app/process/signals.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// A folder that results are written to, by one process at a time. Files of other owners are never replaced or removed:
/// the folder keeps a list of files with owners, and files from an earlier version of the program are recognised by how
/// they begin.
class OutputFolder {
  public:
    /// Creates it, with its parents. @param owner what its files belong to: "check", or a study
    /// @param files  files that will be written, as for `expect_own`
    /// @throws IoError where it cannot be made, or another process writes there
    OutputFolder(std::filesystem::path path, std::string owner, const std::vector<std::string>& files = {});
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Treats files of all owners of this kind ("study") as this owner's.
    void inherit(std::string_view kind);

    /// Before long work: checks that these files may be written. @throws IoError with the first that may not
    void expect_own(const std::vector<std::string>& names) const;

    /// Writes a file completely or not at all; its name may begin with a subfolder.
    /// @throws IoError
    void write(const std::string& name, const std::function<void(std::ostream&)>& write);
    void write(const std::string& name, std::string_view text);
    /// The same for a file that `write` fills itself: it receives the name of an empty one.
    void replace(const std::string& name, const std::function<void(const std::filesystem::path&)>& write);

    /// @throws IoError
    void remove(const std::string& name);

    /// A new empty subfolder for intermediate files; removed with this object.
    [[nodiscard]] std::filesystem::path make_workshop() const;

  private:
    void read_list();
    void clean() const;
    void leave() const;
    /// Prepares for writing a file: creates its folder, checks the owner, updates the list.
    void claim(const std::string& name);
    [[nodiscard]] bool is_own(const std::string& name) const;

    std::filesystem::path topmost_made_;  ///< topmost created folder; empty if all existed
    std::filesystem::path path_;
    std::string owner_;
    FolderLock lock_;
    mutable std::mutex mutex_;                   ///< of changes of `owners_`: a signal's thread cleans the folders
    std::map<std::string, std::string> owners_;  ///< owner of each file, by the file's name
    OnEnd end_;
};

}  // namespace ff::app
