#pragma once

#include "reports/programs/hand_over.hpp"

#include <Eigen/Core>

namespace ff::reports {

// One function per format; what a format cannot express is checked before anything is computed.

void expect_few_faces(const Scene& scene, std::string_view format);

/// A row including zeros.
Eigen::VectorXd whole_row(const HandedOn& handed, Eigen::Index row);

void expect_view3d(const Scene& scene);
void write_view3d(std::ostream& out, const HandedOn& handed);

void expect_energyplus(const Scene& scene);
void write_idf(std::ostream& out, const HandedOn& handed);
void write_epjson(std::ostream& out, const HandedOn& handed);

void expect_moose(const Scene& scene);
void write_moose(std::ostream& out, const HandedOn& handed);

void write_openfoam_factors(std::ostream& out, const HandedOn& handed);
void write_openfoam_faces(std::ostream& out, const HandedOn& handed);

void write_elmer(std::ostream& out, const HandedOn& handed);

}  // namespace ff::reports
