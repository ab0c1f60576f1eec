#pragma once

#include "studies/form_factors/request.hpp"
#include "studies/scene_files/scene_source.hpp"
#include "studies/store/store_format.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace ff::studies::form_factors {

/// The table of keys and values of a file, in which every number has to make sense.
class StoredKeys {
  public:
    /// All are kept by reference.
    StoredKeys(const Database& database, const StoreFormat& format, const std::filesystem::path& file)
        : database_(database), format_(format), file_(file) {}

    /// @throws IoError unless `sound`
    void expect(bool sound, std::string_view what) const;

    /// @throws IoError where there is none of the key
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] double real(std::string_view key) const;
    [[nodiscard]] std::uint64_t count(std::string_view key) const;
    [[nodiscard]] bool has(std::string_view key) const { return stored_value(database_, format_, key).has_value(); }

  private:
    const Database& database_;
    const StoreFormat& format_;
    const std::filesystem::path& file_;
};

/// Scene and request of a matrix, as far as the result depends on them, in a table of keys and values.
void write_request(const Database& database, const StoreFormat& format, const SceneSource& source,
                   const Request& request);

/// What it has written: source and request.
std::pair<SceneSource, Request> read_request(const StoredKeys& keys);

}  // namespace ff::studies::form_factors
