#include "app/folders/earlier_files.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

namespace ff::app {
namespace {

/// What a file of this name, or with such an end of its name, begins with and what is somewhere in it.
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

}  // namespace

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

}  // namespace ff::app
