// The open file behind a Database. Included by database*.cpp only.
#pragma once

#include <sqlite3.h>

#include <optional>
#include <string>

#include "toolmgmt/database.hpp"
#include "toolmgmt/durability/page_sums.hpp"
#include "toolmgmt/durability/witness.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {

struct Database::Parts {
    static constexpr int kFoldAt = 500;  // frames of the log, about 2 MB

    sqlite3* db = nullptr;
    std::string path, folder;
    OpenFile lock;
    std::optional<WitnessFile> witness;  // nothing: a copy in memory acknowledges nothing
    PageSums sums;
    std::uint64_t store = 0, commits = 0;  // as the file's table «promise» has them
    int log_frames = 0;                    // in the log, not in the main file
    bool folds = false;                    // the sums are known
    bool told = false;                     // that the witness cannot be written
    Condition condition;
    ~Parts() {
        if (db) (void)fold();
        sqlite3_close_v2(db);
    }

    Diagnosis fault(Alarm alarm) const { return {alarm, {path, 0, 0, 0}, {}, sqlite3_errmsg(db)}; }
    // What went wrong while the file was opened or read.
    Diagnosis open_fault() const {
        switch (sqlite3_errcode(db) & 0xff) {
            case SQLITE_NOTADB:
            case SQLITE_CORRUPT:
                return fault(Alarm::StoreDamaged);
            case SQLITE_BUSY:
            case SQLITE_LOCKED:
                return fault(Alarm::StoreBusy);
            default:
                return fault(Alarm::StoreOpen);
        }
    }
    // Ends a transaction: on disk, counted, and the witness knows of it.
    Result<void> seal(Transaction& transaction, bool users_changed = false);
    // Brings the log into the main file.
    Result<void> fold();
    // The first acknowledgement of a store: sums of all pages, then the witness.
    Result<void> begin_acknowledging();
    bool read_acknowledged(bool& had_users);
    Result<void> note_unfit();
};

// Are the tables that act whole? `what`: the first fault. The history is checked when it is read.
bool intact(sqlite3* db, int version, std::string& what);
// Of all users; never 0.
std::uint64_t digest_of_users(sqlite3* db);
bool any_users(sqlite3* db);
std::uint64_t random_number();

}  // namespace polyturn::toolmgmt
