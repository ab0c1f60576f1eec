#pragma once

#include "studies/form_factors/request.hpp"
#include "studies/form_factors/sampled_row.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/store/sqlite.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// Rows of a matrix that have been sampled, kept in a file one by one: a run that is resumed takes them from there, and
/// those of several shards together are all rows. Survives the end of the process at any moment.
class KeptRows {
  public:
    /// Makes the file, or opens one of the same scene and request.
    /// @throws UserError where it is of another matrix, or no such file; IoError
    KeptRows(const std::filesystem::path& file, const SceneSource& source, const Request& request);

    /// A row that is there already stays as it is.
    void keep(const SampledRow& row) const;
    /// Passes on every row. @throws IoError where one is damaged
    void read(const std::function<void(SampledRow)>& receive) const;
    /// Adds the rows of another file of the same matrix. @throws UserError, IoError
    void take(const std::filesystem::path& file) const;
    /// Faces whose rows are kept, in order.
    [[nodiscard]] std::vector<std::uint32_t> faces() const;

  private:
    std::filesystem::path file_;
    Database database_;
};

/// The matrix that a file of kept rows belongs to: the source of its scene, and its request. @throws UserError, IoError
std::pair<SceneSource, Request> matrix_of_kept_rows(const std::filesystem::path& file);

}  // namespace ff::studies::form_factors
