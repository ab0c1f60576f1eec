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

void synchronise(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail(file, errno);
    const int status = ::fsync(descriptor);
    const int error = errno;
    ::close(descriptor);
    if (status != 0) fail(file, error);
}

}  // namespace

void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
    std::filesystem::path temporary = file;
    temporary += ".part";
    try {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        if (!out) fail(file, errno);
        write(out);
        out.close();
        if (!out) fail(file, errno);
        synchronise(temporary);
        std::error_code error;
        std::filesystem::rename(temporary, file, error);
        if (error) fail(file, error.value());
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
