#include "reports/output_file.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace ff::reports {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
    throw IoError(fmt::format("{}: cannot be written ({}). Check the folder, its permissions and the free space.",
                              file.string(), error == 0 ? "output error" : std::generic_category().message(error)));
}

/// Waits until a file, or the names in a folder, are on the disk.
void synchronise(const std::filesystem::path& place, const std::filesystem::path& file) {
    const int descriptor = ::open(place.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail(file, errno);
    const int status = ::fsync(descriptor);
    const int error = errno;
    const bool closed = ::close(descriptor) == 0;
    // Some file systems cannot synchronise a folder and say so.
    if (status != 0 && !(error == EINVAL && place != file)) fail(file, error);
    if (!closed) fail(file, errno);
}

}  // namespace

void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
    replace_file(file, [&](const std::filesystem::path& temporary) {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        if (!out) fail(file, errno);
        write(out);
        out.close();
        if (!out) fail(file, errno);
    });
}

void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write) {
    std::filesystem::path temporary = file;
    temporary += ".part";
    try {
        std::error_code error;
        std::filesystem::remove(temporary, error);  // of a run that was killed
        write(temporary);
        synchronise(temporary, temporary);
        std::filesystem::rename(temporary, file, error);
        if (error) fail(file, error.value());
        synchronise(file.has_parent_path() ? file.parent_path() : ".", file);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw;
    }
}

void write_file(const std::filesystem::path& file, std::string_view text) {
    write_file(file, [&](std::ostream& out) { out << text; });
}

}  // namespace ff::reports
