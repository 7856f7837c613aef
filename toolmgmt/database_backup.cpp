// Backups: a copy of the file with the machine's files in it, made while the store works; and how
// it is read again.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <set>

#include "toolmgmt/database_parts.hpp"
#include "toolmgmt/schema.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtra =
    "CREATE TABLE backup_files(name TEXT NOT NULL, path TEXT NOT NULL, bytes BLOB NOT NULL, "
    "PRIMARY KEY(name, path));"
    "CREATE TABLE backup_info(utc TEXT NOT NULL, schema INTEGER NOT NULL);";

struct Handle {
    sqlite3* db = nullptr;
    ~Handle() { sqlite3_close_v2(db); }
};

Diagnosis bad(const std::string& file, std::string why) {
    return {Alarm::BackupBad, {file, 0, 0, 0}, {}, file + " (" + std::move(why) + ")"};
}

// An empty file that only its owner reads; SQLite fills it.
bool make_empty(const std::string& path) {
    std::error_code none;
    fs::remove(path, none);
    const OpenFile file(
        ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
    return file && ::fchmod(file.get(), private_mode(fs::path(path).parent_path().string())) == 0;
}

bool add_files(sqlite3* db, const std::vector<Database::File>& files) {
    if (!run(db, "PRAGMA journal_mode=DELETE; PRAGMA synchronous=FULL;") || !run(db, kExtra))
        return false;
    Transaction transaction(db);
    if (!transaction.begun()) return false;
    for (const Database::File& file : files) {
        sqlite3_stmt* statement = nullptr;
        sqlite3_prepare_v2(db,
                           "INSERT OR REPLACE INTO backup_files(name, path, bytes) VALUES(?, ?, ?)",
                           -1, &statement, nullptr);
        sqlite3_bind_text(statement, 1, file.name.data(), static_cast<int>(file.name.size()),
                          SQLITE_TRANSIENT);
        sqlite3_bind_text(statement, 2, file.path.data(), static_cast<int>(file.path.size()),
                          SQLITE_TRANSIENT);
        sqlite3_bind_blob64(statement, 3, file.bytes.data(), file.bytes.size(), SQLITE_TRANSIENT);
        const bool good = sqlite3_step(statement) == SQLITE_DONE;
        sqlite3_finalize(statement);
        if (!good) return false;
    }
    Statement info(db, "INSERT INTO backup_info(utc, schema) VALUES(?, ?)");
    return info.bind(1, utc_now()).bind(2, std::int64_t{newest_schema_version()}).run() &&
           transaction.commit();
}

}  // namespace

Result<void> Database::backup(const std::string& file, const std::vector<File>& files) {
    const std::string part = file + ".part";
    std::error_code none;
    const auto refuse = [&](const std::string& why) {
        std::error_code ignored;
        fs::remove(part, ignored);
        return Diagnosis{Alarm::OutputFile, {}, {}, file + " (" + why + ")"};
    };
    if (!make_empty(part)) return refuse(std::strerror(errno));
    Statement copy(parts_->db, "VACUUM main INTO ?");
    if (!copy.bind(1, part).run()) return refuse(sqlite3_errmsg(parts_->db));
    {
        Handle out;
        if (sqlite3_open_v2(part.c_str(), &out.db, SQLITE_OPEN_READWRITE, nullptr) != SQLITE_OK ||
            !add_files(out.db, files))
            return refuse(sqlite3_errmsg(out.db));
    }
    if (!sync_file(part)) return refuse("it cannot be brought to the disk");
    fs::rename(part, file, none);
    if (none) return refuse(none.message());
    sync_folder(fs::absolute(file, none).parent_path().string());
    return {};
}

namespace {

constexpr std::size_t kLargestBackup = std::size_t{1} << 30, kMostFiles = 20'000;

struct Thing {
    std::string type, name, table;
    friend auto operator<=>(const Thing&, const Thing&) = default;
};

bool things_of(sqlite3* db, std::set<Thing>& out) {
    Statement rows(db, "SELECT type, name, tbl_name FROM sqlite_schema");
    while (rows.row()) out.insert({rows.text(0), rows.text(1), rows.text(2)});
    return rows.done();
}

std::string columns_of(sqlite3* db, const std::string& table) {
    Statement rows(db, "SELECT name, type, pk, hidden FROM pragma_table_xinfo(?) ORDER BY cid");
    rows.bind(1, std::string_view(table));
    std::string out;
    while (rows.row())
        out += rows.text(0) + " " + rows.text(1) + " " + std::to_string(rows.whole(2)) + " " +
               std::to_string(rows.whole(3)) + "\n";
    return out;
}

// Empty: tables, columns and indexes are those of a store. A view or a trigger would act when a
// value is read or written.
std::string foreign_thing(sqlite3* db) {
    Handle fresh;
    if (sqlite3_open_v2(":memory:", &fresh.db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE,
                        nullptr) != SQLITE_OK ||
        !migrate(fresh.db) || !run(fresh.db, kExtra))
        return "no memory";
    std::set<Thing> known, there;
    if (!things_of(fresh.db, known) || !things_of(db, there)) return sqlite3_errmsg(db);
    for (const Thing& thing : there) {
        if (!known.contains(thing)) return thing.type + " " + thing.name;
        if (thing.type == "table" && columns_of(db, thing.name) != columns_of(fresh.db, thing.name))
            return "columns of " + thing.name;
    }
    return {};
}

// The backup in memory, with journals and the like beside it left alone; up to date, and nothing in
// it that a store does not have.
Result<void> open_backup(const std::string& file, sqlite3*& db) {
    std::string bytes;
    std::error_code none;
    if (!fs::is_regular_file(file, none)) return bad(file, "no such file");
    if (fs::file_size(file, none) > kLargestBackup)
        return Diagnosis{Alarm::FileTooLarge, {}, {}, file};
    if (!read_whole_file(file, bytes)) return bad(file, std::strerror(errno));
    if (bytes.size() < 512) return bad(file, "file is not a database");
    bytes[18] = bytes[19] = 1;  // memory has no log
    if (sqlite3_open_v2(":memory:", &db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) !=
        SQLITE_OK)
        return bad(file, "no memory");
    auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
    if (!copy) return bad(file, "no memory");
    std::memcpy(copy, bytes.data(), bytes.size());
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    if (sqlite3_deserialize(db, "main", copy, size, size,
                            SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE) !=
            SQLITE_OK ||
        !run(db, "PRAGMA trusted_schema=OFF; PRAGMA cell_size_check=ON;"))
        return bad(file, sqlite3_errmsg(db));
    const int version = schema_version(db);
    if (version <= 0) return bad(file, version < 0 ? sqlite3_errmsg(db) : "it holds no store");
    if (version > newest_schema_version())
        return bad(file, "made by a newer version: schema " + std::to_string(version) +
                             ", known up to " + std::to_string(newest_schema_version()));
    std::string what;
    if (!intact(db, version, what)) return bad(file, what.empty() ? sqlite3_errmsg(db) : what);
    if (const std::string foreign = foreign_thing(db); !foreign.empty())
        return Diagnosis{Alarm::BackupForeign, {file, 0, 0, 0}, {}, file + ": " + foreign};
    if (!migrate(db)) return bad(file, sqlite3_errmsg(db));
    return {};
}

}  // namespace

// Read in memory: an older backup is brought up to date there, and the file stays as it is.
Result<void> Database::read_backup(const std::string& file, StoreValues& values,
                                   std::vector<File>& files, std::vector<Diagnosis>& warnings) {
    auto parts = std::make_unique<Parts>();
    parts->path = file;
    if (Result<void> opened = open_backup(file, parts->db); !opened) return opened;
    Statement size(parts->db, "SELECT count(*) FROM backup_files");
    if (!size.row()) return bad(file, "it is a store and no backup");
    if (size.whole(0) > static_cast<std::int64_t>(kMostFiles))
        return bad(file, std::to_string(size.whole(0)) + " files");
    Statement rows(parts->db, "SELECT name, path, bytes FROM backup_files");
    while (rows.row()) files.push_back({rows.text(0), rows.text(1), rows.text(2)});
    if (!rows.done()) return bad(file, sqlite3_errmsg(parts->db));
    Database memory(std::move(parts));
    if (const Result<void> read = memory.read_into(values, warnings); !read)
        return bad(file, read.diagnosis().detail);
    return {};
}

Result<std::int64_t> Database::merge_history(const std::string& file) {
    Handle from;
    if (Result<void> opened = open_backup(file, from.db); !opened) return opened.diagnosis();
    Transaction transaction(parts_->db);
    if (!transaction.begun()) return parts_->fault(Alarm::StoreWrite);
    Statement lines(from.db, "SELECT utc, who, what, old, new FROM history ORDER BY id");
    std::int64_t taken = 0;
    {
        Statement line(
            parts_->db,
            "INSERT INTO history(utc, who, what, old, new) SELECT ?1, ?2, ?3, ?4, ?5 WHERE NOT "
            "EXISTS(SELECT 1 FROM history WHERE what = ?3 AND utc = ?1 AND who = ?2)");
        while (lines.row()) {
            for (int column = 0; column < 5; ++column)
                line.bind(column + 1, std::string_view(lines.text(column)));
            if (!line.run()) return parts_->fault(Alarm::StoreWrite);
            taken += sqlite3_changes(parts_->db);
        }
    }
    if (!lines.done()) return bad(file, sqlite3_errmsg(from.db));
    if (Result<void> sealed = parts_->seal(transaction); !sealed) return sealed.diagnosis();
    return taken;
}

// What is killed in between leaves the old store, or one that says that it is unfit until this is
// done again: never an empty one.
Result<std::string> Database::install(const std::string& folder, const std::string& fresh) {
    const fs::path target = fs::path(folder) / kFile;
    const auto refuse = [&](const std::string& why) {
        return Diagnosis{Alarm::OutputFile, {}, {}, target.string() + " (" + why + ")"};
    };
    PageSums sums;
    Witness witness;
    {
        Handle db;
        if (sqlite3_open_v2(fresh.c_str(), &db.db, SQLITE_OPEN_READWRITE, nullptr) != SQLITE_OK ||
            !run(db.db, "PRAGMA synchronous=FULL; PRAGMA journal_mode=WAL;"))
            return refuse(sqlite3_errmsg(db.db));
        sums.store = witness.store = random_number();
        Statement row(db.db, "UPDATE promise SET store = ?, commits = 0, stamp = 0 WHERE id = 1");
        if (!row.bind(1, static_cast<std::int64_t>(witness.store)).run())
            return refuse(sqlite3_errmsg(db.db));
        if (any_users(db.db)) witness.users = digest_of_users(db.db);
        Statement page(db.db, "PRAGMA page_size");
        if (!page.row()) return refuse(sqlite3_errmsg(db.db));
        sums.page_size = static_cast<std::uint32_t>(page.whole(0));
    }
    std::string bytes;
    if (!sync_file(fresh) || !read_whole_file(fresh, bytes))
        return refuse("it cannot be brought to the disk");
    sums.take(bytes, sums.page_size);
    std::string kept;
    std::error_code wrong;
    if (fs::exists(target, wrong)) {
        kept = target.string() + ".before-" + utc_now();
        // some file systems have one name for a file
        if (::link(target.c_str(), kept.c_str()) != 0) fs::copy_file(target, kept, wrong);
    }
    for (const char* tail : {"-wal", "-shm"})
        if (std::error_code none; fs::exists(target.string() + tail, none))
            fs::rename(target.string() + tail,
                       (kept.empty() ? target.string() + ".before-" + utc_now() : kept) + tail,
                       wrong);
    if (wrong) return refuse(wrong.message());
    fs::rename(fresh, target, wrong);
    if (wrong) return refuse(wrong.message());
    sync_folder(folder);
    WitnessFile file(folder);
    (void)file.read();
    if (!sums.write(folder) || !file.write(witness)) return refuse(std::strerror(errno));
    return kept;
}

// The store's file itself is replaced by a backup; what was there is kept beside it.
Result<std::string> Database::put_back(const std::string& folder, const std::string& file,
                                       std::vector<File>& files) {
    auto values = std::make_unique<StoreValues>();
    clear(*values);
    std::vector<Diagnosis> warnings;
    if (Result<void> good = read_backup(file, *values, files, warnings); !good)
        return good.diagnosis();
    const std::string fresh = (fs::path(folder) / kFile).string() + ".new";
    const auto refuse = [&](const std::string& why) {
        return Diagnosis{Alarm::OutputFile, {}, {}, fresh + " (" + why + ")"};
    };
    if (const std::string wrong = make_folder(folder); !wrong.empty()) return refuse(wrong);
    {
        Handle from;
        if (Result<void> opened = open_backup(file, from.db); !opened) return opened.diagnosis();
        if (!run(from.db, "DROP TABLE backup_files; DROP TABLE backup_info;") || !make_empty(fresh))
            return refuse(sqlite3_errmsg(from.db));
        Statement copy(from.db, "VACUUM main INTO ?");
        if (!copy.bind(1, std::string_view(fresh)).run()) return refuse(sqlite3_errmsg(from.db));
    }
    return install(folder, fresh);
}

}  // namespace polyturn::toolmgmt
