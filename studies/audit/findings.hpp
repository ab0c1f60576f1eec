#pragma once

#include "studies/audit/diagnosis.hpp"
#include "studies/audit/experiment_model.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies::audit {

/// The figure that should have been printed in place of a misprint.
struct Correction {
    std::size_t figure = 0;
    std::string printed;
    std::string meant;             ///< among the prints that remain possible, the nearest to the printed one
    bool certain = false;          ///< no other print remains possible
    Range values;                  ///< values of the quantity that everything else allows
    std::optional<HitRange> hits;  ///< the same in hits
    int edits = 0;                 ///< digits to change: misprint_distance(printed, meant)
    double units = 0;  ///< distance from the printed to the nearest possible value, in units of the last digit
};

/// Finds the possible print that is typographically nearest to the printed one; among equally near ones, the nearest to
/// the middle of the range.
/// @param rays  of a figure that is hits over rays
/// @param is_consistent  whether some number in a range agrees with everything else; `values` may be wider
/// @param truth  the true value, where it is known; taken where no misprint explains the printed one
Correction correct(std::string_view printed, Range values, NumberFormat format, std::optional<std::uint64_t> rays,
                   const std::function<bool(Range)>& is_consistent, std::optional<Range> truth = {});

/// A diagnosis with the corrections that it asks for.
struct JudgedDiagnosis {
    Diagnosis diagnosis;
    std::vector<Correction> corrections;  ///< one per blamed suspect that has figures
    /// Its improbability in powers of ten: one per digit that must change, plus that of corrected Monte Carlo values
    /// and of what it leaves of deterministic ones far from the true factors.
    double improbability = 0;
};

/// All diagnoses of a model, the most plausible first.
std::vector<JudgedDiagnosis> judge_diagnoses(const ExperimentModel& model);

/// The evidence of one relation about a blamed figure.
struct Evidence {
    Relation relation = Relation::print;
    std::string text;                  ///< a sentence
    std::vector<std::size_t> figures;  ///< the figures that it rests on
};

/// An error in what is printed.
struct Finding {
    std::string id;  ///< stable: the same contradiction has the same id in every audit of the same file
    Relation relation = Relation::print;  ///< relation that the first evidence is about
    std::string statement;                ///< a sentence
    std::vector<std::size_t> blamed;      ///< figures; may be empty where a verbal statement is wrong
    std::vector<Correction> corrections;  ///< what blamed figures should say, equal corrections once
    std::vector<Evidence> evidence;
    std::vector<std::string> alternatives;  ///< other possible culprits, a sentence each
    std::vector<std::size_t> involved;      ///< all figures that blame, evidence or alternatives mention, ascending

    void cite(Relation by, std::string text, std::vector<std::size_t> figures = {}) {
        evidence.push_back({by, std::move(text), std::move(figures)});
    }
};

/// The findings of the first diagnosis; other diagnoses become alternatives. Blamed figures about the same quantity
/// make one finding.
std::vector<Finding> explain_diagnosis(const ExperimentModel& model, const std::vector<JudgedDiagnosis>& diagnoses);

/// The constraint of a suspect's figures.
const Constraint& constraint_of(const ExperimentModel& model, std::size_t suspect);

/// Rays behind a constraint that prints one sampled quantity; empty for all others.
std::optional<std::uint64_t> rays_of(const ExperimentModel& model, const Constraint& constraint);

}  // namespace ff::studies::audit
