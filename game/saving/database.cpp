// SPDX-License-Identifier: MIT
#include "game/saving/database.h"

#include <sqlite3.h>

#include "engine/core/error.h"

namespace sl {

namespace {

constexpr int longest_text = 1 << 24;  // bytes, and of a row

std::string reason(int code, const char* message) {
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED: return "it is open in another process";
        case SQLITE_FULL: return "the disk is full";
        case SQLITE_READONLY: return "it cannot be written: the file or its folder is read-only";
        case SQLITE_CANTOPEN: return "it cannot be opened: look at its folder and your rights there";
        case SQLITE_IOERR: return fmt::format("it cannot be read or written ({}): look at the disk", message);
        case SQLITE_NOTADB: return "it is no world: not an SQLite database, or a damaged one";
        case SQLITE_CORRUPT: return "it is damaged";
        default: return message;
    }
}

int flags_of(Database::Access access) {
    switch (access) {
        case Database::Access::create: return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
        case Database::Access::write: return SQLITE_OPEN_READWRITE;
        case Database::Access::read: break;
    }
    return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
}

/// A path in a URI.
std::string escaped(const std::string& path) {
    std::string result;
    for (const char c : path) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '.' || c == '_' || c == '-';
        result += plain ? std::string(1, c) : fmt::format("%{:02x}", static_cast<unsigned char>(c));
    }
    return result;
}

}  // namespace

void Database::Close::operator()(sqlite3* connection) const { sqlite3_close_v2(connection); }
void Database::Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

void Database::fail_with(int code) const { fail("{}: {}", path_.string(), reason(code, connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(code))); }

Database::Database(const std::filesystem::path& path, Access access) : path_(path) {
    std::error_code ignored;
    const bool exists = std::filesystem::exists(path, ignored);
    if (exists && access == Access::create) fail("{}: there is such a file already", path.string());
    if (!exists && access != Access::create) fail("{}: there is no such file", path.string());
    if (exists && !std::filesystem::is_regular_file(path, ignored)) fail("{}: it is no file", path.string());
    sqlite3* connection = nullptr;
    // Where nothing can be written there can be no log either, and its memory beside the file is not asked for.
    const std::string name = access == Access::read ? "file:" + escaped(std::filesystem::absolute(path).string()) + "?immutable=1" : path.string();
    const int code = sqlite3_open_v2(name.c_str(), &connection, flags_of(access), nullptr);
    connection_.reset(connection);
    if (code != SQLITE_OK) fail_with(code);
    sqlite3_extended_result_codes(connection, 1);
    // Files come from strangers: no attached files, no code in the schema, no text that is made longer than any file of ours has.
    sqlite3_db_config(connection, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(connection, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_limit(connection, SQLITE_LIMIT_LENGTH, longest_text);
}

void Database::run(const std::string& sql) {
    const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail_with(code);
}

std::int64_t Database::integer(std::string_view sql) {
    Statement statement(*this, sql);
    return statement.next() ? statement.integer(0) : 0;
}

Database::Statement::Statement(Database& database, std::string_view sql) : database_(database) {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(database.connection_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    if (code != SQLITE_OK) database.fail_with(code);
}

Database::Statement& Database::Statement::bind(int parameter, std::int64_t value) {
    if (const int code = sqlite3_bind_int64(statement_.get(), parameter + 1, value); code != SQLITE_OK) database_.fail_with(code);
    return *this;
}

Database::Statement& Database::Statement::bind(int parameter, std::string_view text) {
    const int code = sqlite3_bind_text64(statement_.get(), parameter + 1, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
    if (code != SQLITE_OK) database_.fail_with(code);
    return *this;
}

bool Database::Statement::next() {
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail_with(code);
    return code == SQLITE_ROW;
}

void Database::Statement::reset() { sqlite3_reset(statement_.get()); }

std::int64_t Database::Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::string Database::Statement::text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    return text != nullptr ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))) : std::string();
}

}  // namespace sl
