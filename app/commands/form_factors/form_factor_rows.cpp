#include "app/commands/form_factors/form_factor_rows.hpp"

#include "app/process/limits.hpp"
#include "app/process/signals.hpp"

#include "core/support/error.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace ff::app {

std::optional<std::filesystem::path> rows_of(const std::filesystem::path& folder_or_file) {
    std::filesystem::path file = folder_or_file;
    if (std::filesystem::is_directory(file)) file /= rows_file;
    if (file.filename() != rows_file || !std::filesystem::is_regular_file(file)) return std::nullopt;
    return file;
}

studies::Shard rows_to_sample(const FormFactorsCommand& command, const Processes& processes) {
    const studies::Shard& part = processes.part();
    if (!command.shard) return part;
    const studies::Shard shard = studies::parse_shard(*command.shard);
    return {shard.index + shard.count * (part.index - 1), shard.count * part.count};
}

RowsInFolder::RowsInFolder(OutputFolder* out, studies::form_factors::KeptMatrix& kept, const Processes& processes)
    : out_(out), kept_(kept) {
    studies::form_factors::Request& request = kept.request;
    std::vector<bool> finished(kept.scene.faces.size(), false);
    if (out != nullptr) {
        if (std::filesystem::exists(out->path() / rows_file)) {
            for (const std::uint32_t row : opened().faces()) finished.at(row) = true;
        }
        request.earlier = [this](const auto& receive) {
            if (rows_) rows_->read(receive);
        };
        request.keep = [this](const studies::form_factors::SampledRow& row) { keep(row); };
    }
    if (processes.alone()) return;
    processes.share_finished(std::move(finished));
    request.others = [this, &processes](const auto& receive) {
        processes.receive([&](std::span<const std::uint64_t> words) {
            const auto row = studies::form_factors::sampled_row(words);
            if (!row) throw IoError("mpirun: a message was damaged. Begin again; rows that were kept are sound.");
            if (out_ != nullptr) keep(*row);
            receive(*row);
            return true;
        });
    };
}

studies::form_factors::KeptRows& RowsInFolder::opened() {
    if (rows_) return *rows_;
    const auto file = out_->path() / rows_file;
    out_->expect_own({rows_file});
    if (!std::filesystem::exists(file))
        out_->replace(rows_file,
                      [&](const auto& made) { studies::form_factors::KeptRows(made, kept_.source, kept_.request); });
    return rows_.emplace(file, kept_.source, kept_.request);
}

void RowsInFolder::keep(const studies::form_factors::SampledRow& row) {
    const std::lock_guard lock(keeping_);
    opened().keep(row);
}

void RowsInFolder::take(const std::filesystem::path& file) {
    opened().take(file);
}

void RowsInFolder::remove() {
    if (!rows_) return;
    rows_.reset();
    out_->remove(rows_file);
}

ExitCode assist_form_factors(const Processes& processes, const FormFactorsCommand& command,
                             studies::form_factors::KeptMatrix& kept) {
    if (command.dry_run) return ExitCode::passed;
    kept.request.finished = processes.share_finished({});
    kept.request.keep = [&](const studies::form_factors::SampledRow& row) {
        processes.send(studies::form_factors::to_words(row));
    };
    // An end here would also end the first process, which saves and writes the matrix.
    never_end_on_signals();
    const Limits limits(parse_duration(command.max_time), parse_size(command.max_memory));
    processes.assist([&] { kept.matrix = studies::form_factors::find_matrix(kept.scene, kept.request); });
    return ExitCode::passed;
}

}  // namespace ff::app
