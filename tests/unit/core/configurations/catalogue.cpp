#include "core/configurations/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ff {
namespace {

/// A value as published, and half a unit of its last digit.
struct Reference {
    std::string id;
    long double factor = 0;
    long double rounding = 0;
};

/// From 20- to 30-digit evaluations of catalogue formulas, contour integrals and kernel integrals, each confirmed by a
/// second method there.
std::vector<Reference> read_references() {
    std::ifstream file(FF_TEST_DATA "/reference_configurations.csv");
    std::vector<Reference> references;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::string id;
        std::string factor;
        std::getline(cells, id, ',');
        std::getline(cells, factor, ',');
        const auto decimals = static_cast<int>(factor.size() - factor.find('.') - 1);
        references.push_back({id, std::stold(factor), std::pow(10.0L, -decimals) / 2});
    }
    return references;
}

/// Values are reported in double: the computed one is to be no farther from the published one than that rounds, beyond
/// what the publication rounded itself. The sums over corners of distant rectangles cancel: within 1e-18 of the squared
/// extent, as core/formulas/rectangle_formulas.hpp says, which is 102 of their areas for the squares ten sides apart
/// (R05).
bool as_published(long double computed, const Reference& reference) {
    const double value = static_cast<double>(computed);
    const auto rounded = static_cast<long double>(std::nextafter(value, 2.0) - value) / 2;
    const long double cancelled = reference.id == "R05" ? 102e-18L : 0;
    return std::abs(computed - reference.factor) <= reference.rounding + rounded + cancelled;
}

TEST(Configurations, HavePublishedValuesAndAgreeWithThem) {
    const auto references = read_references();
    ASSERT_EQ(references.size(), 28u);
    ASSERT_EQ(configurations().size(), references.size());
    for (const Reference& reference : references) {
        const auto all = configurations();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Configuration& c) { return c.id == reference.id; });
        ASSERT_NE(found, all.end()) << reference.id;
        EXPECT_TRUE(as_published(found->exact(), reference))
            << found->name << ": " << static_cast<double>(found->exact() - reference.factor) << " off";
    }
}

TEST(Configurations, AreCheckedToTheThirteenthDigit) {
    for (Reference reference : read_references()) {
        ASSERT_TRUE(as_published(reference.factor, reference));
        const long double right = reference.factor;
        reference.factor *= 1 + 1e-13L;  // a misprint in the 13th digit
        EXPECT_FALSE(as_published(right, reference)) << reference.id;
    }
}

TEST(Configurations, HaveUniqueNamesAndASource) {
    std::set<std::string_view> names;
    for (const Configuration& configuration : configurations()) {
        EXPECT_TRUE(names.insert(configuration.name).second) << configuration.name;
        EXPECT_TRUE(names.insert(configuration.id).second) << configuration.id;
        EXPECT_FALSE(configuration.summary.empty() || configuration.formula.empty() || configuration.reference.empty());
        EXPECT_EQ(why_no_scene(configuration.kind).empty(), configuration.kind == ConfigurationKind::surfaces);
    }
}

}  // namespace
}  // namespace ff
