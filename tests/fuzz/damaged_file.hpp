#pragma once

#include "studies/store/sqlite.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

/// A sound SQLite file and a place for damaged copies of it; removed at the end.
class DamagedFile {
  public:
    /// @param make  writes the sound file to the path that it is given
    template <class Make>
    explicit DamagedFile(Make make) {
        std::string name = (std::filesystem::temp_directory_path() / "ffstudy-fuzz-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
        folder_ = name;
        make(path());
        std::ifstream in(path(), std::ios::binary);
        sound_.assign(std::istreambuf_iterator<char>(in), {});
    }
    ~DamagedFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    DamagedFile(const DamagedFile&) = delete;
    DamagedFile& operator=(const DamagedFile&) = delete;

    [[nodiscard]] std::filesystem::path path() const { return folder_ / "file.sqlite"; }

    /// Makes a copy and changes it: in the input, 'b' and five bytes overwrite a byte of the file, 'c' and five cut it
    /// off, 'v' and nine bytes set a value.
    /// @param set_value  of (database, a byte that says which, value)
    template <class SetValue>
    void damage(const std::uint8_t* data, std::size_t size, SetValue set_value) const {
        for (const char* suffix : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(path().string() + suffix);
        std::string bytes = sound_;
        // Changes to bytes come first: SQL needs a file.
        for (std::size_t i = 0; i + 6 <= size && data[i] != 'v'; i += 6) {
            if (bytes.empty()) break;
            const std::size_t at = number<std::uint32_t>(data + i + 1) % bytes.size();
            if (data[i] == 'b') bytes[at] = static_cast<char>(data[i + 5]);
            if (data[i] == 'c') bytes.resize(at);
        }
        std::ofstream(path(), std::ios::binary | std::ios::trunc)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (bytes != sound_) return;
        for (std::size_t i = 0; i + 10 <= size && data[i] == 'v'; i += 10) {
            const ff::studies::Database database(path(), ff::studies::Database::Mode::create_or_open);
            set_value(database, data[i + 1], number<double>(data + i + 2));
        }
    }

  private:
    std::filesystem::path folder_;
    std::string sound_;

    template <class Number>
    static Number number(const std::uint8_t* bytes) {
        Number value = 0;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }
};
