#include "app/folders/template_files.hpp"

#include "app/build_info.hpp"

#include <vector>

namespace ff::app {
namespace {

/// Those that come with the program.
std::vector<std::filesystem::path> shipped_folders() {
    std::vector<std::filesystem::path> folders;
    std::error_code error;
    const auto installed =
        std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / build_info::installed_templates;
    if (!error && std::filesystem::is_directory(installed, error)) {
        folders.push_back(installed);
    } else {
        folders.emplace_back(build_info::source_templates);
        if (std::filesystem::is_directory(build_info::built_templates, error))
            folders.emplace_back(build_info::built_templates);
    }
    return folders;
}

}  // namespace

reports::Templates find_templates(const std::filesystem::path& own) {
    auto folders = shipped_folders();
    if (!own.empty()) folders.push_back(own);
    return reports::Templates::read(folders);
}

std::filesystem::path find_template_file(std::string_view name) {
    for (const auto& folder : shipped_folders()) {
        if (std::filesystem::exists(folder / name)) return folder / name;
    }
    return {};
}

}  // namespace ff::app
