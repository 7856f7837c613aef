// The store on disk: one SQLite file, written by one process, every commit durable (WAL,
// synchronous=FULL) before it returns. Numbers keep all their bits; an empty variable is NULL.
//
//   parameters  what was changed from the machine's file, by name: the slots of the table move
//   between versions
//   offsets, zeros, variables, counters, positions   by channel and number
//   records     tools, edges, places, users, dimensions, pallets: one row a value, by the name of
//               its column
//   history     when (UTC), who, what, old, new; the newest million
//   stops       when (UTC) a channel stood, how long, why; the newest hundred thousand
//   migrations  which versions of this schema the file went through
//   promise     how many commits were acknowledged, against store.witness (durability/README.md)
//
// A file of an older version is brought up to date inside one transaction; one of a newer version
// is refused and left as it is. Damage and loss are found when it is opened: then condition() says
// what is wrong, and a damaged file is not written.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

class Database {
public:
    static constexpr const char* kFile = "store.sqlite";

    // What was acknowledged and is not there.
    struct Condition {
        // StoreLost, StoreDamaged: no production until somebody has restored a backup or confirmed
        std::optional<Diagnosis> unfit;
        // the file is not worked on: values are what could be read, nothing can be kept
        bool broken = false;
        // the users are not those that were acknowledged: nobody has rights
        bool locked = false;
        bool had_users = false;  // there have been users: «no users yet» is over for good
    };
    const Condition& condition() const;
    // Production goes on with what is left. A damaged file is kept under another name.
    Result<void> confirm();
    // Brings the log into the main file; cheap when there is nothing to bring.
    Result<void> fold();
    bool anything_to_fold() const;

    // Makes folder and file where they are missing. Refuses a file that another process has open.
    // Everything that is read afterwards is on the disk, also what a predecessor that was killed
    // had only written.
    static Result<Database> open(const std::string& folder);
    Database(Database&&) noexcept;
    Database& operator=(Database&&) noexcept;
    ~Database();

    // Puts what the file holds on top of the values. What no longer exists here (a parameter of
    // another version, a value outside its limits) is left out with a warning.
    Result<void> read_into(StoreValues& values, std::vector<Diagnosis>& warnings);
    // All of them or none; on disk when it returns well. Each change also goes to the history under
    // `who`, but not the variables, counters and positions of "program".
    Result<void> commit(const std::vector<Change>& changes, std::string_view who);

    // Lines of the history, newest first: "2026-01-31T12:34:56.789Z operator N1600 L1: 2 -> 2.5".
    Result<std::vector<std::string>> history(int most);
    struct Entry {
        std::int64_t id = 0;
        std::string utc, who, what, before, after;
    };
    // Which of them, newest first. `about` and `who` are parts of the texts, empty means all;
    // `before`: only what is older than that row.
    struct HistoryOf {
        // Value: `about` is its whole name; entered: by people
        enum class Kind : std::uint8_t {
            All,
            Value,
            Parameters,
            EnteredOffsets,
            EnteredEdges
        } kind = Kind::All;
        std::string about = {}, who = {}, before_utc = {};
        std::int64_t before_id = 0, most = 50;
    };
    // A part of a text has no index: kHistoryLook rows are read, and where that was not
    // enough, `more` is the last of them.
    struct History {
        std::vector<Entry> entries;
        std::optional<std::pair<std::string, std::int64_t>> more;  // utc, id
    };
    static constexpr std::int64_t kHistoryLook = 10'000;  // 20 ms
    Result<History> history(const HistoryOf& of);
    // ?1 about, ?2 and ?3 before, ?4 rows to look at
    static std::string history_query(const HistoryOf& of);

    // A stop of a channel. Its begin and its channel name it: reported again, it is
    // replaced.
    struct Stop {
        std::string utc;  // of its begin
        int channel = 0;
        std::string cause, number, detail, program;
        int line = 0;
        double seconds = 0;  // NaN: not over, or its end was not seen
    };
    Result<void> note_stop(const Stop& stop);
    Result<std::vector<Stop>> stops(std::string_view since, std::int64_t most);  // newest first

    // Alarms and warnings as the event log has them (JSON), the newest hundred thousand. They
    // outlast the controller that reported them.
    struct AlarmEvent {
        std::int64_t id = 0;
        std::string utc, event;
    };
    Result<void> note_alarms(const std::vector<AlarmEvent>& alarms);
    // newest first
    Result<std::vector<AlarmEvent>> alarms(std::string_view before_utc, std::int64_t before_id,
                                           std::int64_t most);

    // A consistent copy of the whole file with the bytes of other files beside it, on disk when it
    // returns well. Written under another name and renamed, so that an existing backup is a
    // whole one.
    struct File {
        std::string name, path, bytes;  // name: what it is; path: where it goes back to
    };
    Result<void> backup(const std::string& file, const std::vector<File>& files);
    // What a backup holds: its values on top of `values` (cleared by the caller), its files.
    // Nothing of the file is trusted: tables and columns must be those of a store, and what is too
    // large is refused.
    static Result<void> read_backup(const std::string& file, StoreValues& values,
                                    std::vector<File>& files, std::vector<Diagnosis>& warnings);
    // Takes over the history of a backup, what is here already only once. Returns how many lines
    // came.
    Result<std::int64_t> merge_history(const std::string& file);
    // The file of a store that does not run is replaced by a backup. Returns the name under which
    // the old one was kept.
    static Result<std::string> put_back(const std::string& folder, const std::string& file,
                                        std::vector<File>& files);
    const std::string& path() const;

private:
    // The new main file in place of the old one, which is kept; returns its name.
    static Result<std::string> install(const std::string& folder, const std::string& fresh);
    struct Parts;
    explicit Database(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace polyturn::toolmgmt
