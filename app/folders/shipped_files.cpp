#include "app/folders/shipped_files.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"

#include "app/build_info.hpp"

#include <algorithm>
#include <fstream>

namespace ff::app {
namespace {

/// A folder of the installed program, by its place beside it; empty where the program runs from its build.
std::filesystem::path installed_folder(std::string_view place) {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) return {};
    auto folder = program.parent_path() / place;
    return std::filesystem::is_directory(folder, error) ? folder : std::filesystem::path();
}

std::filesystem::path studies_folder() {
    const auto installed = installed_folder(build_info::installed_studies);
    return installed.empty() ? std::filesystem::path(build_info::source_studies) : installed;
}

/// Folders of the templates that come with the program.
std::vector<std::filesystem::path> template_folders() {
    if (const auto installed = installed_folder(build_info::installed_templates); !installed.empty())
        return {installed};
    return {build_info::source_templates, build_info::source_pictures};
}

}  // namespace

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
    throw UserError("'{}' is neither a study file nor a built-in study. {}See 'ffstudy list studies'.", name_or_file,
                    did_you_mean(name_or_file, names));
}

std::vector<Term> glossary() {
    const auto installed = installed_folder(build_info::installed_documents);
    std::ifstream file((installed.empty() ? std::filesystem::path(build_info::source_documents) : installed) /
                       "glossary.md");
    std::vector<Term> terms;
    for (std::string line; std::getline(file, line);) {  // "- **term**: meaning", or "- **term, another**: meaning"
        constexpr std::string_view begin = "- **";
        constexpr std::string_view middle = "**: ";
        const std::size_t end = line.find(middle);
        if (!line.starts_with(begin) || end == std::string::npos) continue;
        std::string meaning = line.substr(end + middle.size());
        std::erase(meaning, '*');
        std::string_view names = std::string_view(line).substr(begin.size(), end - begin.size());
        while (!names.empty()) {
            const std::string_view name = names.substr(0, names.find(", "));
            terms.push_back({std::string(name), meaning});
            names.remove_prefix(std::min(names.size(), name.size() + 2));
        }
    }
    return terms;
}

reports::Templates find_templates(const std::filesystem::path& own) {
    auto folders = template_folders();
    if (!own.empty()) folders.push_back(own);
    return reports::Templates::read(folders);
}

std::filesystem::path find_template_file(std::string_view name) {
    for (const auto& folder : template_folders()) {
        if (std::filesystem::exists(folder / name)) return folder / name;
    }
    return {};
}

}  // namespace ff::app
