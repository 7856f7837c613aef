// How a store is opened: what was acknowledged is compared with what is there, and what a killed
// predecessor wrote is brought to the disk, before anything is read.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "toolmgmt/database_parts.hpp"
#include "toolmgmt/durability/inspect.hpp"
#include "toolmgmt/schema.hpp"

namespace polyturn::toolmgmt {
namespace fs = std::filesystem;
namespace {

// One owner: with an exclusive lock no other process can write, and the log needs no shared memory
// of its own. The log is folded in by Parts::fold() only, which writes the sums of the pages first.
constexpr const char* kSettings =
    "PRAGMA locking_mode=EXCLUSIVE; PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA "
    "wal_autocheckpoint=0; PRAGMA trusted_schema=OFF;";

// Enough for decades of an operator's entries; bounded, because measuring programs write offsets at
// every part.
constexpr const char* kPrune =
    "DELETE FROM history WHERE id <= (SELECT max(id) FROM history) - 1000000";

// A predecessor that was just killed may still be going away.
bool take_lock(const std::string& folder, OpenFile& out) {
    out = OpenFile(
        ::open((folder + "/store.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!out) return true;  // a folder that cannot be written has its own message
    for (int ms = 0; ms < 2000; ms += 10) {
        if (::flock(out.get(), LOCK_EX | LOCK_NB) == 0) return true;
        // a file system without locks: SQLite's own remains
        if (errno != EWOULDBLOCK && errno != EINTR) return true;
        ::usleep(10'000);
    }
    return false;
}

// SQLite makes its files with the umask's rights: the main file is there before, and the log takes
// its rights.
void make_private(const std::string& path, const std::string& folder) {
    const OpenFile file(
        ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (file) (void)::fchmod(file.get(), private_mode(folder));
}

int count_frames(void* to, sqlite3*, const char*, int frames) {
    *static_cast<int*>(to) = frames;
    return SQLITE_OK;
}

bool connect(sqlite3*& db, const std::string& path) {
    if (sqlite3_open_v2(path.c_str(), &db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) !=
        SQLITE_OK)
        return false;
    sqlite3_extended_result_codes(db, 1);
    sqlite3_busy_timeout(db, 2000);
    sqlite3_db_config(db, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    return true;
}

// The content of a damaged store so far as SQLite can read it, in memory; the files themselves are
// not touched.
bool copy_of_damaged(const std::string& folder, const std::string& path, sqlite3* memory) {
    const fs::path look = fs::path(folder) / "store.look";
    std::error_code none;
    fs::remove_all(look, none);
    if (!fs::create_directory(look, none)) return false;
    fs::permissions(look, fs::perms::owner_all, none);
    bool good = fs::copy_file(path, look / Database::kFile, none);
    if (good && fs::exists(path + "-wal"))
        fs::copy_file(path + "-wal", (look / Database::kFile).string() + "-wal", none);
    sqlite3* db = nullptr;
    std::string what;
    // memory has no log
    if (good)
        good = connect(db, (look / Database::kFile).string()) &&
               run(db, "PRAGMA trusted_schema=OFF; PRAGMA journal_mode=DELETE;");
    const int version = good ? schema_version(db) : 0;
    good = good && version > 0 && version <= newest_schema_version() && intact(db, version, what);
    if (good) {
        sqlite3_backup* copy = sqlite3_backup_init(memory, "main", db, "main");
        if (copy) sqlite3_backup_step(copy, -1);
        good = copy && sqlite3_backup_finish(copy) == SQLITE_OK;
    }
    sqlite3_close_v2(db);
    fs::remove_all(look, none);
    return good;
}

}  // namespace

std::uint64_t random_number() {
    std::uint64_t out = 0;
    if (getrandom(&out, sizeof out, 0) != sizeof out)
        out =
            static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
    return out | 1;  // never 0
}

bool any_users(sqlite3* db) {
    Statement one(db, "SELECT 1 FROM records WHERE kind = 'user' LIMIT 1");
    return one.row();
}

std::uint64_t digest_of_users(sqlite3* db) {
    std::string all;
    // Failed log-ins are no rights.
    Statement rows(
        db,
        "SELECT number, field, value, text FROM records WHERE kind = 'user' AND field NOT IN "
        "('failures', 'locked_until') ORDER BY number, field");
    while (rows.row())
        all += std::to_string(rows.whole(0)) + "\t" + rows.text(1) + "\t" +
               std::to_string(rows.number(2)) + "\t" + rows.text(3) + "\n";
    return check_sum(all, 1) | 1;
}

bool Database::Parts::read_acknowledged(bool& had_users) {
    Statement row(db, "SELECT store, commits, users FROM promise WHERE id = 1");
    if (!row.row()) return false;
    store = static_cast<std::uint64_t>(row.whole(0));
    commits = static_cast<std::uint64_t>(row.whole(1));
    had_users = row.whole(2) != 0;
    return true;
}

Result<void> Database::Parts::seal(Transaction& transaction, bool users_changed) {
    if (condition.broken)
        return Diagnosis{Alarm::StoreUnfit,
                         {path, 0, 0, 0},
                         {},
                         condition.unfit ? condition.unfit->text() : path};
    if (!witness)
        return transaction.commit() ? Result<void>() : Result<void>(fault(Alarm::StoreWrite));
    Witness next = witness->now();
    next.store = store;
    next.commits = commits + 1;
    next.stamp = random_number();
    if (users_changed) next.users = digest_of_users(db);
    Statement row(db, "UPDATE promise SET commits = ?, stamp = ?, users = users OR ? WHERE id = 1");
    row.bind(1, static_cast<std::int64_t>(next.commits))
        .bind(2, static_cast<std::int64_t>(next.stamp))
        .bind(3, std::int64_t{users_changed});
    if (!row.run() || !transaction.commit()) return fault(Alarm::StoreWrite);
    commits = next.commits;
    // The change is on disk. A witness that cannot be written would only not notice its loss.
    if (!witness->write(next) && !std::exchange(told, true))
        std::fprintf(stderr, "polyturn-toolmgmt: %s/%s cannot be written: %s\n", folder.c_str(),
                     WitnessFile::kName, std::strerror(errno));
    if (users_changed) condition.had_users = true;
    if (log_frames >= kFoldAt) (void)fold();  // not possible now: later
    return {};
}

Result<void> Database::Parts::fold() {
    if (!folds || condition.broken) return {};
    const std::string log = path + "-wal";
    if (!sync_file(log)) return {};  // there is none
    const LogPages pages = read_log(log);
    if (pages.pages == 0) return {};
    PageSums next = sums;
    next.store = store;
    next.fold(pages);
    if (!next.write(folder))
        return Diagnosis{Alarm::StoreWrite,
                         {path, 0, 0, 0},
                         {},
                         folder + "/" + PageSums::kName + ": " + std::strerror(errno)};
    sums = std::move(next);
    if (sqlite3_wal_checkpoint_v2(db, nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr) !=
        SQLITE_OK)
        return fault(Alarm::StoreWrite);
    log_frames = 0;
    return {};
}

Result<void> Database::Parts::begin_acknowledging() {
    if (!sync_file(path) || (fs::exists(path + "-wal") && !sync_file(path + "-wal")))
        return fault(Alarm::StoreOpen);
    if (sqlite3_wal_checkpoint_v2(db, nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr) !=
        SQLITE_OK)
        return open_fault();
    // Through SQLite's own handle: whoever opens and closes the file a second time loses its locks.
    sqlite3_file* file = nullptr;
    sqlite3_int64 size = 0;
    if (sqlite3_file_control(db, "main", SQLITE_FCNTL_FILE_POINTER, &file) != SQLITE_OK || !file ||
        !file->pMethods || file->pMethods->xFileSize(file, &size) != SQLITE_OK)
        return open_fault();
    std::string main(static_cast<std::size_t>(size), '\0');
    for (std::size_t at = 0; at < main.size(); at += 1u << 20)
        if (file->pMethods->xRead(
                file, main.data() + at,
                static_cast<int>(std::min<std::size_t>(1u << 20, main.size() - at)),
                static_cast<sqlite3_int64>(at)) != SQLITE_OK)
            return open_fault();
    Statement page(db, "PRAGMA page_size");
    if (!page.row()) return open_fault();
    sums.take(main, static_cast<std::uint32_t>(page.whole(0)));
    sums.store = store;
    Witness first;
    first.store = store;
    first.commits = commits;
    if (any_users(db)) first.users = digest_of_users(db);
    if (!sums.write(folder) || !witness->write(first))
        return Diagnosis{
            Alarm::StoreOpen, {path, 0, 0, 0}, {}, folder + ": " + std::strerror(errno)};
    folds = true;
    return {};
}

// From now on the file and the witness agree again about what is there; what is wrong stays said
// until somebody confirms it.
Result<void> Database::Parts::note_unfit() {
    Witness next = witness->now();
    const std::uint64_t users = next.users;
    next.store = store;
    next.commits = std::max(next.commits, commits) + 1;
    next.stamp = random_number();
    next.unfit = condition.unfit ? 1 : 0;
    next.why.fill(0);
    if (condition.unfit)
        std::strncpy(next.why.data(), condition.unfit->detail.c_str(), next.why.size() - 1);
    next.users = condition.locked      ? users
                 : any_users(db)       ? digest_of_users(db)
                 : condition.had_users ? (users ? users : 1)
                                       : 0;
    Transaction transaction(db);
    Statement row(
        db,
        "INSERT OR REPLACE INTO promise(id, store, commits, stamp, users) VALUES(1, ?, ?, ?, ?)");
    row.bind(1, static_cast<std::int64_t>(next.store))
        .bind(2, static_cast<std::int64_t>(next.commits))
        .bind(3, static_cast<std::int64_t>(next.stamp))
        .bind(4, std::int64_t{condition.had_users});
    if (!transaction.begun() || !row.run() || !transaction.commit())
        return fault(Alarm::StoreWrite);
    commits = next.commits;
    if (!witness->write(next))
        return Diagnosis{Alarm::StoreWrite,
                         {path, 0, 0, 0},
                         {},
                         folder + "/" + WitnessFile::kName + ": " + std::strerror(errno)};
    return {};
}

Result<Database> Database::open(const std::string& folder) {
    auto parts = std::make_unique<Parts>();
    parts->folder = folder;
    parts->path = (fs::path(folder) / kFile).string();
    if (const std::string wrong = make_folder(folder); !wrong.empty())
        return Diagnosis{Alarm::StoreOpen, {folder, 0, 0, 0}, {}, wrong};
    if (!take_lock(folder, parts->lock))
        return Diagnosis{Alarm::StoreBusy, {parts->path, 0, 0, 0}, {}, folder};
    tighten(folder);
    Inspection found = inspect(folder, parts->path);
    const auto newer = [&](int version) {
        return Diagnosis{Alarm::StoreVersion,
                         {parts->path, 0, 0, 0},
                         {},
                         "schema " + std::to_string(version) + ", known up to " +
                             std::to_string(newest_schema_version())};
    };
    if (found.version > static_cast<std::uint32_t>(newest_schema_version()))
        return newer(static_cast<int>(found.version));
    const bool witnessed = found.witness == WitnessFile::State::Good;
    Condition& condition = parts->condition;
    if (found.damage) {
        condition.broken = true;
        condition.unfit = std::move(found.damage);
        if (!connect(parts->db, ":memory:")) return parts->open_fault();
        const bool readable = copy_of_damaged(folder, parts->path, parts->db);
        if (!migrate(parts->db)) return parts->open_fault();
        condition.had_users = !witnessed || found.acknowledged.users != 0;
        condition.locked =
            !witnessed || (found.acknowledged.users != 0 &&
                           !(readable && digest_of_users(parts->db) == found.acknowledged.users));
        return Database(std::move(parts));
    }
    // What a killed predecessor wrote, and no fsync has covered yet, is on the disk before it is
    // read.
    if (fs::exists(parts->path + "-wal") && !sync_file(parts->path + "-wal"))
        return Diagnosis{Alarm::StoreOpen, {parts->path, 0, 0, 0}, {}, std::strerror(errno)};
    sync_folder(folder);
    make_private(parts->path, folder);
    if (!connect(parts->db, parts->path) || !run(parts->db, kSettings)) return parts->open_fault();
    const int version = schema_version(parts->db);
    if (version < 0) return parts->open_fault();
    if (version > newest_schema_version()) return newer(version);
    std::string what;
    if (version > 0 && !intact(parts->db, version, what))
        return what.empty() ? parts->open_fault()
                            : Diagnosis{Alarm::StoreDamaged, {parts->path, 0, 0, 0}, {}, what};
    // Also an up-to-date file takes the write lock here, so that a second owner is refused at once.
    bool acknowledged = version >= kAcknowledges;
    if (!migrate(parts->db) || !run(parts->db, kPrune)) return parts->open_fault();
    parts->sums = std::move(found.sums);
    parts->witness.emplace(folder);
    (void)parts->witness->read();
    sqlite3_wal_hook(parts->db, count_frames, &parts->log_frames);
    if (!parts->read_acknowledged(condition.had_users)) {
        acknowledged = false;
        parts->store = witnessed ? found.acknowledged.store : random_number();
    }
    condition.had_users =
        condition.had_users || (witnessed && found.acknowledged.users != 0) || any_users(parts->db);
    const auto lost = [&](std::string why) {
        condition.unfit = Diagnosis{Alarm::StoreLost, {parts->path, 0, 0, 0}, {}, std::move(why)};
    };
    if (!witnessed) {
        if (found.witness == WitnessFile::State::Damaged)
            lost(std::string(WitnessFile::kName) + " is damaged");
        else if (acknowledged && parts->commits > 0)
            lost(std::string(WitnessFile::kName) + " is missing");
    } else if (found.acknowledged.unfit) {
        lost(found.acknowledged.why.data());
    } else if (!acknowledged || parts->store != found.acknowledged.store) {
        lost(std::string(kFile) + " is not the file that this store had");
    } else if (parts->commits < found.acknowledged.commits) {
        lost(std::to_string(found.acknowledged.commits - parts->commits) + " of " +
             std::to_string(found.acknowledged.commits) + " changes are missing at the end of " +
             kFile + "-wal");
    } else if (parts->commits == found.acknowledged.commits) {
        Statement row(parts->db, "SELECT stamp FROM promise WHERE id = 1");
        if (!row.row() || static_cast<std::uint64_t>(row.whole(0)) != found.acknowledged.stamp)
            lost(std::string(kFile) +
                 " ends with another change than the one that was acknowledged");
    }
    if (condition.unfit) {
        condition.locked = witnessed ? found.acknowledged.users != 0 &&
                                           digest_of_users(parts->db) != found.acknowledged.users
                                     : condition.had_users && !any_users(parts->db);
        if (witnessed) parts->store = found.acknowledged.store;
    }
    // A new store, one of a version without acknowledgements, one that was killed between its first
    // sums and its first witness.
    parts->folds = found.sums_state == PageSums::State::Good;
    if (!parts->folds || (found.witness == WitnessFile::State::Missing && !condition.unfit))
        if (Result<void> begun = parts->begin_acknowledging(); !begun) return begun.diagnosis();
    if (condition.unfit && !(witnessed && found.acknowledged.unfit))
        if (Result<void> noted = parts->note_unfit(); !noted) return noted.diagnosis();
    // on the disk it is, in the log
    if (Result<void> folded = parts->fold(); !folded)
        std::fprintf(stderr, "polyturn-toolmgmt: %s\n", folded.diagnosis().text().c_str());
    return Database(std::move(parts));
}

const Database::Condition& Database::condition() const { return parts_->condition; }

Result<void> Database::fold() { return parts_->fold(); }
bool Database::anything_to_fold() const { return parts_->log_frames > 0; }

Result<void> Database::confirm() {
    if (!parts_->condition.unfit) return {};
    if (parts_->condition.broken) {
        const std::string folder = parts_->folder, fresh = parts_->path + ".new";
        std::error_code none;
        fs::remove(fresh, none);
        make_private(fresh, folder);
        Statement copy(parts_->db, "VACUUM main INTO ?");
        if (!copy.bind(1, fresh).run()) return parts_->fault(Alarm::StoreWrite);
        if (const auto kept = install(folder, fresh); !kept) return kept.diagnosis();
        parts_->lock = {};
        Result<Database> again = open(folder);
        if (!again) return again.diagnosis();
        parts_ = std::move(again->parts_);
        return {};
    }
    parts_->condition.unfit.reset();
    parts_->condition.locked = false;
    return parts_->note_unfit();
}

}  // namespace polyturn::toolmgmt
