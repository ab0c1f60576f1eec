#include "studies/spec/spec_sampler.hpp"

#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"
#include "studies/outside/program.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace ff::studies {
namespace {

/// A name that the catalogue or an added sampler has; files of points are read, and programs have been admitted.
const samplers::SamplerInfo& find_sampler(const TomlReader& reader) {
    const std::string name = reader.text("sampler");
    const auto randomise = reader.optional_text("randomise");
    const auto folder = std::filesystem::path(reader.origin()).parent_path();
    if (names_point_file(name)) return load_point_file(name, randomise.value_or(""), folder).info;
    if (randomise) reader.fail("randomise", "(only points of a file have it: \"file:points.npy\"). Remove the key.");
    if (names_command(name)) {
        const auto* added = samplers::find_added(name);  // the full name, as it was stored
        if (added == nullptr) added = samplers::find_added(full_command_name(name, folder));
        if (added == nullptr)
            throw UserError(
                "the program has not been admitted (reading a study runs nothing). Admit it first, see "
                "studies/outside/outside_code.hpp.");
        return added->entry().info;
    }
    return samplers::find(name).info;
}

}  // namespace

const samplers::SamplerInfo* read_sampler(const TomlReader& reader, const EstimatorInfo& estimator) {
    if (!estimator.takes_points()) {
        if (reader.has("sampler"))
            reader.fail("sampler", fmt::format("({} {}). Remove the key.", estimator.name,
                                               estimator.own_points ? "makes its own points"
                                                                    : "evaluates a formula at no points"));
        return nullptr;
    }
    static_cast<void>(reader.text("sampler"));  // missing or no text: said without "is refused"
    const samplers::SamplerInfo* info = nullptr;
    try {
        info = &find_sampler(reader);
    } catch (const UserError& error) {
        reader.fail("sampler", fmt::format("is refused: {}", error.what()));
    }
    if (estimator.observes == Observes::hits && !info->equal_weights) {
        reader.fail("sampler",
                    "cannot shoot rays (its points have unequal weights and hits are counted). Use estimator = "
                    "\"area_kernel\" or \"point_to_polygon\".");
    }
    return info;
}

}  // namespace ff::studies
