#pragma once

#include "app/commands/form_factors/form_factor_run.hpp"
#include "app/folders/output_folder.hpp"
#include "app/process/exit_code.hpp"
#include "app/process/processes.hpp"

#include "studies/form_factors/store/kept_rows.hpp"
#include "studies/form_factors/store/store.hpp"

#include <filesystem>
#include <mutex>
#include <optional>

namespace ff::app {

/// File with the rows of an unfinished matrix; removed when the matrix is complete.
inline constexpr const char* rows_file = "rows.sqlite";

/// The file of rows that a folder holds, or the path itself where it is one.
std::optional<std::filesystem::path> rows_of(const std::filesystem::path& folder_or_file);

/// Rows that a process samples: its part of the share that --shard names. @throws UserError
studies::Shard rows_to_sample(const FormFactorsCommand& command, const Processes& processes);

/// Keeps rows in the folder of the matrix as soon as they are sampled, gives those of an earlier run back, and receives
/// those of other processes.
class RowsInFolder {
  public:
    /// Sets what the request does with rows. All arguments are kept by reference. @param out  null: rows are not kept
    /// @throws UserError where the folder holds rows of another matrix; IoError
    RowsInFolder(OutputFolder* out, studies::form_factors::KeptMatrix& kept, const Processes& processes);

    /// Adds the rows of another file.
    void take(const std::filesystem::path& file);
    /// Rows that are kept.
    [[nodiscard]] std::size_t count() const { return rows_ ? rows_->faces().size() : 0; }
    /// Makes the file even if there is nothing to keep, so that the shard can be merged.
    void leave() { opened(); }
    /// Has to be called when the matrix is complete.
    void remove();

  private:
    OutputFolder* out_;
    const studies::form_factors::KeptMatrix& kept_;
    std::optional<studies::form_factors::KeptRows> rows_;
    std::mutex keeping_;  ///< rows of other processes come on a thread of their own

    /// The file is made when there is something to keep.
    studies::form_factors::KeptRows& opened();
    void keep(const studies::form_factors::SampledRow& row);
};

/// The work of a process other than the first one: samples its rows and sends them.
ExitCode assist_form_factors(const Processes& processes, const FormFactorsCommand& command,
                             studies::form_factors::KeptMatrix& kept);

}  // namespace ff::app
