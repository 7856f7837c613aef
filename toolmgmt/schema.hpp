// The tables of the store's file, and how an older file becomes a newer one.
#pragma once

#include <string>

struct sqlite3;

namespace polyturn::toolmgmt {

// Which step of the schema the file is at; 0 for an empty one, -1 when it cannot be read.
int schema_version(sqlite3* db);
// Applies every step that the file lacks, in one transaction. False when SQLite refuses; its
// message is then the reason.
bool migrate(sqlite3* db);
int newest_schema_version();
// from this version on the file counts what it has acknowledged
inline constexpr int kAcknowledges = 6;

// "2026-01-31T12:34:56.789Z"
std::string utc_now();

}  // namespace polyturn::toolmgmt
