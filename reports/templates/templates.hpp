#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace ff::reports {

/// The files that reports are made from, by name: templates (.mustache), style (.css), scripts (.js), pictures (.json).
class Templates {
  public:
    /// All files of these folders; a file of a later folder takes the place of one of the same name before it.
    /// @throws IoError where a folder or file cannot be read
    static Templates read(std::span<const std::filesystem::path> folders);

    explicit Templates(std::map<std::string, std::string, std::less<>> files) : files_(std::move(files)) {}

    /// @throws UserError where there is no such file
    [[nodiscard]] const std::string& text(std::string_view name) const;
    [[nodiscard]] const std::map<std::string, std::string, std::less<>>& files() const { return files_; }

  private:
    std::map<std::string, std::string, std::less<>> files_;
};

}  // namespace ff::reports
