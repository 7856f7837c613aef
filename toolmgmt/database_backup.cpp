// Backups: a copy of the file with the machine's files in it, made while the store works; and how it is read again.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "toolmgmt/database_parts.hpp"
#include "toolmgmt/schema.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtra =
    "CREATE TABLE backup_files(name TEXT NOT NULL, path TEXT NOT NULL, bytes BLOB NOT NULL, PRIMARY KEY(name, path));"
    "CREATE TABLE backup_info(utc TEXT NOT NULL, schema INTEGER NOT NULL);";

struct Handle {
    sqlite3* db = nullptr;
    ~Handle() { sqlite3_close_v2(db); }
};

Diagnosis bad(const std::string& file, std::string why) { return {Alarm::BackupBad, {file, 0, 0, 0}, {}, file + " (" + std::move(why) + ")"}; }

bool sync_path(const std::string& path, int flags) {
    const int fd = ::open(path.c_str(), flags | O_CLOEXEC);
    if (fd < 0) return false;
    const bool good = ::fsync(fd) == 0;
    ::close(fd);
    return good;
}

bool add_files(sqlite3* db, const std::vector<Database::File>& files) {
    if (!run(db, "PRAGMA journal_mode=DELETE; PRAGMA synchronous=FULL;") || !run(db, kExtra)) return false;
    Transaction transaction(db);
    if (!transaction.begun()) return false;
    for (const Database::File& file : files) {
        sqlite3_stmt* statement = nullptr;
        sqlite3_prepare_v2(db, "INSERT OR REPLACE INTO backup_files(name, path, bytes) VALUES(?, ?, ?)", -1, &statement, nullptr);
        sqlite3_bind_text(statement, 1, file.name.data(), static_cast<int>(file.name.size()), SQLITE_TRANSIENT);
        sqlite3_bind_text(statement, 2, file.path.data(), static_cast<int>(file.path.size()), SQLITE_TRANSIENT);
        sqlite3_bind_blob64(statement, 3, file.bytes.data(), file.bytes.size(), SQLITE_TRANSIENT);
        const bool good = sqlite3_step(statement) == SQLITE_DONE;
        sqlite3_finalize(statement);
        if (!good) return false;
    }
    Statement info(db, "INSERT INTO backup_info(utc, schema) VALUES(?, ?)");
    return info.bind(1, utc_now()).bind(2, std::int64_t{newest_schema_version()}).run() && transaction.commit();
}

}  // namespace

Result<void> Database::backup(const std::string& file, const std::vector<File>& files) {
    const std::string part = file + ".part";
    std::error_code none;
    fs::remove(part, none);
    const auto refuse = [&](const std::string& why) {
        std::error_code ignored;
        fs::remove(part, ignored);
        return Diagnosis{Alarm::OutputFile, {}, {}, file + " (" + why + ")"};
    };
    Statement copy(parts_->db, "VACUUM main INTO ?");
    if (!copy.bind(1, part).run()) return refuse(sqlite3_errmsg(parts_->db));
    {
        Handle out;
        if (sqlite3_open_v2(part.c_str(), &out.db, SQLITE_OPEN_READWRITE, nullptr) != SQLITE_OK || !add_files(out.db, files)) return refuse(sqlite3_errmsg(out.db));
    }
    if (!sync_path(part, O_RDONLY)) return refuse("it cannot be brought to the disk");
    fs::rename(part, file, none);
    if (none) return refuse(none.message());
    const std::string folder = fs::absolute(file, none).parent_path().string();
    sync_path(folder, O_RDONLY | O_DIRECTORY);
    return {};
}

// Read in memory: an older backup is brought up to date there, and the file stays as it is.
Result<void> Database::read_backup(const std::string& file, StoreValues& values, std::vector<File>& files, std::vector<Diagnosis>& warnings) {
    if (!fs::is_regular_file(file)) return bad(file, "no such file");
    auto parts = std::make_unique<Parts>();
    parts->path = file;
    {
        Handle from;
        if (sqlite3_open_v2(file.c_str(), &from.db, SQLITE_OPEN_READONLY, nullptr) != SQLITE_OK) return bad(file, sqlite3_errmsg(from.db));
        const int version = schema_version(from.db);
        if (version <= 0) return bad(file, version < 0 ? sqlite3_errmsg(from.db) : "it holds no store");
        if (version > newest_schema_version()) return bad(file, "made by a newer version: schema " + std::to_string(version) + ", known up to " + std::to_string(newest_schema_version()));
        std::string what;
        if (!intact(from.db, version, what)) return bad(file, what.empty() ? sqlite3_errmsg(from.db) : what);
        if (sqlite3_open_v2(":memory:", &parts->db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) != SQLITE_OK) return bad(file, "no memory");
        sqlite3_backup* copy = sqlite3_backup_init(parts->db, "main", from.db, "main");
        if (!copy) return bad(file, sqlite3_errmsg(parts->db));
        sqlite3_backup_step(copy, -1);
        if (sqlite3_backup_finish(copy) != SQLITE_OK) return bad(file, sqlite3_errmsg(parts->db));
    }
    if (!migrate(parts->db)) return bad(file, sqlite3_errmsg(parts->db));
    Statement rows(parts->db, "SELECT name, path, bytes FROM backup_files");
    while (rows.row()) files.push_back({rows.text(0), rows.text(1), rows.text(2)});
    Database memory(std::move(parts));
    if (const Result<void> read = memory.read_into(values, warnings); !read) return bad(file, read.diagnosis().detail);
    return {};
}

Result<std::int64_t> Database::merge_history(const std::string& file) {
    Statement attach(parts_->db, "ATTACH ? AS old");
    if (!attach.bind(1, file).run()) return parts_->fault(Alarm::StoreWrite);
    const bool good = run(parts_->db,
                          "INSERT INTO history(utc, who, what, old, new) SELECT utc, who, what, old, new FROM old.history AS h WHERE NOT EXISTS("
                          "SELECT 1 FROM main.history AS m WHERE m.utc = h.utc AND m.what = h.what AND m.who = h.who) ORDER BY id");
    const std::int64_t taken = sqlite3_changes64(parts_->db);
    run(parts_->db, "DETACH old");
    if (!good) return parts_->fault(Alarm::StoreWrite);
    return taken;
}

// The store's file itself is replaced by a backup; what was there is kept beside it.
Result<std::string> Database::put_back(const std::string& folder, const std::string& file, std::vector<File>& files) {
    auto values = std::make_unique<StoreValues>();
    clear(*values);
    std::vector<Diagnosis> warnings;
    if (Result<void> good = read_backup(file, *values, files, warnings); !good) return good.diagnosis();
    const fs::path target = fs::path(folder) / kFile;
    const auto refuse = [&](const std::string& why) { return Diagnosis{Alarm::OutputFile, {}, {}, target.string() + " (" + why + ")"}; };
    std::error_code wrong;
    fs::create_directories(folder, wrong);
    const std::string fresh = target.string() + ".new";
    fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, wrong);
    if (wrong) return refuse(wrong.message());
    {
        Handle db;
        if (sqlite3_open_v2(fresh.c_str(), &db.db, SQLITE_OPEN_READWRITE, nullptr) != SQLITE_OK || !run(db.db, "PRAGMA synchronous=FULL; DROP TABLE IF EXISTS backup_files; DROP TABLE IF EXISTS backup_info;") ||
            !migrate(db.db))
            return refuse(sqlite3_errmsg(db.db));
    }
    if (!sync_path(fresh, O_RDONLY)) return refuse("it cannot be brought to the disk");
    std::string kept;
    if (fs::exists(target)) {
        kept = target.string() + ".before-" + utc_now();
        for (const char* tail : {"", "-wal", "-shm"})
            if (fs::exists(target.string() + tail)) fs::rename(target.string() + tail, kept + tail, wrong);
        if (wrong) return refuse(wrong.message());
    }
    fs::rename(fresh, target, wrong);
    if (wrong) return refuse(wrong.message());
    sync_path(folder, O_RDONLY | O_DIRECTORY);
    return kept;
}

}  // namespace polyturn::toolmgmt
