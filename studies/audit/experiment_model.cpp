#include "studies/audit/experiment_model.hpp"

#include "studies/audit/references.hpp"
#include "studies/audit/scene_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace ff::studies::audit {
namespace {

constexpr double consequence = 0.05;

/// Fills the model step by step.
class ModelBuilder {
  public:
    ModelBuilder(const PublishedTables& tables, const SceneFacts& facts, const Experiment& experiment,
                 const Interpretation& interpretation, DistributionCache& cache, double z_limit)
        : model_{tables, facts, experiment, interpretation}, z_limit_(z_limit), faces_(facts.faces()) {
        for (const std::size_t f : experiment.figures) {
            const Figure& figure = tables.figures[f];
            if (figure.kind == FigureKind::form_factor) values_of_pair_[{figure.from, figure.to}].push_back(f);
        }
        if (sampled()) {
            model_.distribution =
                cache.at(facts, experiment.patches_per_face, *experiment.rays_per_face, experiment.completion);
        }
    }

    ExperimentModel build() {
        add_sums();
        const bool pairs =
            std::ranges::any_of(experiment_.figures, [&](std::size_t f) { return !tables_.figures[f].to.empty(); });
        if (pairs) {
            add_pairs();
            add_row_sums();
        }
        if (sampled()) {
            add_closure();
            add_parity();
        }
        if (pairs) add_reciprocity(printed_variables(), z_limit_, model_);
        for (const std::size_t figure : experiment_.figures) add_figure(figure);
        return std::move(model_);
    }

  private:
    [[nodiscard]] bool sampled() const { return experiment_.rays_per_face.has_value(); }
    [[nodiscard]] bool reciprocal() const { return experiment_.completion == Completion::reciprocal; }
    [[nodiscard]] double area(std::size_t face) const { return facts_.areas[face]; }
    /// Whether an entry is a multiple of the one that it follows from.
    [[nodiscard]] bool follows(std::size_t from, std::size_t to) const { return reciprocal() && from > to; }
    /// Whether hits of other faces count as hits of this one when they are completed.
    [[nodiscard]] bool equal_areas() const {
        if (!facts_.has_certain_areas) return false;
        for (std::size_t i = 1; i < faces_; ++i) {
            if (std::abs(area(i) / area(0) - 1) > 1e-12) return false;
        }
        return true;
    }

    std::size_t add_variable(Range range, bool lattice) {
        Variable variable{range, std::nullopt};
        if (lattice && sampled()) variable.rays = experiment_.rays_per_face;
        model_.system.variables.push_back(variable);
        return model_.system.variables.size() - 1;
    }
    std::size_t add_constraint(Constraint constraint) {
        model_.system.constraints.push_back(std::move(constraint));
        return model_.system.constraints.size() - 1;
    }
    [[nodiscard]] double one_hit() const { return 1 / static_cast<double>(*experiment_.rays_per_face); }

    void add_plausible_range(std::size_t variable, Range mean, double sigma, double hit) {
        if (sigma <= 0) return;
        const double by = reach_of_chance(sigma, hit, z_limit_);
        add_constraint({.relation = Relation::plausibility,
                        .terms = {{variable, 1}},
                        .values = {mean.low - by, mean.high + by},
                        .suspect = std::nullopt});
    }

    void add_sums() {
        const bool lattice = !reciprocal() || equal_areas();
        std::map<std::size_t, std::size_t> of_class;
        for (std::size_t i = 0; i < faces_; ++i) {
            // A deterministic method treats faces alike that look alike; a random one does not.
            const auto known = sampled() ? of_class.end() : of_class.find(facts_.face_congruence[i]);
            if (known != of_class.end()) {
                model_.sums.push_back(known->second);
                continue;
            }
            const std::size_t variable = add_variable({0, static_cast<double>(faces_)}, lattice);
            of_class[facts_.face_congruence[i]] = variable;
            model_.sums.push_back(variable);
            if (model_.distribution) {
                const int face = static_cast<int>(i);
                const double mean = model_.distribution->mean.row(face).sum();
                const double largest = *std::ranges::max_element(facts_.areas);
                add_plausible_range(variable, {mean, mean}, model_.distribution->sum_sigma(face),
                                    one_hit() * largest / area(i));
            }
        }
    }

    void add_pairs() {
        std::map<std::size_t, std::size_t> of_class;
        for (std::size_t i = 0; i < faces_; ++i) {
            for (std::size_t j = 0; j < faces_; ++j) {
                if (!facts_.can_see(i, j)) continue;
                const std::size_t pair = i * faces_ + j;
                if (follows(i, j) && facts_.has_certain_areas) {
                    const Term& other = model_.pairs.at(j * faces_ + i);
                    model_.pairs[pair] = {other.variable, other.factor * area(j) / area(i)};
                    continue;
                }
                const auto known = sampled() ? of_class.end() : of_class.find(facts_.pair_congruence[pair]);
                if (known != of_class.end()) {
                    model_.pairs[pair] = {known->second, 1};
                    continue;
                }
                const std::size_t variable = add_variable({0, 2}, !follows(i, j));
                of_class[facts_.pair_congruence[pair]] = variable;
                model_.pairs[pair] = {variable, 1};
                if (!sampled() || follows(i, j)) continue;
                const double sigma = most_sigma(facts_, model_.distribution, *experiment_.rays_per_face, i, j);
                add_plausible_range(variable, facts_.factor(i, j), sigma, one_hit());
            }
        }
    }

    /// Adds a term, merging terms of the same variable.
    static void add_term(std::vector<Term>& terms, Term term) {
        for (Term& other : terms) {
            if (other.variable != term.variable) continue;
            other.factor += term.factor;
            return;
        }
        terms.push_back(term);
    }

    void add_row_sums() {
        std::vector<bool> done(model_.system.variables.size(), false);
        for (std::size_t i = 0; i < faces_; ++i) {
            if (done[model_.sums[i]]) continue;
            done[model_.sums[i]] = true;
            Constraint constraint{.relation = Relation::row_sum, .terms = {{model_.sums[i], -1}}, .suspect = {}};
            for (std::size_t j = 0; j < faces_; ++j) {
                if (facts_.can_see(i, j)) add_term(constraint.terms, model_.pairs.at(i * faces_ + j));
            }
            add_constraint(std::move(constraint));
        }
    }

    /// A face whose row consists of its own rays sums to 1 in a closed scene, unless rays are lost.
    void add_closure() {
        if (!facts_.closed) return;
        model_.system.suspects.push_back({.figures = {},
                                          .assumption = fmt::format("no ray is lost ({})", describe(experiment_)),
                                          .cost = 1.2,
                                          .weight = 2});
        const std::size_t suspect = model_.system.suspects.size() - 1;
        for (std::size_t i = 0; i < (reciprocal() ? 1 : faces_); ++i) {
            add_constraint(
                {.relation = Relation::closure, .terms = {{model_.sums[i], 1}}, .values = {1, 1}, .suspect = suspect});
        }
    }

    /// Every pair of faces counts in two row sums.
    void add_parity() {
        if (!reciprocal() || !equal_areas()) return;
        for (std::size_t i = 0; i < faces_; ++i) {
            if (facts_.can_see(i, i)) return;
        }
        Constraint constraint{.kind = ConstraintKind::even, .relation = Relation::parity, .suspect = {}};
        for (const std::size_t sum : model_.sums) constraint.terms.push_back({sum, 1});
        add_constraint(std::move(constraint));
    }

    Constraint constraint_of(const Figure& figure) const {
        Constraint constraint;
        const auto range = printed_range(figure.printed, format_of(figure, model_.interpretation));
        constraint.values = range.value_or(Range{1, 0});
        constraint.relation = range ? Relation::print : Relation::printing;
        switch (figure.kind) {
            case FigureKind::form_factor:
                constraint.terms = {pair(figure)};
                if (range) constraint.values = without_ties(*range);
                break;
            case FigureKind::row_sum:
                constraint.terms = {{model_.sums[*facts_.face(figure.from)], 1}};
                if (range) constraint.values = without_ties(*range);
                break;
            case FigureKind::relative_error:
                constraint.kind = ConstraintKind::deviation;
                constraint.relation = Relation::relative_error;
                constraint.terms = {{pair(figure).variable, 1}};
                break;
            case FigureKind::sum_relative_error:
                constraint.kind = ConstraintKind::deviation;
                constraint.relation = Relation::sum_of_relative_errors;
                for (const std::size_t sum : model_.sums) add_term(constraint.terms, {sum, 1});
                break;
        }
        return constraint;
    }

    /// Errors may have been computed from the value as printed, and from either of two references; where the true one
    /// is not known exactly, nothing tells how they were rounded.
    [[nodiscard]] Range widened(Range percent, const Reference& reference) const {
        const double half_unit = 0.5 * printed_unit(reference.value, model_.interpretation.values);
        const double either = facts_.exact ? 0 : 0.5 * (percent.high - percent.low);
        const double slack = either + 100 * (half_unit + reference.uncertainty) / reference.value;
        return {percent.low - slack, percent.high + slack};
    }

    /// The numbers of a deterministic method never lie exactly between two prints, as fractions of rays and of areas
    /// do.
    [[nodiscard]] Range without_ties(Range range) const {
        if (sampled()) return range;
        const double margin = 1e-5 * printed_unit(range.middle(), model_.interpretation.values);
        return {range.low + margin, range.high - margin};
    }

    [[nodiscard]] Term pair(const Figure& figure) const {
        return model_.pairs.at(*facts_.face(figure.from) * faces_ + *facts_.face(figure.to));
    }

    /// The smallest range, for each variable of a pair, that contains everything its prints allow.
    [[nodiscard]] std::map<std::size_t, Range> printed_variables() const {
        std::map<std::size_t, Range> printed;
        for (const std::size_t f : experiment_.figures) {
            const Figure& figure = tables_.figures[f];
            if (figure.kind != FigureKind::form_factor) continue;
            const Constraint constraint = constraint_of(figure);
            const Term& term = constraint.terms.front();
            const Range range{constraint.values.low / term.factor, constraint.values.high / term.factor};
            const auto [known, fresh] = printed.try_emplace(term.variable, range);
            if (!fresh)
                known->second = {std::min(known->second.low, range.low), std::max(known->second.high, range.high)};
        }
        return printed;
    }

    void add_figure(std::size_t index) {
        const Figure& figure = tables_.figures[index];
        FigureLink link{.figure = index, .quantity = std::nullopt};
        Constraint constraint = constraint_of(figure);
        if (figure.kind != FigureKind::sum_relative_error) link.quantity = constraint.terms.front();
        if (figure.kind == FigureKind::relative_error) {
            if (!model_.interpretation.reference[index]) return;
            const Reference& reference = *model_.interpretation.reference[index];
            constraint.reference = reference.value / pair(figure).factor;
            constraint.values = widened(constraint.values, reference);
        }
        const Print print = print_of(figure, constraint);
        if (const auto same = constraint_of_print_.find(print); same != constraint_of_print_.end()) {
            const Constraint& known = model_.system.constraints[same->second];
            Suspect& suspect = model_.system.suspects[*known.suspect];
            suspect.figures.push_back(index);
            suspect.cost += 0.01;  // between equally many causes, the one behind fewer figures
            link.constraint = same->second;
        } else {
            constraint.suspect = model_.system.suspects.size();
            Suspect suspect{.figures = {index}, .assumption = {}};
            if (figure.kind == FigureKind::relative_error &&
                follows_from_print(figure, constraint.values, model_.interpretation.reference[index]->value)) {
                suspect.cost = suspect.weight = consequence;
            }
            model_.system.suspects.push_back(std::move(suspect));
            link.constraint = add_constraint(std::move(constraint));
            constraint_of_print_.emplace(print, link.constraint);
        }
        model_.links.push_back(link);
    }

    /// An error that fits its value as printed is wrong only as a consequence: it was computed from that value.
    [[nodiscard]] bool follows_from_print(const Figure& error, Range percent, double reference) const {
        const auto values = values_of_pair_.find({error.from, error.to});
        if (values == values_of_pair_.end()) return false;
        return std::ranges::any_of(values->second, [&](std::size_t f) {
            const auto range = printed_range(tables_.figures[f].printed, model_.interpretation.values);
            return range && error_fits(*range, percent, reference);
        });
    }

    /// The key that figures share if they print the same quantity with the same digits.
    using Print = std::tuple<FigureKind, std::string, double, std::size_t, double>;
    [[nodiscard]] static Print print_of(const Figure& figure, const Constraint& constraint) {
        const Term& term = constraint.terms.front();
        return {figure.kind, figure.printed, constraint.reference, term.variable, term.factor};
    }

    ExperimentModel model_;
    const PublishedTables& tables_ = model_.tables;
    const SceneFacts& facts_ = model_.facts;
    const Experiment& experiment_ = model_.experiment;
    double z_limit_;
    std::size_t faces_;
    std::map<Print, std::size_t> constraint_of_print_;
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> values_of_pair_;  ///< figures
};

}  // namespace

std::vector<std::size_t> prints_of(const ExperimentModel& model, const std::vector<Term>& terms) {
    std::vector<std::size_t> figures;
    for (const FigureLink& link : model.links) {
        if (!is_value(model.tables.figures[link.figure])) continue;
        const bool part =
            std::ranges::any_of(terms, [&](const Term& term) { return term.variable == link.quantity->variable; });
        if (part) figures.push_back(link.figure);
    }
    return figures;
}

std::optional<JointDistance> spread_within(const ExperimentModel& model, const std::vector<Range>& ranges) {
    if (!model.distribution) return std::nullopt;
    std::vector<SampledValue> values;
    for (const FigureLink& link : model.links) {
        if (!is_value(model.tables.figures[link.figure])) continue;
        const Range range = ranges[link.quantity->variable];
        values.push_back({link.figure, {link.quantity->factor * range.low, link.quantity->factor * range.high}});
    }
    return weigh_spread(model.tables, model.facts, *model.distribution, *model.experiment.rays_per_face, values);
}

ExperimentModel build_model(const PublishedTables& tables, const SceneFacts& facts, const Experiment& experiment,
                            const Interpretation& interpretation, DistributionCache& cache, double z_limit) {
    return ModelBuilder(tables, facts, experiment, interpretation, cache, z_limit).build();
}

}  // namespace ff::studies::audit
