#pragma once

#include "studies/form_factors/request.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/store/store_format.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ff::studies::form_factors {

/// Binds values to all parameters of a statement, in order, and runs it: texts, numbers (whole ones and truth values as
/// 64-bit integers) and blobs.
template <class... Values>
void run_with(Statement& statement, const Values&... values) {
    int parameter = 0;
    const auto bind = [&]<class Value>(const Value& value) {
        if constexpr (std::is_integral_v<Value>)
            statement.bind(parameter++, static_cast<std::int64_t>(value));
        else if constexpr (std::is_convertible_v<Value, std::string_view>)
            statement.bind(parameter++, std::string_view(value));
        else
            statement.bind(parameter++, value);
    };
    (bind(values), ...);
    statement.run();
}

/// The table of keys and values of a file, in which every number has to make sense.
class StoredKeys {
  public:
    /// The arguments are kept by reference.
    StoredKeys(const Database& database, const StoreFormat& format, const std::filesystem::path& file)
        : database_(database), format_(format), file_(file) {}

    /// @throws IoError unless `sound`
    void expect(bool sound, std::string_view what) const;

    /// @throws IoError where the key has none
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] double real(std::string_view key) const;
    [[nodiscard]] std::uint64_t count(std::string_view key) const;
    [[nodiscard]] bool has(std::string_view key) const { return stored_value(database_, format_, key).has_value(); }

  private:
    const Database& database_;
    const StoreFormat& format_;
    const std::filesystem::path& file_;

    /// @param get  how to read a column of a statement
    template <class Get>
    [[nodiscard]] auto value(std::string_view key, Get get) const;
};

/// Scene and request of a matrix, as far as the result depends on them, in a table of keys and values.
void write_request(const Database& database, const StoreFormat& format, const SceneSource& source,
                   const Request& request);

/// What a matrix differs in from one that is wanted, in words such as "its seed is 1, not 2"; empty where it is the
/// same.
std::string difference_between(const SceneSource& source, const Request& request, const SceneSource& wanted_source,
                               const Request& wanted);

/// The source and the request that were written.
std::pair<SceneSource, Request> read_request(const StoredKeys& keys);

}  // namespace ff::studies::form_factors
