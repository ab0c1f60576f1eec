#pragma once

#include <array>
#include <streambuf>

namespace ff::reports {

/// Writes a stream to an open file, and keeps the system's error code of the first failed write. std::filebuf does not,
/// and errno may have changed by then.
class FileBuffer : public std::streambuf {
  public:
    explicit FileBuffer(int descriptor);
    /// errno; 0 while nothing has failed.
    [[nodiscard]] int error() const { return error_; }

  protected:
    int_type overflow(int_type next) override;
    int sync() override;

  private:
    bool write_out();
    int descriptor_;
    int error_ = 0;
    std::array<char, 1 << 16> bytes_{};
};

}  // namespace ff::reports
