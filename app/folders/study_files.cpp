#include "app/folders/study_files.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace ff::app {

std::filesystem::path studies_folder() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        auto installed = program.parent_path() / build_info::installed_studies;
        if (std::filesystem::is_directory(installed, error)) return installed;
    }
    return build_info::source_studies;
}

std::vector<BuiltInStudy> built_in_studies() {
    std::vector<BuiltInStudy> list;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(studies_folder(), error)) {
        if (entry.path().extension() != ".toml") continue;
        const auto spec = studies::load_study(entry.path());
        list.push_back({spec.name, spec.title, entry.path()});
    }
    std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return list;
}

std::filesystem::path find_study(const std::string& name_or_file) {
    const auto list = built_in_studies();
    for (const BuiltInStudy& study : list) {
        if (study.name == name_or_file) return study.file;
    }
    std::filesystem::path file(name_or_file);
    if (std::filesystem::exists(file) || file.extension() == ".toml") return file;
    std::vector<std::string_view> names;
    for (const BuiltInStudy& study : list) names.push_back(study.name);
    throw UserError(fmt::format("'{}' is neither a study file nor a built-in study. {}See 'ffstudy list studies'.",
                                name_or_file, did_you_mean(name_or_file, names)));
}

}  // namespace ff::app
