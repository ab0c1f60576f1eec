#include "app/folders/output_folder.hpp"

#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

namespace ff::app {
namespace {

constexpr const char* list_name = ".ffstudy.files";

std::filesystem::path make_folder(std::filesystem::path folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw IoError("{}: cannot be made ({}). Choose another --out.", folder.string(), error.message());
    return folder;
}

/// The topmost folder of this path that is not there; empty if all are.
std::filesystem::path topmost_missing(const std::filesystem::path& folder) {
    std::filesystem::path missing;
    for (auto path = std::filesystem::absolute(folder); !std::filesystem::exists(path); path = path.parent_path())
        missing = path;
    return missing;
}

/// Removes temporary files that a program left here when it was ended.
void remove_temporaries(const std::filesystem::path& folder) {
    std::error_code error;
    std::vector<std::filesystem::path> found;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().filename().string().starts_with(reports::temporary_prefix)) found.push_back(entry->path());
    }
    for (const auto& path : found) std::filesystem::remove_all(path, error);
}

/// How a file with this name, or with this ending, begins, and a text that it contains.
struct Mark {
    std::string_view end_of_name;
    std::string_view begin;
    std::string_view word;
};

constexpr std::string_view made_by = "Made by ffstudy ";
/// The first that fits a name decides.
constexpr std::array marks{
    Mark{"report.html", "<!doctype html>", made_by},
    Mark{"comparison.html", "<!doctype html>", "<h1>Two runs side by side"},
    Mark{"report.md", "# ", made_by},
    Mark{"audit.md", "# Audit of published tables\n", ""},
    Mark{"comparison.md", "# Two runs side by side\n", ""},
    Mark{"enclosure.md", "", "\n## Exact form factors\n"},
    Mark{"results.json", "{", R"("schema": "ffstudy.results/)"},
    Mark{"verdicts.json", "{", R"("schema": "ffstudy.)"},
    Mark{"context.json", "{", R"("command": "ffstudy )"},
    Mark{"form_factors.json", "{\n  \"scene\": ", "\"tolerance\": "},
    Mark{"junit.xml", "<?xml", "<testsuite"},
    Mark{"matrix.csv", "from,to,factor,low,high,half_width,", ""},
    Mark{"verdicts.csv", "gate,scene,method,", ""},
    Mark{"seed_sweep.csv", "gate,seeds,fails,", ""},
    Mark{"comparisons.csv", "study,scene,pair_class,equal,", ""},
    Mark{"comparisons_by_time.csv", "study,scene,pair_class,equal,", ""},
    Mark{".csv", "study,scene,method,", ""},
    Mark{".sqlite", "SQLite format 3", "CREATE TABLE about(key TEXT PRIMARY KEY"},
    Mark{".mtx", "%%MatrixMarket matrix ", ""},
    Mark{".npy", "\x93NUMPY", ""},
    Mark{".npz", "PK\x03\x04", "indices.npy"},
    Mark{".tex", "", "% Written by ffstudy"},
    Mark{".svg", "<svg", ""},
    Mark{".pdf", "%PDF-", ""},
};

/// Whether a file looks like one that ffstudy 0.1 wrote under this name, before it kept a list of written files; also
/// for folders that were copied without the list.
bool is_of_earlier_version(const std::filesystem::path& folder, const std::string& name) {
    const auto* const mark =
        std::find_if(marks.begin(), marks.end(), [&](const Mark& m) { return name.ends_with(m.end_of_name); });
    if (mark == marks.end()) return false;
    std::ifstream in(folder / name, std::ios::binary);
    std::string text(mark->begin.size(), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!in || text != mark->begin) return false;
    if (mark->word.empty()) return true;
    text.append(std::istreambuf_iterator<char>(in), {});
    return text.find(mark->word) != std::string::npos;
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path path, std::string owner, const std::vector<std::string>& files)
    : topmost_made_(topmost_missing(path)),
      path_(make_folder(std::move(path))),
      owner_(std::move(owner)),
      lock_(path_),
      end_([this] { leave(); }) {
    read_list();
    clean();
    expect_own(files);
}

OutputFolder::~OutputFolder() {
    leave();
}

/// Folders that were made for files that were never written are removed as well.
void OutputFolder::leave() const {
    clean();
    lock_.remove_file();
    std::error_code error;
    if (topmost_made_.empty()) return;
    for (auto path = std::filesystem::absolute(path_); !error; path = path.parent_path()) {
        std::filesystem::remove(path, error);
        if (path == topmost_made_) return;
    }
}

/// Cleans only folders to which results are written: others may belong to other runs.
void OutputFolder::clean() const {
    const std::lock_guard lock(mutex_);
    std::set<std::filesystem::path> folders{path_};
    for (const auto& [name, owner] : owners_) folders.insert((path_ / name).parent_path());
    for (const auto& folder : folders) remove_temporaries(folder);
}

/// One line a file, "OWNER\tNAME"; the last one counts.
void OutputFolder::read_list() {
    const std::lock_guard lock(mutex_);
    std::ifstream in(path_ / list_name);
    for (std::string line; std::getline(in, line);) {
        const auto tab = line.find('\t');
        if (tab != std::string::npos) owners_[line.substr(tab + 1)] = line.substr(0, tab);
    }
}

void OutputFolder::inherit(std::string_view kind) {
    const std::lock_guard lock(mutex_);
    for (auto& [name, owner] : owners_) {
        if (owner.starts_with(kind)) owner = owner_;
    }
}

bool OutputFolder::is_own(const std::string& name) const {
    const auto known = owners_.find(name);
    return known == owners_.end() ? is_of_earlier_version(path_, name) : known->second == owner_;
}

void OutputFolder::expect_own(const std::vector<std::string>& names) const {
    for (const std::string& name : names) {
        const auto file = path_ / name;
        const auto status = std::filesystem::symlink_status(file);
        if (!std::filesystem::exists(status)) continue;
        if (std::filesystem::is_directory(status)) {
            throw IoError("{}: cannot be written (a folder is in the way). Remove it, or choose another --out.",
                          file.string());
        }
        if (is_own(name)) continue;
        const auto known = owners_.find(name);
        throw IoError("{}: not replaced ({}). Move it away, or choose another --out.", file.string(),
                      known == owners_.end()
                          ? std::string("ffstudy has not written it")
                          : fmt::format("it is of another {}", known->second.substr(0, known->second.find(' '))));
    }
}

void OutputFolder::claim(const std::string& name) {
    make_folder((path_ / name).parent_path());
    expect_own({name});
    const auto known = owners_.find(name);
    if (known != owners_.end() && known->second == owner_) return;
    // Appended, so that a full disk costs no more than this line; the line break ends one that was cut off.
    std::ofstream out(path_ / list_name, std::ios::app | std::ios::binary);
    out << '\n' << owner_ << '\t' << name;
    out.close();
    if (!out) {
        throw IoError("{}: cannot be written. Check the folder, its permissions and the free space.",
                      (path_ / list_name).string());
    }
    const std::lock_guard lock(mutex_);
    owners_[name] = owner_;
}

void OutputFolder::write(const std::string& name, const std::function<void(std::ostream&)>& write) {
    claim(name);
    reports::write_file(path_ / name, write);
    say_more("wrote {}\n", (path_ / name).string());
}

void OutputFolder::write(const std::string& name, std::string_view text) {
    write(name, [&](std::ostream& out) { out << text; });
}

void OutputFolder::replace(const std::string& name, const std::function<void(const std::filesystem::path&)>& write) {
    claim(name);
    reports::replace_file(path_ / name, write);
}

void OutputFolder::remove(const std::string& name) {
    expect_own({name});
    std::error_code error;
    std::filesystem::remove(path_ / name, error);
    if (error) throw IoError("{}: cannot be removed ({}).", (path_ / name).string(), error.message());
}

std::filesystem::path OutputFolder::make_workshop() const {
    for (int number = 0;; ++number) {
        auto folder = path_ / fmt::format("{}folder-{}", reports::temporary_prefix, number);
        std::error_code error;
        if (std::filesystem::create_directory(folder, error)) return folder;
        if (error) {
            throw IoError("{}: cannot be made ({}). Check the folder, its permissions and the free space.",
                          folder.string(), error.message());
        }
    }
}

}  // namespace ff::app
