// A prepared SQLite statement and a transaction, so far as the store needs them. Included by
// database.cpp and schema.cpp only.
#pragma once

#include <sqlite3.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace polyturn::toolmgmt {

class Statement {
public:
    Statement(sqlite3* db, const char* sql) {
        code_ = sqlite3_prepare_v2(db, sql, -1, &statement_, nullptr);
    }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;
    ~Statement() { sqlite3_finalize(statement_); }

    Statement& bind(int at, std::int64_t value) {
        return note(sqlite3_bind_int64(statement_, at, value));
    }
    // SQLite has no NaN: an empty variable is NULL, and so it comes back.
    Statement& bind(int at, double value) {
        return note(std::isnan(value) ? sqlite3_bind_null(statement_, at)
                                      : sqlite3_bind_double(statement_, at, value));
    }
    Statement& bind(int at, std::string_view value) {
        return note(sqlite3_bind_text(statement_, at, value.data(), static_cast<int>(value.size()),
                                      SQLITE_TRANSIENT));
    }
    Statement& bind_null(int at) { return note(sqlite3_bind_null(statement_, at)); }

    // True while there is a row. After the last one code() says whether there was an error.
    bool row() {
        if (code_ == SQLITE_OK || code_ == SQLITE_ROW) code_ = sqlite3_step(statement_);
        return code_ == SQLITE_ROW;
    }
    // Runs a statement without rows, ready for the next binding.
    bool run() {
        row();
        const bool good = code_ == SQLITE_DONE;
        if (!good) return false;
        sqlite3_reset(statement_);
        code_ = SQLITE_OK;
        return true;
    }
    bool done() const { return code_ == SQLITE_DONE; }

    std::int64_t whole(int column) const { return sqlite3_column_int64(statement_, column); }
    bool null(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
    double number(int column) const {
        return null(column) ? std::nan("") : sqlite3_column_double(statement_, column);
    }
    std::string text(int column) const {
        const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
        return bytes
                   ? std::string(bytes,
                                 static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
                   : std::string();
    }

private:
    Statement& note(int code) {
        if (code_ == SQLITE_OK) code_ = code;
        return *this;
    }
    sqlite3_stmt* statement_ = nullptr;
    int code_ = SQLITE_OK;
};

inline bool run(sqlite3* db, const char* sql) {
    return sqlite3_exec(db, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

// All or nothing: rolled back unless committed.
class Transaction {
public:
    explicit Transaction(sqlite3* db) : db_(db), begun_(run(db, "BEGIN IMMEDIATE")) {}
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction() {
        if (begun_) run(db_, "ROLLBACK");
    }
    bool begun() const { return begun_; }
    // With synchronous=FULL the log is on the disk when this returns true.
    bool commit() {
        const bool good = begun_ && run(db_, "COMMIT");
        if (good) begun_ = false;
        return good;
    }

private:
    sqlite3* db_;
    bool begun_;
};

}  // namespace polyturn::toolmgmt
