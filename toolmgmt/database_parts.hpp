// The open file behind a Database. Included by database.cpp and database_backup.cpp only.
#pragma once

#include <sqlite3.h>

#include <string>

#include "toolmgmt/database.hpp"

namespace polyturn::toolmgmt {

struct Database::Parts {
    sqlite3* db = nullptr;
    std::string path;
    ~Parts() { sqlite3_close_v2(db); }

    Diagnosis fault(Alarm alarm) const { return {alarm, {path, 0, 0, 0}, {}, sqlite3_errmsg(db)}; }
    // What went wrong while the file was opened or read.
    Diagnosis open_fault() const {
        switch (sqlite3_errcode(db) & 0xff) {
            case SQLITE_NOTADB:
            case SQLITE_CORRUPT: return fault(Alarm::StoreDamaged);
            case SQLITE_BUSY:
            case SQLITE_LOCKED: return fault(Alarm::StoreBusy);
            default: return fault(Alarm::StoreOpen);
        }
    }
};

// Are the tables that act whole? `what`: the first fault. The history is looked at when it is read.
bool intact(sqlite3* db, int version, std::string& what);

}  // namespace polyturn::toolmgmt
