#include "app/folders/check_files.hpp"

#include "reports/csv/gates_csv.hpp"
#include "reports/html/gates_html.hpp"
#include "reports/json/gates_json.hpp"
#include "reports/markdown/gates_markdown.hpp"

namespace ff::app {

void write_verdicts(OutputFolder& folder, const studies::gates::CheckResults& check,
                    const reports::JunitContext& context) {
    folder.write("verdicts.csv", [&](std::ostream& out) { reports::write_verdicts_csv(out, check); });
    folder.write("verdicts.json", reports::verdicts_json(check));
    folder.write("junit.xml", reports::junit_xml(check, context));
    folder.write("summary.md", reports::gates_markdown(check));
    folder.write("summary.html", reports::gates_html(check));
}

}  // namespace ff::app
