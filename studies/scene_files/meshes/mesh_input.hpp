#pragma once

#include <fmt/format.h>
#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies::meshes {

enum class Encoding { text, little_endian, big_endian };

/// How a file holds its numbers.
struct NumberType {
    enum class Kind { integer, natural, real };
    Kind kind = Kind::real;
    std::size_t bytes = 8;  ///< 1, 2, 4 or 8; a real number has 4 or 8

    [[nodiscard]] bool is_whole() const { return kind != Kind::real; }
};

/// The names of a type of numbers in each format: lists of words, each of which is a name.
struct NumberTypeNames {
    NumberType type;
    std::string_view ply;
    std::string_view vtk_legacy;  ///< names in capitals
    std::string_view vtk_xml;
};

/// The type of that name in a format; empty where it has none.
std::optional<NumberType> number_type_named(std::string_view name, std::string_view NumberTypeNames::*format);

inline constexpr NumberType int32_type{NumberType::Kind::integer, 4};
inline constexpr NumberType float64_type{NumberType::Kind::real, 8};

/// The bytes of a mesh file, or of a part of it, from front to back. Missing data is a UserError, and no storage is
/// allocated for more numbers than the rest of the file can hold.
class MeshInput {
  public:
    /// @param name  of the file for messages, which have the line too, or the byte where numbers are binary
    MeshInput(std::string_view name, std::string_view bytes) : name_(name), bytes_(bytes) {}
    /// A part of a file that is stored in another form. @param name  of file and part, which is all that messages state
    static MeshInput part(std::string_view name, std::string_view bytes, Encoding encoding);

    /// Reads numbers in this encoding from here on; lines and words can still be read.
    void set_encoding(Encoding encoding) { encoding_ = encoding; }
    [[nodiscard]] Encoding encoding() const { return encoding_; }

    /// Names the part that is being read, for messages.
    void set_section(std::string_view section) { section_ = section; }

    /// Whether nothing follows but blanks.
    [[nodiscard]] bool at_end();
    /// The rest of the line, without its end, which is skipped.
    std::string_view line();
    std::string_view word();
    /// The word that comes next; empty at the end.
    [[nodiscard]] std::string_view next_word() const;
    /// A word that is a whole number from 0 on.
    std::uint64_t count();
    /// Skips everything up to and including a text. @throws UserError where the text does not occur
    void skip_past(std::string_view text);
    void skip_bytes(std::size_t count);
    std::string_view take_bytes(std::size_t count);

    double real(NumberType type);
    /// The same. @throws UserError where it is not finite
    double coordinate(NumberType type);
    /// Three coordinates.
    Eigen::Vector3d place(NumberType type);
    std::int64_t whole(NumberType type);
    std::vector<double> reals(NumberType type, std::uint64_t tuples, std::uint64_t components);
    std::vector<std::int64_t> wholes(NumberType type, std::uint64_t tuples, std::uint64_t components);
    void skip(NumberType type, std::uint64_t tuples, std::uint64_t components);

    /// @throws UserError unless so many tuples may follow, each of at least so many numbers of at least so many bytes
    void expect_room(std::uint64_t tuples, std::uint64_t components, std::size_t bytes) const;

    /// @throws UserError where an index that has just been read is out of range for this many points
    void expect_index(std::int64_t index, std::uint64_t points) const;

    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
    /// The problem may have values in it as for fmt::format. @throws UserError "file:line: section: problem"
    [[noreturn]] void fail(std::string_view problem) const;
    template <class... Values>
    [[noreturn]] void fail(fmt::format_string<Values...> problem, Values&&... values) const {
        fail(fmt::format(problem, std::forward<Values>(values)...));
    }

  private:
    std::string name_;
    std::string_view bytes_;
    Encoding encoding_ = Encoding::text;
    bool is_whole_ = true;
    std::string section_;
    std::size_t at_ = 0;

    void skip_blanks();
    /// @param problem  the problem of a word that is not such a number
    template <class Number>
    Number number_in_text(std::string_view problem);
    /// The bytes of a binary number, least significant first.
    std::array<char, 8> binary(NumberType type);
};

}  // namespace ff::studies::meshes
