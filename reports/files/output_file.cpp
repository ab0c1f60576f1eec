#include "reports/files/output_file.hpp"

#include "core/support/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>

namespace ff::reports {
namespace {

/// Writes a stream to an open file, and keeps the system's error code of the first failed write. std::filebuf does not,
/// and errno may have changed by then.
class FileBuffer : public std::streambuf {
  public:
    explicit FileBuffer(int descriptor) : descriptor_(descriptor) { empty(); }
    /// errno; 0 while nothing has failed.
    [[nodiscard]] int error() const { return error_; }

  protected:
    int_type overflow(int_type next) override {
        if (sync() != 0) return traits_type::eof();
        if (!traits_type::eq_int_type(next, traits_type::eof())) sputc(traits_type::to_char_type(next));
        return traits_type::not_eof(next);
    }
    int sync() override {
        for (const char* next = pbase(); error_ == 0 && next < pptr();) {
            const auto written = ::write(descriptor_, next, static_cast<std::size_t>(pptr() - next));
            if (written >= 0)
                next += written;
            else if (errno != EINTR)
                error_ = errno;
        }
        empty();
        return error_ == 0 ? 0 : -1;
    }

  private:
    void empty() { setp(bytes_.data(), bytes_.data() + bytes_.size()); }
    int descriptor_;
    int error_ = 0;
    std::array<char, 1 << 16> bytes_{};
};

/// The file's name within that of its temporary, for messages of libraries that fill it; cut to leave room for more.
std::string shown_name(const std::filesystem::path& file) {
    constexpr std::size_t most_bytes = 100;
    return file.filename().string().substr(0, most_bytes);
}

/// A file that nobody had before, beside the one that it will become; removed unless it does.
class Temporary {
  public:
    explicit Temporary(std::filesystem::path file) : file_(std::move(file)) {
        constexpr mode_t all_that_the_user_allows = 0666;
        for (std::uint64_t number = 0; descriptor_ < 0; ++number) {
            path_ = folder_of(file_) / fmt::format("{}{}-{}", temporary_prefix, number, shown_name(file_));
            descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, all_that_the_user_allows);
            if (descriptor_ < 0 && errno != EEXIST) fail_to_write(file_, errno);
        }
    }
    ~Temporary() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// Puts it in its place once all of it is on the disk.
    void deliver() {
        if (::fsync(descriptor_) != 0) fail_to_write(file_, errno);
        if (::close(std::exchange(descriptor_, -1)) != 0) fail_to_write(file_, errno);
        if (::rename(path_.c_str(), file_.c_str()) != 0) fail_to_write(file_, errno);
        path_.clear();
        synchronise_folder();
    }

  private:
    void synchronise_folder() const {
        const int folder = ::open(folder_of(file_).c_str(), O_RDONLY | O_CLOEXEC);
        if (folder < 0) fail_to_write(file_, errno);
        const int status = ::fsync(folder);
        const int error = errno;
        ::close(folder);
        // Some file systems cannot synchronise a folder and say so.
        if (status != 0 && error != EINVAL) fail_to_write(file_, error);
    }

    std::filesystem::path file_;
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace

void fail_to_write(const std::filesystem::path& file, int error) {
    throw IoError("{}: cannot be written ({}). Check the folder, its permissions and the free space.", file.string(),
                  error == 0 ? "output error" : std::generic_category().message(error));
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
    Temporary temporary(file);
    FileBuffer buffer(temporary.descriptor());
    std::ostream out(&buffer);
    write(out);
    out.flush();
    if (!out) fail_to_write(file, buffer.error());
    temporary.deliver();
}

void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write) {
    Temporary temporary(file);
    write(temporary.path());
    temporary.deliver();
}

void write_file(const std::filesystem::path& file, std::string_view text) {
    write_file(file, [&](std::ostream& out) { out << text; });
}

}  // namespace ff::reports
