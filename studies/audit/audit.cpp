#include "studies/audit/audit.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/audit/findings.hpp"
#include "studies/audit/scene_facts.hpp"
#include "studies/audit/value_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::audit {
namespace {

/// The steps of an audit, in the order in which they build on each other.
class Auditor {
  public:
    Auditor(const PublishedTables& tables, const ExamineOptions& options, DistributionCache& cache)
        : tables_(tables), cache_(cache), facts_(scene_facts(tables)), experiments_(collect_experiments(tables)) {
        report_.source = tables.source;
        report_.figures = tables.figures.size();
        report_.alpha = options.alpha;
    }

    Report run() {
        set_levels();
        infer();
        for (const InferredFormat& format : report_.formats) {
            if (auto finding = judge_printing_rule(tables_, format)) add(std::move(*finding));
        }
        judge_references();
        judge_readings();
        for (const Experiment& experiment : experiments_) judge_experiment(experiment);
        judge_spreads();
        // Findings that blame no figure come first.
        std::ranges::stable_sort(report_.findings, {}, [](const Finding& f) {
            return f.blamed.empty() ? std::size_t{0} : f.blamed.front() + 1;
        });
        return std::move(report_);
    }

  private:
    void add(Finding finding) {
        if (finding.involved.empty()) finding.involved = finding.blamed;
        report_.findings.push_back(std::move(finding));
    }

    // How values are printed, what errors are relative to and what columns mean -----------------------------------

    auto find_format(const std::string& method) {
        return std::ranges::find(report_.formats, method, &InferredFormat::method);
    }

    /// Formats are chosen by the contradictions that they leave, which depend on references and readings; these depend
    /// on formats only slightly, so that two rounds are enough.
    void infer() {
        for (const Experiment& experiment : experiments_) {
            if (find_format(experiment.method) == report_.formats.end())
                report_.formats.push_back(infer_format(tables_, experiment.method));
        }
        bool changed = true;
        for (int round = 0; changed && round < 2; ++round) {
            std::vector<NumberFormat> formats;
            for (const Figure& figure : tables_.figures) formats.push_back(find_format(figure.method)->format);
            report_.references = infer_references(tables_, facts_, formats);
            weigh_all_readings();
            changed = false;
            for (InferredFormat& format : report_.formats) {
                const NumberFormat before = std::exchange(format.format, choose_format_of(format));
                changed = changed || before != format.format;
            }
        }
    }

    NumberFormat choose_format_of(const InferredFormat& inferred) {
        std::vector<Experiment> own = experiments_;
        std::erase_if(own, [&](const Experiment& e) { return e.method != inferred.method; });
        return choose_format({tables_, facts_, cache_, report_.references, report_.z_limit, spread_level_}, own,
                             inferred);
    }

    // What errors are relative to -------------------------------------------------------------------------------

    void judge_references() {
        for (const InferredReference& r : report_.references.references) {
            if (r.source != ReferenceSource::shortened) continue;
            Finding f;
            f.id = fmt::format("reference: {} {}", r.table, r.pair_class);
            f.relation = Relation::reference;
            f.statement = fmt::format("The relative errors of {} ({} pairs) are relative to {}, not to the stated {}.",
                                      r.table, r.pair_class, r.text, r.stated);
            f.blamed = r.unexplained_by_stated;
            f.cite(Relation::relative_error, fmt::format("{} explains {} of {} different rows, {} explains {}.", r.text,
                                                         r.explained, r.rows, r.stated, r.explained_by_stated));
            add(std::move(f));
        }
        check_reference(tables_.reference_parallel, PairClass::parallel);
        check_reference(tables_.reference_adjacent, PairClass::adjacent);
    }

    /// A stated reference must be a print of the exact value of some pair.
    void check_reference(const std::optional<std::string>& stated, PairClass kind) {
        if (!stated || tables_.figures.empty()) return;
        const PrintedNumber number = *parse_printed(*stated);
        double nearest = 0;
        for (int i = 0; i < static_cast<int>(facts_.faces()); ++i) {
            for (int j = 0; j < static_cast<int>(facts_.faces()); ++j) {
                if (i == j || pair_class(*facts_.scene, i, j) != kind) continue;
                const Range exact = facts_.factor(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
                for (const Rounding rounding : {Rounding::rounded, Rounding::truncated}) {
                    const auto range = printed_range(number, {rounding, Layout::fixed_decimals, number.decimals});
                    if (range && range->meets(exact)) return;
                }
                if (nearest == 0 || std::abs(exact.middle() - number.value()) < std::abs(nearest - number.value()))
                    nearest = exact.middle();
            }
        }
        Finding f;
        f.id = fmt::format("stated reference: {}", name(kind));
        f.relation = Relation::reference;
        f.statement = fmt::format("The stated reference {} of {} pairs is not the exact value {:.9f}.", *stated,
                                  name(kind), nearest);
        add(std::move(f));
    }

    // What columns mean -----------------------------------------------------------------------------------------

    void weigh_all_readings() {
        NumberFormat format{};
        for (const std::string& method : tables_.sampling_methods) {
            for (const InferredFormat& f : report_.formats) {
                if (f.method == method) format = f.format;
            }
        }
        report_.readings = weigh_readings(tables_, facts_, format, cache_);
        for (const ReadingEvidence& reading : report_.readings) {
            if (reading.log_odds == 0) apply_reading(reading);
        }
    }

    void judge_readings() {
        for (const ReadingEvidence& reading : report_.readings) {
            if (!reading.refuted || reading.stated_in.empty()) continue;
            Finding f;
            f.id = fmt::format("reading: {} {}", reading.table, reading.statement);
            f.relation = Relation::reading;
            f.statement = fmt::format(
                "{}: the {} and the figures contradict each other (reading \"{}\": odds 10^{:.0f} "
                "to 1 against it).",
                reading.table, reading.stated_in, reading.statement, -reading.log_odds / std::log(10.0));
            f.cite(Relation::integrality,
                   fmt::format("{} of {} figures are a whole number of hits, {:.1f} expected by chance.",
                               reading.hits.whole, reading.hits.figures, reading.hits.expected));
            for (std::size_t column = 0; column < reading.spread.size(); ++column) {
                const auto& spread = reading.spread[column];
                if (!spread) continue;
                f.cite(
                    Relation::spread,
                    fmt::format("Column {} with {} rays per face: chi-squared {:.3g} with {} degrees of freedom (p = "
                                "{:.2g} for as far, {:.2g} for as close).",
                                column + 1, reading.rays_per_face[column], spread->chi_squared.statistic,
                                spread->chi_squared.freedom, spread->too_far, spread->too_close));
            }
            add(std::move(f));
        }
    }

    void apply_reading(const ReadingEvidence& reading) {
        for (Experiment& experiment : experiments_) {
            const Figure& figure = tables_.figures[experiment.figures.front()];
            if (!experiment.rays_per_face || figure.table != reading.table) continue;
            experiment.rays_per_face = reading.rays_per_face[figure.column];
        }
    }

    // Every experiment ------------------------------------------------------------------------------------------

    void set_levels() {
        const double single = report_.alpha / 2;
        for (const Experiment& experiment : experiments_) {
            if (!experiment.rays_per_face) continue;
            report_.plausibility_tests += facts_.faces() * (facts_.faces() + 1);  // all pairs and sums, printed or not
            if (experiment.completion == Completion::direct)
                report_.plausibility_tests += facts_.faces() * (facts_.faces() - 1) / 2;  // reciprocity
        }
        const auto tests = static_cast<double>(std::max<std::size_t>(1, report_.plausibility_tests));
        report_.z_limit = stats::normal_critical(single / (2 * tests));
        const auto sampled =
            std::ranges::count_if(experiments_, [](const Experiment& e) { return e.rays_per_face.has_value(); });
        spread_level_ = report_.alpha / 2 / (2 * static_cast<double>(std::max<std::ptrdiff_t>(1, sampled)));
    }

    void judge_experiment(const Experiment& experiment) {
        const Interpretation interpretation{find_format(experiment.method)->format, report_.references.rounding,
                                            report_.references.reference};
        const ExperimentModel model = build_model(tables_, facts_, experiment, interpretation, cache_, report_.z_limit);
        const auto diagnoses = judge_diagnoses(model);
        for (Finding& finding : explain_diagnosis(model, diagnoses)) {
            add_hints(finding, interpretation);
            add(std::move(finding));
        }
        if (experiment.rays_per_face) recover_hits(model, diagnoses.front().diagnosis.ranges);
    }

    /// The possible cause of an error, where the figures show it.
    void add_hints(Finding& finding, const Interpretation& interpretation) const {
        for (const Correction& correction : finding.corrections) {
            const Figure& figure = tables_.figures[correction.figure];
            if (!is_value(figure)) {
                NumberFormat other = format_of(figure, interpretation);
                other.rounding = other.rounding == Rounding::rounded ? Rounding::truncated : Rounding::rounded;
                const auto range = printed_range(figure.printed, other);
                if (range && range->meets(correction.values))
                    finding.cite(Relation::printing_rule,
                                 fmt::format("{} would be right if it were {}.", figure.printed, describe(other)));
                continue;
            }
            for (std::size_t f = 0; f < tables_.figures.size(); ++f) {
                const Figure& twin = tables_.figures[f];
                if (f == correction.figure || twin.method != figure.method || twin.printed != figure.printed) continue;
                if (twin.kind != figure.kind || correction.edits < 2) continue;
                finding.cite(Relation::print,
                             fmt::format("The same digits stand in {}: perhaps copied.", describe(tables_, f)));
            }
        }
    }

    void recover_hits(const ExperimentModel& model, const std::vector<Range>& ranges) {
        for (const FigureLink& link : model.links) {
            if (!is_value(tables_.figures[link.figure])) continue;
            const Variable& variable = model.system.variables[link.quantity->variable];
            RecoveredHits hits{.figure = link.figure, .rays = *model.experiment.rays_per_face};
            if (variable.rays && link.quantity->factor == 1)
                hits.printed = possible_hits(model.system.constraints[link.constraint].values, *variable.rays);
            if (variable.rays) hits.consistent = possible_hits(ranges[link.quantity->variable], *variable.rays);
            report_.hits.push_back(hits);
        }
        if (const auto spread = spread_within(model, ranges))
            report_.spreads.push_back({describe(model.experiment), *spread});
    }

    void judge_spreads() {
        for (const ExperimentSpread& s : report_.spreads) {
            if (!s.spread.is_implausible(spread_level_)) continue;
            const bool far = s.spread.too_far < spread_level_;
            Finding f;
            f.id = fmt::format("spread: {}", s.experiment);
            f.relation = Relation::spread;
            f.statement = fmt::format(
                "{}: the values lie together too {} the exact ones for chance, whatever digits are not printed "
                "(chi-squared {:.3g} with {} degrees of freedom, p = {:.2g}).",
                s.experiment, far ? "far from" : "close to", s.spread.chi_squared.statistic,
                s.spread.chi_squared.freedom, far ? s.spread.too_far : s.spread.too_close);
            f.involved = s.spread.figures;
            add(std::move(f));
        }
    }

    const PublishedTables& tables_;
    DistributionCache& cache_;
    SceneFacts facts_;
    std::vector<Experiment> experiments_;
    Report report_;
    double spread_level_ = 0;  ///< level of the chi-squared test of one experiment, on either side
};

}  // namespace

Report examine(const PublishedTables& tables, const ExamineOptions& options, DistributionCache& cache) {
    return Auditor(tables, options, cache).run();
}

Report examine(const PublishedTables& tables, const ExamineOptions& options) {
    DistributionCache cache;
    return examine(tables, options, cache);
}

}  // namespace ff::studies::audit
