#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace ff::reports {

/// A file that numpy.load reads: a zip archive, not compressed, of arrays in NumPy's format. The same arrays give the
/// same bytes.
class NpzFile {
  public:
    /// @param bytes  of all arrays together @param content  what they are, in words
    /// @throws UserError for more than a zip archive holds, 4 GiB
    NpzFile(std::ostream& out, std::size_t bytes, std::string_view content);

    /// Adds an array of 4-byte or 8-byte integers or floating-point numbers. @param shape  as Python writes a tuple
    void add(std::string_view name, std::string_view shape, std::span<const std::int32_t> values);
    void add(std::string_view name, std::string_view shape, std::span<const std::int64_t> values);
    void add(std::string_view name, std::string_view shape, std::span<const float> values);
    void add(std::string_view name, std::string_view shape, std::span<const double> values);
    /// Adds a text without a dimension.
    void add(std::string_view name, std::string_view text);

    /// Ends the file; nothing may be added any more.
    void finish();

  private:
    std::ostream& out_;
    std::string directory_;
    std::uint64_t size_ = 0;
    std::uint16_t files_ = 0;

    void add_file(std::string_view array, const std::string& content);
    void put(std::string_view bytes);
};

}  // namespace ff::reports
