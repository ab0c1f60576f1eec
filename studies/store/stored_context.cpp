#include "studies/store/stored_context.hpp"

#include "studies/store/row_digest.hpp"
#include "studies/store/store_format.hpp"

namespace ff::studies {
namespace {

std::string checksum_of_context(const Database& database) {
    Digest digest;
    add_rows(digest, database, "SELECT * FROM context WHERE key <> 'checksum' ORDER BY key");
    return in_hexadecimal(digest);
}

}  // namespace

void write_context(const Database& database, const Context& context) {
    Statement(database.handle(), "DELETE FROM context").run();
    Statement insert(database.handle(), "INSERT INTO context VALUES(?, ?)");
    for (const auto& [key, value] : context)
        insert.bind(0, std::string_view(key)).bind(1, std::string_view(value)).run();
    insert.bind(0, std::string_view("checksum")).bind(1, std::string_view(checksum_of_context(database))).run();
}

Context read_context(const Database& database) {
    Context context;
    Statement query(database.handle(), "SELECT key, value FROM context WHERE key <> 'checksum'");
    while (query.step()) context[query.text(0)] = query.text(1);
    return context;
}

void expect_sound_context(const Database& database, const std::filesystem::path& file) {
    Statement stored(database.handle(), "SELECT value FROM context WHERE key = 'checksum'");
    if (!stored.step() || stored.text(0) != checksum_of_context(database))
        report_damage(file, "the context is not as it was saved: its checksum differs");
}

}  // namespace ff::studies
