#include "reports/templates/templates.hpp"

#include "core/support/error.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace ff::reports {
namespace {

constexpr std::array<std::string_view, 4> suffixes{".mustache", ".css", ".js", ".json"};

std::string read_text(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw IoError("{}: cannot be read. Check the permissions.", file.string());
    return std::move(text).str();
}

}  // namespace

Templates Templates::read(std::span<const std::filesystem::path> folders) {
    std::map<std::string, std::string, std::less<>> files;
    for (const std::filesystem::path& folder : folders) {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
            const std::string kind = entry.path().extension().string();
            if (entry.is_regular_file() && std::find(suffixes.begin(), suffixes.end(), kind) != suffixes.end())
                files.insert_or_assign(entry.path().filename().string(), read_text(entry.path()));
        }
        if (error) {
            throw IoError("{}: no folder of templates ({}). Give one that can be read.", folder.string(),
                          error.message());
        }
    }
    return Templates(std::move(files));
}

const std::string& Templates::text(std::string_view name) const {
    const auto found = files_.find(name);
    if (found == files_.end()) {
        throw UserError(
            "{}: no such template (the installation is not whole). Install ffstudy again, or "
            "add the file to the folder given with --templates.",
            name);
    }
    return found->second;
}

}  // namespace ff::reports
