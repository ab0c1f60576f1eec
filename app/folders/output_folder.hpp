#pragma once

#include "app/folders/folder_lock.hpp"
#include "app/process/signals.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// A folder that results are written to, by one process at a time. Files that are not its owner's are never replaced
/// or removed: the folder keeps a list of what was written for whom, and what an earlier version of the program wrote
/// is known by how it begins.
class OutputFolder {
  public:
    /// Makes it, with those above. @param owner  what its files are of: "check", or a study
    /// @param files  that will be written, as for `expect_own`
    /// @throws IoError where it cannot be made, or another process writes there
    OutputFolder(std::filesystem::path path, std::string owner, const std::vector<std::string>& files = {});
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Files of all owners of this kind ("study") are this owner's as well.
    void inherit(std::string_view kind);

    /// Before work that takes long: may these files be written? @throws IoError that names the first that may not
    void expect_own(const std::vector<std::string>& names) const;

    /// Writes a file, whole or not at all; its name may begin with the name of a folder in this one.
    /// @throws IoError
    void write(const std::string& name, const std::function<void(std::ostream&)>& write);
    void write(const std::string& name, std::string_view text);
    /// The same for a file that `write` fills by itself: it is given the name of an empty one.
    void replace(const std::string& name, const std::function<void(const std::filesystem::path&)>& write);

    /// @throws IoError
    void remove(const std::string& name);

    /// A new empty folder in it for what is made on the way; removed with this object.
    [[nodiscard]] std::filesystem::path make_workshop() const;

  private:
    void read_list();
    void clean() const;
    void leave() const;
    /// Makes ready for writing a file: its folder is there, it is the owner's, the list says so.
    void claim(const std::string& name);
    [[nodiscard]] bool is_own(const std::string& name) const;

    std::filesystem::path topmost_made_;  ///< of the folders that were not there before; empty if all were
    std::filesystem::path path_;
    std::string owner_;
    FolderLock lock_;
    std::map<std::string, std::string> owners_;  ///< of the files, by name
    OnEnd end_;
};

}  // namespace ff::app
