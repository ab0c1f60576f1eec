#include "studies/store/sqlite.hpp"

#include "core/support/error.hpp"

#include <sqlite3.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace ff::studies {
namespace {

/// Bytes of an absolute path that leave room for the log's name beside it.
constexpr std::size_t longest_name = 500;

/// How long to wait for another program that has the file open.
constexpr int patience_ms = 10'000;

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

[[noreturn]] void fail(sqlite3* database) {
    const char* name = sqlite3_db_filename(database, "main");
    const std::string file = name == nullptr ? "result store" : name;
    if (sqlite3_errcode(database) == SQLITE_NOTADB) {
        throw UserError("{}: not a result store (no SQLite file). Give one written by ffstudy.", file);
    }
    const int error = sqlite3_errcode(database);
    throw IoError("{}: {} (SQLite error {}). {}", file, sqlite3_errmsg(database), sqlite3_extended_errcode(database),
                  error == SQLITE_BUSY || error == SQLITE_LOCKED
                      ? "Close the other program that has it open, and run the same command again."
                      : "Check the disk, the permissions and the file.");
}

/// Undoes a change that a killed program left half-written, which a connection that only reads cannot do.
/// Where that fails, reading fails too, and says why.
void undo_interrupted_change(sqlite3* reader, const std::string& name) {
    constexpr const char* read_something = "PRAGMA schema_version";
    if (sqlite3_exec(reader, read_something, nullptr, nullptr, nullptr) == SQLITE_OK ||
        sqlite3_extended_errcode(reader) != SQLITE_READONLY_ROLLBACK)
        return;
    sqlite3* writer = nullptr;
    if (sqlite3_open_v2(name.c_str(), &writer, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK) {
        sqlite3_busy_timeout(writer, patience_ms);
        sqlite3_exec(writer, read_something, nullptr, nullptr, nullptr);
    }
    sqlite3_close_v2(writer);
}

/// Magic numbers of linux/magic.h and statfs(2), written out: several are missing from the headers of the system.
constexpr std::array<std::uint64_t, 16> network_file_systems{
    0x6969,      // NFS
    0x517b,      // SMB
    0xff534d42,  // CIFS
    0xfe534d42,  // SMB2
    0x5346414f,  // AFS
    0x6b414653,  // AFS of the kernel
    0x73757245,  // Coda
    0x00c36400,  // Ceph
    0x0bd00bd0,  // Lustre
    0x47504653,  // GPFS
    0x19830326,  // BeeGFS
    0xaad7aaea,  // PanFS
    0x01161970,  // GFS2
    0x7461636f,  // OCFS2
    0x01021997,  // 9P
    0x65735546,  // FUSE: sshfs, GlusterFS and others
};

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database) {
    check(sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement_, nullptr));
}

Statement::~Statement() {
    sqlite3_finalize(statement_);
}

void Statement::check(int status) const {
    if (status != SQLITE_OK && status != SQLITE_ROW && status != SQLITE_DONE) fail(database_);
}

Statement& Statement::bind(int parameter, std::int64_t value) {
    check(sqlite3_bind_int64(statement_, parameter + 1, value));
    return *this;
}

Statement& Statement::bind(int parameter, double value) {
    check(sqlite3_bind_double(statement_, parameter + 1, value));
    return *this;
}

Statement& Statement::bind(int parameter, std::string_view value) {
    check(sqlite3_bind_text64(statement_, parameter + 1, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind(int parameter, std::span<const std::uint64_t> values) {
    // A null pointer would bind NULL instead of an empty blob.
    const void* data = values.empty() ? static_cast<const void*>("") : values.data();
    check(sqlite3_bind_blob64(statement_, parameter + 1, data, values.size_bytes(), SQLITE_TRANSIENT));
    return *this;
}

bool Statement::step() {
    const int status = sqlite3_step(statement_);
    check(status);
    return status == SQLITE_ROW;
}

void Statement::run() {
    check(sqlite3_step(statement_));
    check(sqlite3_reset(statement_));
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_, column);
}

double Statement::real(int column) const {
    return sqlite3_column_double(statement_, column);
}

bool Statement::is_number(int column) const {
    const int type = sqlite3_column_type(statement_, column);
    return type == SQLITE_INTEGER || type == SQLITE_FLOAT;
}

int Statement::columns() const {
    return sqlite3_column_count(statement_);
}

std::int64_t Statement::bytes(int column) const {
    return sqlite3_column_bytes(statement_, column);
}

std::string Statement::text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return text == nullptr ? std::string()
                           : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}

std::vector<std::uint64_t> Statement::integers(int column) const {
    const void* blob = sqlite3_column_blob(statement_, column);
    std::vector<std::uint64_t> values(static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)) /
                                      sizeof(std::uint64_t));
    if (!values.empty()) std::memcpy(values.data(), blob, values.size() * sizeof(std::uint64_t));
    return values;
}

std::string sqlite_name(const std::filesystem::path& file) {
    if (file == ":memory:") return file.string();
    std::string name = std::filesystem::absolute(file).string();
    if (name.size() > longest_name) {
        throw IoError("{}: a path of {} bytes is too long for SQLite, which takes {}. Choose a shorter one.",
                      file.string(), name.size(), longest_name);
    }
    return name;
}

Database::Database(const std::filesystem::path& file, Mode mode) {
    // A connection that only reads is used by one thread at a time; a lock for each value would take a fifth of the
    // time of a report.
    const int flags = mode == Mode::read_only ? SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX
                                              : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX;
    if (sqlite3_open_v2(sqlite_name(file).c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
        const std::string reason = handle_ == nullptr ? "out of memory" : sqlite3_errmsg(handle_);
        sqlite3_close_v2(handle_);
        throw IoError("{}: {}. Check that the folder exists and can be written.", file.string(), reason);
    }
    sqlite3_busy_timeout(handle_, patience_ms);
    // A file from elsewhere must not run code: no trigger, no view, no function in its schema.
    for (const auto& [option, value] :
         {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
          std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}, std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0}}) {
        if (sqlite3_db_config(handle_, option, value, nullptr) != SQLITE_OK) fail(handle_);
    }
    if (mode == Mode::read_only) undo_interrupted_change(handle_, sqlite_name(file));
}

Database::~Database() {
    sqlite3_close_v2(handle_);
}

std::string Database::file() const {
    const char* name = sqlite3_db_filename(handle_, "main");
    return name == nullptr ? std::string() : name;
}

bool Database::has_moved() const {
    int moved = 0;
    return sqlite3_file_control(handle_, "main", SQLITE_FCNTL_HAS_MOVED, &moved) == SQLITE_OK && moved != 0;
}

void Database::execute(const char* sql) const {
    if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail(handle_);
}

bool Database::execute_unless_busy(const char* sql) {
    const int status = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
    if (status == SQLITE_BUSY || status == SQLITE_LOCKED) return false;
    if (status != SQLITE_OK) fail(handle_);
    return true;
}

void Database::execute_in_turn(const char* sql) {
    // SQLite does not wait for a lock where two programs wait for each other, as happens when both change the journal.
    constexpr int pause_ms = 10;
    for (int left = patience_ms / pause_ms; left > 0; --left) {
        if (execute_unless_busy(sql)) return;
        sqlite3_sleep(pause_ms);
    }
    execute(sql);
}

void Database::copy_from(const std::filesystem::path& source, const std::function<void()>& copy) const {
    Statement(handle_, "ATTACH ? AS source").with(sqlite_name(source)).run();
    // BEGIN IMMEDIATE would also lock the source for writing. The commit would then cover two files, and SQLite leaves
    // the journal of such a commit behind where the program is killed.
    execute("BEGIN");
    copy();
    execute("COMMIT; DETACH source");
}

bool Database::has_table(std::string_view name) const {
    Statement query(handle_, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
    return query.with(name).step();
}

std::int64_t Database::changes() const {
    return sqlite3_changes(handle_);
}

void Database::keep_log_on_close(bool keep) {
    if (sqlite3_db_config(handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, keep ? 1 : 0, nullptr) != SQLITE_OK) fail(handle_);
}

Journal journal_for(std::uint64_t file_system_type) {
    const bool network = std::ranges::find(network_file_systems, file_system_type) != network_file_systems.end();
    return network ? Journal::rollback : Journal::write_ahead;
}

Journal journal_in(const std::filesystem::path& folder) {
    struct statfs information {};
    const std::filesystem::path place = folder.empty() ? "." : folder;
    if (::statfs(place.c_str(), &information) != 0) {
        throw IoError("{}: its file system cannot be looked at ({}). Check that the folder exists.", place.string(),
                      std::generic_category().message(errno));
    }
    // The field is signed on some systems; magic numbers have 32 bits.
    return journal_for(static_cast<std::uint32_t>(information.f_type));
}

}  // namespace ff::studies
