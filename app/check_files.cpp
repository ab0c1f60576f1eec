#include "app/check_files.hpp"

#include "reports/gates_csv.hpp"
#include "reports/gates_json.hpp"
#include "reports/output_file.hpp"

namespace ff::app {

void write_verdicts(const std::filesystem::path& folder, const studies::CheckResults& check,
                    const reports::JunitContext& context) {
    reports::write_file(folder / "verdicts.csv", [&](std::ostream& out) { reports::write_verdicts_csv(out, check); });
    reports::write_file(folder / "verdicts.json", reports::verdicts_json(check));
    reports::write_file(folder / "junit.xml", reports::junit_xml(check, context));
}

}  // namespace ff::app
