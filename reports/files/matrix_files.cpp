#include "reports/files/matrix_files.hpp"

#include "core/exact/exact_rooms.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/radiosity/system.hpp"
#include "core/support/error.hpp"
#include "reports/text/labels.hpp"
#include "studies/radiosity/lighting.hpp"
#include "studies/radiosity/treatment.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <sstream>

namespace ff::reports {
namespace {

/// Most patches of a scene that a matrix is written for: as text it has 100 MB then.
constexpr std::uint32_t most_patches = 2000;

using Files = std::map<std::string, std::string>;

void add(Files& files, const std::string& path, const Eigen::MatrixXd& matrix, const std::string& comment) {
    files[path + ".mtx"] = matrix_market(matrix, comment);
    files[path + ".npy"] = npy(matrix);
}

void add_system(Files& files, const std::string& folder, const std::string& label, const studies::StudyPlan& plan,
                std::size_t scene, const Eigen::MatrixXd& factors) {
    add(files, folder + "form_factors", factors, fmt::format("form factors, {}", label));
    if (!plan.spec.radiosity) return;
    const studies::radiosity::Lighting lighting = studies::radiosity::light_faces(plan, scene);
    for (std::size_t setting = 0; setting < plan.spec.radiosity->reflectance.size(); ++setting) {
        const RadiositySystem system = lighting.system(setting, factors);
        const std::string words = studies::in_words(plan.spec.radiosity->reflectance[setting]);
        add(files, fmt::format("{}system_{}", folder, setting), coefficient_matrix(system),
            fmt::format("I - P F at reflectance {}, {}", words, label));
        if (setting == 0) add(files, folder + "emission", system.emission, fmt::format("emitted exitance, {}", label));
    }
}

/// Factors between patches, and what turns them into a system. The matrix I - diag(reflectance) F itself is as large as
/// F.
void add_patches(Files& files, const std::string& folder, const std::string& label, const studies::StudyPlan& plan,
                 std::size_t index, std::uint64_t trial) {
    const studies::Cell& cell = plan.cells[index];
    add(files, folder + "patch_form_factors", studies::radiosity::trace_patch_factors(plan, index, trial),
        fmt::format("between patches, direct, {}", label));
    add(files, folder + "patch_areas", patch_areas(plan.scenes[cell.scene], cell.subdivision),
        fmt::format("areas of the patches, {}", label));
    if (!plan.spec.radiosity) return;
    const studies::radiosity::PatchLight light = studies::radiosity::patch_light(plan, cell.scene, cell.subdivision);
    add(files, folder + "patch_emission", light.emission, fmt::format("emitted exitance of the patches, {}", label));
    for (std::size_t setting = 0; setting < light.reflectance.size(); ++setting) {
        add(files, fmt::format("{}patch_reflectance_{}", folder, setting), light.reflectance[setting],
            fmt::format("reflectance of the patches, {}", label));
    }
}

}  // namespace

void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix, const std::string& comment) {
    out << "%%MatrixMarket matrix array real general\n";
    if (!comment.empty()) out << fmt::format("% {}\n", comment);
    out << fmt::format("{} {}\n", matrix.rows(), matrix.cols());
    for (const double value : matrix.reshaped()) out << fmt::format("{}\n", value);
}

std::string matrix_market(const Eigen::MatrixXd& matrix, const std::string& comment) {
    std::ostringstream out;
    write_matrix_market(out, matrix, comment);
    return out.str();
}

void write_sparse_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& matrix,
                                const std::string& comment) {
    const Eigen::Index entries = (matrix.coeffs() != 0).count();
    if (4 * entries > matrix.size()) {
        write_matrix_market(out, matrix, comment);
        return;
    }
    out << "%%MatrixMarket matrix coordinate real general\n";
    if (!comment.empty()) out << fmt::format("% {}\n", comment);
    out << fmt::format("{} {} {}\n", matrix.rows(), matrix.cols(), entries);
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
            if (entry.value() != 0) out << fmt::format("{} {} {}\n", entry.row() + 1, j + 1, entry.value());
        }
    }
}

std::string npy_header(std::string_view type, std::string_view fortran_order, std::string_view shape) {
    constexpr std::size_t before = 10;  // magic, version, length of the header
    constexpr std::size_t alignment = 64;
    std::string header =
        fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}", type, fortran_order, shape);
    header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
    header += '\n';
    const std::array length{static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
    return std::string("\x93NUMPY\x01\x00", 8).append(length.data(), length.size()) + header;
}

void write_npy(std::ostream& out, const Eigen::MatrixXd& matrix) {
    static_assert(std::endian::native == std::endian::little);
    const std::string shape = matrix.cols() == 1 ? fmt::format("({},)", matrix.rows())
                                                 : fmt::format("({}, {})", matrix.rows(), matrix.cols());
    out << npy_header("<f8", "True", shape);
    for (const double value : matrix.reshaped()) {
        const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(value);
        out.write(bytes.data(), bytes.size());
    }
}

std::string npy(const Eigen::MatrixXd& matrix) {
    std::ostringstream out;
    write_npy(out, matrix);
    return out.str();
}

void patch_systems(const studies::Store& store, const TakeMatrix& take) {
    const studies::StudyPlan& plan = store.plan();
    bool found = false;
    for (std::size_t index = 0; plan.spec.radiosity && index < plan.cells.size(); ++index) {
        if (!studies::tells_patches_apart(plan, index)) continue;
        const auto trials = store.saved_trial_numbers(index);
        if (trials.empty()) continue;
        studies::expect_few_patches(plan, index);
        found = true;
        const studies::Cell& cell = plan.cells[index];
        const std::string folder = fmt::format("cell_{}/", index);
        const std::string label =
            fmt::format("{}: {}, trial {}", plan.scenes[cell.scene].name, cell_label(plan, cell), trials.front());
        const Eigen::MatrixXd matrix = studies::radiosity::trace_patch_factors(plan, index, trials.front());
        take(folder + "patch_form_factors", matrix, fmt::format("between patches, direct, {}", label));
        const studies::radiosity::PatchLight light =
            studies::radiosity::patch_light(plan, cell.scene, cell.subdivision);
        for (std::size_t setting = 0; setting < light.reflectance.size(); ++setting) {
            const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()) -
                                           light.reflectance[setting].asDiagonal() * matrix;
            take(fmt::format("{}patch_system_{}", folder, setting), system,
                 fmt::format("I - P F between patches at reflectance {}, {}",
                             studies::in_words(plan.spec.radiosity->reflectance[setting]), label));
        }
    }
    if (!found) {
        throw UserError(
            "--format patch_systems: no system between patches (it takes [radiosity], and ray_shooting or area_kernel "
            "with several patches per face). Take --format matrices for those between faces.");
    }
}

std::map<std::string, std::string> matrix_files(const studies::Store& store) {
    const studies::StudyPlan& plan = store.plan();
    Files files;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const auto exact = exact_room_factors(plan.scenes[scene]);
        if (exact) add_system(files, fmt::format("exact_{}/", scene), plan.scenes[scene].name, plan, scene, *exact);
    }
    for (std::size_t index = 0; index < plan.cells.size(); ++index) {
        const studies::Cell& cell = plan.cells[index];
        const auto trials = studies::radiosity::load_matrices(store, index);
        if (trials.direct.empty()) continue;
        const auto treatment = studies::radiosity::treatment_of(plan.spec.methods[cell.method].completion);
        const std::string folder = fmt::format("cell_{}/", index);
        const std::string label = fmt::format("{}: {}, trial {}", plan.scenes[cell.scene].name, cell_label(plan, cell),
                                              trials.numbers.front());
        studies::radiosity::Elements faces;
        faces.areas = face_areas(plan.scenes[cell.scene]);
        faces.sight = studies::radiosity::face_sight(plan.scenes[cell.scene]);
        add(files, folder + "areas", faces.areas, fmt::format("areas of the faces, {}", label));
        add_system(files, folder, label, plan, cell.scene,
                   studies::radiosity::treat(faces, trials.rays, trials.direct.front(), treatment));
        if (radiating_patches(plan.scenes[cell.scene], cell.subdivision) <= most_patches &&
            studies::tells_patches_apart(plan, index))
            add_patches(files, folder, label, plan, index, trials.numbers.front());
    }
    return files;
}

}  // namespace ff::reports
