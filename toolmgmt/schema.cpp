#include "toolmgmt/schema.hpp"

#include <time.h>

#include <array>
#include <cstdio>

#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {
namespace {

// Step n leads from version n to n + 1. A step that was released is never edited, white space
// apart: files in the field went through it, and nothing compares the text of their schema.
constexpr std::array kSteps = {
    R"sql(
    CREATE TABLE migrations(version INTEGER PRIMARY KEY, utc TEXT NOT NULL);
    CREATE TABLE parameters(name TEXT NOT NULL, instance INTEGER NOT NULL, element INTEGER NOT NULL,
                            number REAL, text TEXT,
                            PRIMARY KEY(name, instance, element)) WITHOUT ROWID;
    CREATE TABLE offsets(channel INTEGER NOT NULL, number INTEGER NOT NULL,
                         field INTEGER NOT NULL, value REAL,
                         PRIMARY KEY(channel, number, field)) WITHOUT ROWID;
    CREATE TABLE zeros(channel INTEGER NOT NULL, number INTEGER NOT NULL,
                       field INTEGER NOT NULL, value REAL,
                       PRIMARY KEY(channel, number, field)) WITHOUT ROWID;
    CREATE TABLE variables(channel INTEGER NOT NULL, number INTEGER NOT NULL,
                           field INTEGER NOT NULL, value REAL,
                           PRIMARY KEY(channel, number, field)) WITHOUT ROWID;
    CREATE TABLE counters(channel INTEGER NOT NULL, number INTEGER NOT NULL,
                          field INTEGER NOT NULL, value REAL,
                          PRIMARY KEY(channel, number, field)) WITHOUT ROWID;
    CREATE TABLE positions(channel INTEGER NOT NULL, number INTEGER NOT NULL,
                           field INTEGER NOT NULL, value REAL,
                           PRIMARY KEY(channel, number, field)) WITHOUT ROWID;
    CREATE TABLE history(id INTEGER PRIMARY KEY, utc TEXT NOT NULL, who TEXT NOT NULL,
                         what TEXT NOT NULL, old TEXT, new TEXT);
    )sql",
    // Tools, edges, places, users and the like: a row for each value that was entered, its column
    // by name.
    R"sql(
    CREATE TABLE records(kind TEXT NOT NULL, scope INTEGER NOT NULL, number INTEGER NOT NULL,
                         field TEXT NOT NULL, value REAL, text TEXT,
                         PRIMARY KEY(kind, scope, number, field)) WITHOUT ROWID;
    CREATE INDEX history_utc ON history(utc);
    )sql",
    // When channels were stopped and why; seconds NULL: not over yet, or its end was not seen.
    R"sql(
    CREATE TABLE IF NOT EXISTS stops(utc TEXT NOT NULL, channel INTEGER NOT NULL,
                       cause TEXT NOT NULL, number TEXT, detail TEXT,
                       program TEXT, line INTEGER, seconds REAL,
                       PRIMARY KEY(utc, channel)) WITHOUT ROWID;
    )sql",
    // What machine and programs have refused or warned of, as events report it. And indexes for a
    // million rows of history, of which screens ask for one value, for all parameters, for what
    // people entered as offsets: history_query() has the same conditions word for word, or the
    // partial ones are not used (tests/unit/toolmgmt/history_plan_test.cpp).
    R"sql(
    CREATE TABLE IF NOT EXISTS alarms(id INTEGER PRIMARY KEY, utc TEXT NOT NULL,
                                      event TEXT NOT NULL);
    CREATE INDEX IF NOT EXISTS history_what ON history(what, utc);
    CREATE INDEX IF NOT EXISTS history_parameters ON history(utc) WHERE what GLOB '[NFMPS]*';
    CREATE INDEX IF NOT EXISTS history_entered ON history(utc)
        WHERE instr(what, ' offset ') > 0 AND who NOT IN ('program', 'setup');
    )sql",
    // Likewise what people entered into edges of tools.
    R"sql(
    CREATE INDEX IF NOT EXISTS history_edges ON history(utc)
        WHERE what GLOB 'tool [0-9]* D[0-9]* DP[0-9]*' AND who NOT IN ('program', 'setup');
    )sql",
    // What was acknowledged, against store.witness (toolmgmt/durability). users: there have been
    // some.
    R"sql(
    CREATE TABLE IF NOT EXISTS promise(id INTEGER PRIMARY KEY CHECK(id = 1),
                                       store INTEGER NOT NULL, commits INTEGER NOT NULL,
                                       stamp INTEGER NOT NULL, users INTEGER NOT NULL);
    INSERT OR REPLACE INTO promise
        SELECT 1, random(), 0, 0, EXISTS(SELECT 1 FROM records WHERE kind = 'user');
    )sql",
};

}  // namespace

int newest_schema_version() { return static_cast<int>(kSteps.size()); }

int schema_version(sqlite3* db) {
    Statement statement(db, "PRAGMA user_version");
    return statement.row() ? static_cast<int>(statement.whole(0)) : -1;
}

bool migrate(sqlite3* db) {
    Transaction transaction(db);
    if (!transaction.begun()) return false;
    for (int version = schema_version(db); version < newest_schema_version(); ++version) {
        if (version < 0 || !run(db, kSteps[static_cast<std::size_t>(version)])) return false;
        Statement note(db, "INSERT INTO migrations(version, utc) VALUES(?, ?)");
        if (!note.bind(1, std::int64_t{version + 1}).bind(2, utc_now()).run()) return false;
        if (!run(db, ("PRAGMA user_version=" + std::to_string(version + 1)).c_str())) return false;
    }
    return transaction.commit();
}

std::string utc_now() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    tm parts{};
    gmtime_r(&now.tv_sec, &parts);
    char text[40];
    const std::size_t size = strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
    std::snprintf(text + size, sizeof text - size, ".%03ldZ", now.tv_nsec / 1'000'000);
    return text;
}

}  // namespace polyturn::toolmgmt
