// The store on disk: one SQLite file, written by one process, every commit durable (WAL, synchronous=FULL) before it
// returns. Numbers keep all their bits; an empty variable is NULL.
//
//   parameters  what was changed from the machine's file, by name: the slots of the table move between versions
//   offsets, zeros, variables, counters, positions   by channel and number
//   history     when (UTC), who, what, old, new; the newest 200 000
//   migrations  which versions of this schema the file went through
//
// A file of an older version is brought up to date inside one transaction; one of a newer version is refused and left
// as it is, a damaged one too.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

class Database {
public:
    static constexpr int kVersion = 1;
    static constexpr const char* kFile = "store.sqlite";

    // Makes folder and file where they are missing. Refuses a file that another process has open.
    static Result<Database> open(const std::string& folder);
    Database(Database&&) noexcept;
    Database& operator=(Database&&) noexcept;
    ~Database();

    // Puts what the file holds on top of the values. What no longer exists here (a parameter of another version, a value
    // outside its limits) is left out with a warning.
    Result<void> read_into(StoreValues& values, std::vector<Diagnosis>& warnings);
    // All of them or none; on disk when it returns well. Each change also goes to the history under `who`, but not the
    // variables, counters and positions of "program".
    Result<void> commit(const std::vector<Change>& changes, std::string_view who);

    // Lines of the history, newest first: "2026-01-31T12:34:56.789Z operator N1600 L1: 2 -> 2.5".
    Result<std::vector<std::string>> history(int most);

private:
    struct Parts;
    explicit Database(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace polyturn::toolmgmt
