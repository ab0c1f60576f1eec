#include "core/estimators/added.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "samplers/outside/outside_points.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/readers/csv_reader.hpp"
#include "studies/scene_files/scene_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

struct SceneFormat {
    std::string_view placeholder;
    std::string_view file;
    std::string (*text)(const Scene& scene);
    bool polygons_only;
};
constexpr std::array<SceneFormat, 3> formats{{{"{obj}", "scene.obj", &obj_text, true},
                                              {"{vs3}", "scene.vs3", &vs3_text, true},
                                              {"{toml}", "scene.toml", &toml_scene_text, false}}};
constexpr std::string_view any_format = "{scene}";

/// A scene in the files that a program needs, which exist while it runs.
class SceneFiles {
  public:
    SceneFiles(const Scene& scene, const Program& program) {
        std::string name = (std::filesystem::temp_directory_path() / "ffstudy-scene-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw IoError("{} (a folder for the scene cannot be made there). Set TMPDIR.", name);
        folder_ = name;
        const std::size_t fitting = is_of_polygons(scene) ? 0 : 2;
        for (std::size_t i = 0; i < formats.size(); ++i) {
            const SceneFormat& format = formats[i];
            const bool chosen = i == fitting && program.has(any_format);
            if (!chosen && !program.has(format.placeholder)) continue;
            const auto file = folder_ / format.file;
            std::ofstream out(file, std::ios::binary);
            out << format.text(scene);
            out.close();
            if (!out) throw IoError("{}: cannot be written. Set TMPDIR.", file.string());
            values_.emplace_back(format.placeholder, file.string());
            if (chosen) values_.emplace_back(any_format, file.string());
        }
    }
    SceneFiles(const SceneFiles&) = delete;
    SceneFiles& operator=(const SceneFiles&) = delete;
    ~SceneFiles() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    [[nodiscard]] const Program::Values& values() const { return values_; }

  private:
    std::filesystem::path folder_;
    Program::Values values_;
};

/// Reads what a program prints, with messages that name the run.
class RowReader {
  public:
    RowReader(const Scene& scene, std::string_view output, std::string_view place)
        : scene_(scene), reader_(output, place), place_(place) {
        for (const std::string& face : scene.faces) index_.emplace(face, static_cast<Eigen::Index>(index_.size()));
    }

    OutsideFactors read() {
        const std::size_t columns = read_header();
        const auto faces = static_cast<Eigen::Index>(scene_.faces.size());
        OutsideFactors printed;
        Eigen::MatrixXd& estimates = printed.estimates;
        estimates = Eigen::MatrixXd::Constant(faces, faces, std::numeric_limits<double>::quiet_NaN());
        if (columns == names.size()) printed.errors = Eigen::MatrixXd::Zero(faces, faces);
        std::vector<CsvField> record;
        while (reader_.next(record)) {
            if (record.size() != columns)
                reader_.fail(record.front(),
                             fmt::format("{} cells, not {}. Print a number in each column.", record.size(), columns));
            const Eigen::Index from = face_of(record[0]);
            const Eigen::Index to = face_of(record[1]);
            if (!std::isnan(estimates(from, to)))
                reader_.fail(record.front(), "this pair stands here again. Print it once.");
            estimates(from, to) = number(record, 2);
            if (columns < names.size()) continue;
            printed.errors(from, to) = number(record, 3);
            if (printed.errors(from, to) < 0)
                reader_.fail(record[3],
                             fmt::format("error = '{}' (it cannot be negative). Print its size.", record[3].text));
        }
        for (Eigen::Index i = 0; i < faces; ++i) {
            if (std::isnan(estimates(i, i))) estimates(i, i) = 0;  // what is flat does not see itself
            for (Eigen::Index j = 0; j < faces; ++j) {
                if (std::isnan(estimates(i, j)))
                    throw UserError("{}: no line from face '{}' to '{}'. Print one, 0 where nothing arrives.", place_,
                                    scene_.faces[static_cast<std::size_t>(i)],
                                    scene_.faces[static_cast<std::size_t>(j)]);
            }
        }
        return printed;
    }

  private:
    static constexpr std::array<std::string_view, 4> names{"from", "to", "estimate", "error"};

    /// How many columns there are: the last may be left out.
    std::size_t read_header() {
        std::vector<CsvField> record;
        const bool is_there =
            reader_.next(record) && record.size() + 1 >= names.size() && record.size() <= names.size() &&
            std::equal(record.begin(), record.end(), names.begin(),
                       [](const CsvField& field, std::string_view name) { return field.text == name; });
        if (!is_there)
            throw UserError(
                "{}: does not begin with the line from,to,estimate or from,to,estimate,error. Print it, and "
                "below it a line for each two faces.",
                place_);
        return record.size();
    }

    double number(const std::vector<CsvField>& record, std::size_t column) const {
        const auto value = finite_number(record[column].text);
        constexpr double largest = 1e75;
        if (!value || std::abs(*value) > largest)
            reader_.fail(record[column],
                         fmt::format("{} = '{}' (not a number of at most 1e75 in size). Print it like 0.19982.",
                                     names.at(column), record[column].text));
        return *value;
    }

    Eigen::Index face_of(const CsvField& field) const {
        const auto found = index_.find(field.text);
        if (found == index_.end())
            reader_.fail(field, fmt::format("'{}' is not a face of the scene. They are {}.", field.text,
                                            fmt::join(scene_.faces, ", ")));
        return found->second;
    }

    const Scene& scene_;
    CsvReader reader_;
    std::string_view place_;
    std::unordered_map<std::string, Eigen::Index> index_;
};

class CommandEstimator final : public Estimator {
  public:
    CommandEstimator(std::shared_ptr<Program> program, const Scene& scene)
        : program_(std::move(program)), scene_(&scene), files_(scene, *program_) {}

    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const override {
        const auto factors_of = [&](std::uint32_t trial) {
            const auto request = samplers::request_of({task.key, trial, 0, 0}, task.samples, 0);
            return run({request.seed, request.trial}, task.samples);
        };
        program_->expect_repeatable("estimates", factors_of, std::mem_fn(&OutsideFactors::is_telling));
        OutsideFactors printed = factors_of(task.trial);
        outcome = {};
        outcome.estimates = std::move(printed.estimates);
        outcome.claims = std::move(printed.errors);
    }

  private:
    [[nodiscard]] OutsideFactors run(Program::Seed seed, std::uint64_t samples) const {
        const std::string place = fmt::format("{} (scene '{}', {} samples, trial {}, seed {})", program_->title(),
                                              scene_->name, samples, seed.trial, seed.seed);
        Program::Values values = files_.values();
        values.emplace_back("{samples}", std::to_string(samples));
        constexpr std::uint64_t bytes_of_a_line = 4096;
        const std::uint64_t most = 65536 + scene_->faces.size() * scene_->faces.size() * bytes_of_a_line;
        const std::string output = program_->run(place, seed, std::move(values), most);
        return RowReader(*scene_, output, place).read();
    }

    std::shared_ptr<Program> program_;
    const Scene* scene_;
    SceneFiles files_;
};

/// Why a scene cannot be given to a program that needs polygons.
std::string refuse_shapes(const Program& program, const Scene& scene) {
    for (const SceneFormat& format : formats) {
        if (format.polygons_only && program.has(format.placeholder) && !is_of_polygons(scene))
            return fmt::format(
                "the program cannot be used in scene '{}' (not all of it is polygons on faces whose "
                "names are single words, as {} has them). Use {{toml}}, or another scene.",
                scene.name, format.placeholder);
    }
    return {};
}

}  // namespace

const EstimatorEntry& load_command_estimator(std::string_view name, const std::filesystem::path& folder,
                                             double deadline) {
    auto program = std::make_shared<Program>(name, folder, deadline);
    const auto gets = [&](std::string_view placeholder) { return program->has(placeholder); };
    if (!gets(any_format) &&
        std::none_of(formats.begin(), formats.end(), [&](const auto& format) { return gets(format.placeholder); }))
        throw UserError(
            "{} (it does not get the scene). Add {{scene}}, {{obj}}, {{vs3}} or {{toml}}: the "
            "file's name stands there.",
            program->title());
    program->expect_placeholders_among(
        {any_format, formats[0].placeholder, formats[1].placeholder, formats[2].placeholder, "{samples}"});
    return add(std::make_unique<AddedEstimator>(
        AddedEstimator::Texts{program->full_name(), "form factors that a program prints",
                              "The program is run for each trial, and a few times at first to see that it prints the "
                              "same for the same seed. A run measures the processor time per trial."},
        program_traits(program->has("{samples}"), program->is_randomised()),
        [program](const Scene& scene) { return refuse_shapes(*program, scene); },
        [program](const Scene& scene) { return std::make_unique<CommandEstimator>(program, scene); }));
}

}  // namespace ff::studies
