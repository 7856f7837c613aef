// A store that was damaged, cut or robbed of a file says so at its start: no production, and nobody
// has more rights than before.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "ipc/image/store_changes.hpp"
#include "store_rig.hpp"
#include "tests/places.hpp"
#include "tests/seeds.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/durability/page_sums.hpp"
#include "toolmgmt/durability/witness.hpp"

namespace {

using namespace polyturn;
using polyturn::test::StoreRig;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string kMachine = std::string(kSourceFolder) + "/examples/machines/twin-turret";

Json operate(StoreRig& rig, const Json& operation, UserLevel level = UserLevel::Maker) {
    const std::string text = operation.dump();
    constexpr std::size_t kPiece = sizeof(StoreRequest{}.name) - 1;
    std::uint64_t last = 0;
    for (std::size_t at = 0; at < text.size(); at += kPiece) {
        StoreRequest request =
            store_request(StoreRequestKind::Operation, 0, static_cast<std::int32_t>(at),
                          at + kPiece < text.size() ? kMoreFollows : 0, 0);
        request.level = static_cast<std::uint32_t>(level);
        put_name(request, std::string_view(text).substr(at, kPiece));
        last = rig.send(request);
    }
    std::string answer;
    for (int i = 0; i < 100'000 && !rig.ended(); ++i, usleep(100))
        while (const auto piece = rig.take_answer())
            if (piece->id == last && (answer += piece->text.data(), !piece->more))
                return Json::parse(answer, nullptr, false);
    return {};
}

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}
void put(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

// One bit of a page that the log does not bring anew.
void flip_one_bit(const std::string& folder) {
    const toolmgmt::LogPages log = toolmgmt::read_log(folder + "/store.sqlite-wal");
    std::string bytes = content(folder + "/store.sqlite");
    std::uint32_t page = static_cast<std::uint32_t>(bytes.size() / 4096);
    while (page > 1 && log.sums.contains(page)) --page;
    char& one = bytes[page * 4096u - 3];
    one = static_cast<char>(one ^ 4);
    put(folder + "/store.sqlite", bytes);
}

// A store with a maker, a setter and some offsets, killed: its log holds the newest of it.
class DamagedStore : public ::testing::Test {
protected:
    DamagedStore()
        : rig("damage"),
          folder(rig.folder + "/store"),
          whole(rig.folder + "/whole"),
          arguments{"--store", folder, "--machine", kMachine} {
        EXPECT_TRUE(rig.start(arguments)) << rig.messages();
        EXPECT_TRUE(operate(rig, {{"do", "users.add"},
                                  {"name", "boss"},
                                  {"level", "maker"},
                                  {"password", "topsecret"}})
                        .value("ok", false));
        EXPECT_TRUE(operate(rig, {{"do", "users.add"},
                                  {"name", "anna"},
                                  {"level", "operator"},
                                  {"password", "secret1"}})
                        .value("ok", false));
        EXPECT_EQ(rig.stop(), 0);  // the log is folded in
        EXPECT_TRUE(rig.start(arguments)) << rig.messages();
        for (int n = 1; n <= 6; ++n)
            EXPECT_TRUE(operate(rig, {{"do", "offsets.set"},
                                      {"channel", 1},
                                      {"number", n},
                                      {"table", "geometry"},
                                      {"field", "X"},
                                      {"value", n * 1.5}})
                            .value("ok", false));
        rig.kill_now();
        fs::copy(folder, whole, fs::copy_options::recursive);
    }
    void mend() {
        rig.kill_now();
        fs::remove_all(folder);
        fs::copy(whole, folder, fs::copy_options::recursive);
        rig.supervisor->requests.head = 0;
        rig.supervisor->answer_tail.tail = 0;
        remove_instance_but_supervisor();
    }
    void remove_instance_but_supervisor() {
        rig.store.reset();
        rig.supervisor->header.generation += 1;
    }
    // Started, said, no production, and somebody must log in.
    void expect_found(const std::string& what) {
        SCOPED_TRACE(what);
        ASSERT_TRUE(rig.start(arguments)) << rig.messages();
        const bool said = rig.messages().find("PT0401") != std::string::npos ||
                          rig.messages().find("PT0407") != std::string::npos;
        EXPECT_TRUE(said) << rig.messages();
        ASSERT_GE((*rig.store)->tool_answers.head.load(), 1u);
        EXPECT_EQ((*rig.store)->tool_answers.slot(0).alarm, kStoreUnfit);
        auto users = std::make_unique<UserTable>();
        ASSERT_TRUE((*rig.store)->users.read(*users));
        EXPECT_GE(users->count, 1u) << "an empty table makes everybody a maker";
        for (std::size_t i = 0; i < users->count; ++i)
            if (std::string(users->rows[i].name.data()) == "anna") {
                EXPECT_EQ(users->rows[i].level, 1u);
            }
        const auto state = operate(rig, {{"do", "store.state"}}, UserLevel::None);
        EXPECT_TRUE(state.value("unfit", false)) << state.dump();
        EXPECT_FALSE(state.value("missing", "").empty());
    }
    StoreRig rig;
    std::string folder, whole;
    std::vector<std::string> arguments;
};

TEST_F(DamagedStore, IsStartedWithoutAWordWhenNothingIsWrong) {
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_EQ(rig.messages(), "");
    EXPECT_EQ((*rig.store)->tool_answers.head.load(), 0u);
    EXPECT_EQ(rig.channel(1)->offsets[6].geometry[0], 9.0);
}

TEST_F(DamagedStore, SaysThatTheLogIsGoneCutOrDamaged) {
    const fs::path log = folder + "/store.sqlite-wal";
    const std::string bytes = content(log);
    ASSERT_GT(bytes.size(), 5 * 4096u);
    fs::remove(log);
    expect_found("log deleted");
    for (std::size_t size = 0; size + 1 < bytes.size(); size += 4096 + 24) {
        mend();
        put(log, bytes.substr(0, size));
        expect_found("log cut at " + std::to_string(size));
    }
    for (std::size_t bit = 5; bit < bytes.size() * 8; bit += bytes.size() / 3 * 8 + 11) {
        mend();
        std::string flipped = bytes;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
        put(log, flipped);
        expect_found("log, bit " + std::to_string(bit));
    }
}

TEST_F(DamagedStore, SaysThatTheMainFileIsGoneEmptyCutOrDamaged) {
    const fs::path main = folder + "/store.sqlite";
    const std::string bytes = content(main);
    fs::remove(main);
    expect_found("main file deleted");
    for (std::size_t size = 0; size < bytes.size(); size += 4096 * 5) {
        mend();
        put(main, bytes.substr(0, size));
        expect_found("main file cut at " + std::to_string(size));
    }
    mend();
    flip_one_bit(folder);
    expect_found("one bit of a page");
    mend();
    fs::remove(main);
    fs::remove(main.string() + "-wal");
    expect_found("both deleted");
}

TEST_F(DamagedStore, SaysThatWitnessOrSumsAreGone) {
    for (const char* name : {toolmgmt::WitnessFile::kName, toolmgmt::PageSums::kName}) {
        fs::remove(folder + "/" + name);
        expect_found(std::string(name) + " deleted");
        mend();
    }
}

// Every bit of log and main file in turn, by what judges them at the start.
TEST_F(DamagedStore, IsFoundWhicheverBitIsFlipped) {
    const std::string main = content(folder + "/store.sqlite"),
                      log = content(folder + "/store.sqlite-wal");
    toolmgmt::PageSums sums;
    ASSERT_EQ(sums.read(folder), toolmgmt::PageSums::State::Good);
    const toolmgmt::LogPages none;
    EXPECT_EQ(sums.damaged(main, none), 0u);
    std::string page;
    for (std::uint32_t number = 1; number <= sums.sums.size(); ++number) {
        page = main.substr((number - 1) * 4096u, 4096);
        for (std::size_t bit = 0; bit < page.size() * 8; ++bit) {
            page[bit / 8] = static_cast<char>(page[bit / 8] ^ (1 << bit % 8));
            if (toolmgmt::page_sum(number, page) == sums.sums[number - 1])
                FAIL() << "page " << number << " bit " << bit;
            page[bit / 8] = static_cast<char>(page[bit / 8] ^ (1 << bit % 8));
        }
    }
    // The log through the whole of it: opened, and its commits compared with the witness.
    std::mt19937 random(test_seed(7));
    for (int i = 0; i < 150; ++i) {
        const std::string copy = rig.folder + "/copy";
        fs::remove_all(copy);
        fs::copy(folder, copy, fs::copy_options::recursive);
        std::string flipped = log;
        const std::size_t bit =
            i < 32 * 8 && i % 3 == 0 ? static_cast<std::size_t>(i) : random() % (log.size() * 8);
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
        put(copy + "/store.sqlite-wal", flipped);
        auto store = toolmgmt::Database::open(copy);
        ASSERT_TRUE(store) << store.diagnosis().text();
        if (!store->condition().unfit) {  // nothing hangs on it: all is there
            auto values = std::make_unique<toolmgmt::StoreValues>();
            toolmgmt::clear(*values);
            std::vector<Diagnosis> warnings;
            ASSERT_TRUE(store->read_into(*values, warnings));
            for (int n = 1; n <= 6; ++n)
                EXPECT_EQ(values->channels[0].offsets[static_cast<std::size_t>(n)].geometry[0],
                          n * 1.5)
                    << "bit " << bit;
        }
    }
}

// What is missing is confirmed once, and a damaged main file becomes one that keeps again.
TEST_F(DamagedStore, WorksAgainOnceAMakerHasConfirmed) {
    fs::remove(folder + "/store.sqlite-wal");
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_FALSE(operate(rig, {{"do", "store.confirm"}}, UserLevel::Setter).value("ok", true));
    EXPECT_TRUE(operate(rig, {{"do", "store.confirm"}}).value("ok", false));
    EXPECT_FALSE(operate(rig, {{"do", "store.state"}}).value("unfit", true));
    rig.kill_now();
    remove_instance_but_supervisor();
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_EQ(rig.messages(), "");
    mend();
    flip_one_bit(folder);
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_FALSE(operate(rig, {{"do", "offsets.set"},
                               {"channel", 1},
                               {"number", 1},
                               {"table", "geometry"},
                               {"field", "X"},
                               {"value", 3}})
                     .value("ok", true))
        << "nothing is kept in a damaged file";
    EXPECT_TRUE(operate(rig, {{"do", "store.confirm"}}).value("ok", false));
    EXPECT_TRUE(operate(rig, {{"do", "offsets.set"},
                              {"channel", 1},
                              {"number", 1},
                              {"table", "geometry"},
                              {"field", "X"},
                              {"value", 3}})
                    .value("ok", false));
    rig.kill_now();
    remove_instance_but_supervisor();
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_EQ(rig.messages(), "");
    EXPECT_EQ(rig.channel(1)->offsets[1].geometry[0], 3);
}

TEST_F(DamagedStore, NeverComesBackToNoUsersYet) {
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_TRUE(operate(rig, {{"do", "users.delete"}, {"name", "anna"}}).value("ok", false));
    EXPECT_FALSE(operate(rig, {{"do", "users.delete"}, {"name", "boss"}}).value("ok", true));
}

// 0600, whatever the umask is; what lay open is closed at the start.
TEST(StoreFiles, AreTheirOwnersOnly) {
    StoreRig rig("modes");
    const std::string folder = rig.folder + "/store";
    const mode_t before = umask(0);
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine})) << rig.messages();
    umask(before);
    ASSERT_EQ(rig.ask(parameter_request("N1600 L1=2.5"))->ok, 1u);
    ASSERT_TRUE(operate(rig, {{"do", "backup.to"},
                              {"file", folder + "/backups/hand.ptb"},
                              {"make_folder", true}})
                    .value("ok", false));
    const auto all_private = [&] {
        int files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            ++files;
            EXPECT_EQ(static_cast<unsigned>(entry.status().permissions()) & 077u, 0u)
                << entry.path();
        }
        return files;
    };
    EXPECT_GE(all_private(), 5);
    rig.kill_now();
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) fs::permissions(entry.path(), fs::perms(0644));
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine})) << rig.messages();
    all_private();
}

// The log does not lie there for days.
TEST(StoreFiles, FoldTheLogInWhenNobodyWantsAnything) {
    StoreRig rig("idle");
    const std::string folder = rig.folder + "/store";
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine})) << rig.messages();
    ASSERT_EQ(rig.ask(parameter_request("N1600 L1=2.5"))->ok, 1u);
    EXPECT_GT(fs::file_size(folder + "/store.sqlite-wal"), 0u);
    bool folded = false;
    for (int i = 0; i < 3000 && !folded; ++i, usleep(10'000))
        folded = fs::file_size(folder + "/store.sqlite-wal") == 0;
    EXPECT_TRUE(folded);
}

// What a backup names is judged before anything is written: nothing leaves the machine's folder,
// native code is asked for.
TEST(Restore, WritesOnlyWhatABackupOfThisProductHolds) {
    StoreRig rig("foreign-backup");
    const std::string machine = rig.folder + "/machine", outside = rig.folder + "/outside";
    fs::copy(kMachine, machine, fs::copy_options::recursive);
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", machine}))
        << rig.messages();
    const std::string good = rig.folder + "/good.ptb";
    ASSERT_TRUE(operate(rig, {{"do", "backup.to"}, {"file", good}}).value("ok", false));
    const auto spoil = [&](const std::string& sql) {
        const std::string file = rig.folder + "/bad.ptb";
        fs::copy_file(good, file, fs::copy_options::overwrite_existing);
        sqlite3* db = nullptr;
        EXPECT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sql << sqlite3_errmsg(db);
        sqlite3_close(db);
        return operate(rig, {{"do", "restore.from"}, {"file", file}});
    };
    const auto file = [](const std::string& name, const std::string& path,
                         const std::string& bytes) {
        return "INSERT INTO backup_files VALUES('" + name + "','" + path + "',CAST('" + bytes +
               "' AS BLOB))";
    };
    for (const std::string& name :
         {std::string("evil"), std::string("machine/../../outside"),
          std::string("machine//outside"), std::string("machine/.hidden"), std::string("/etc/x"),
          std::string("machine/a/../../../outside")}) {
        const Json told = spoil(file(name, outside, "x"));
        EXPECT_EQ(told.value("number", ""), "PT0441") << name << told.dump();
    }
    EXPECT_EQ(spoil(file("machine/more.params", outside, "N99999 = what")).value("number", ""),
              "PT0441");
    EXPECT_EQ(spoil(file("machine/more.toml", outside, "a = [")).value("number", ""), "PT0441");
    EXPECT_EQ(spoil("CREATE VIEW v AS SELECT 1").value("number", ""), "PT0441");
    EXPECT_EQ(spoil("CREATE TRIGGER t AFTER INSERT ON history BEGIN DELETE FROM records; END")
                  .value("number", ""),
              "PT0441");
    EXPECT_EQ(spoil(file("machine/plc.so", outside, "x")).value("number", ""), "PT0442");
    EXPECT_FALSE(fs::exists(machine + "/plc.so"));
    fs::create_directory(rig.folder + "/elsewhere");
    fs::create_directory_symlink(rig.folder + "/elsewhere", machine + "/link");
    EXPECT_FALSE(spoil(file("machine/link/x.txt", outside, "x")).value("ok", true));
    EXPECT_TRUE(fs::is_empty(rig.folder + "/elsewhere"));
    EXPECT_TRUE(spoil(file("program/part.nc", outside, "M30")).value("ok", false));
    EXPECT_EQ(content(machine + "/programs/part.nc"), "M30");
    EXPECT_FALSE(fs::exists(outside)) << "the path that the backup names is not the place";
    EXPECT_TRUE(operate(rig, {{"do", "restore.from"}, {"file", good}}).value("ok", false));
    // Spoilt at random: refused or read, never a death.
    std::mt19937 random(test_seed(3));
    const std::string bytes = content(good);
    for (int i = 0; i < 60; ++i) {
        std::string spoilt = bytes.substr(0, i % 4 ? bytes.size() : random() % bytes.size());
        for (int k = 0; k < 40 && !spoilt.empty(); ++k)
            spoilt[random() % spoilt.size()] = static_cast<char>(random());
        put(rig.folder + "/bad.ptb", spoilt);
        const Json told = operate(
            rig, {{"do", "restore.from"}, {"file", rig.folder + "/bad.ptb"}, {"preview", true}});
        ASSERT_TRUE(told.is_object()) << i << rig.messages();
    }
    EXPECT_FALSE(rig.ended());
}

TEST(StoreRequests, ThatAreNoneAreRefusedAndTheStoreLives) {
    StoreRig rig("hostile");
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", kMachine}))
        << rig.messages();
    const auto pid = rig.pid;
    const Json one = Json::array({1});
    std::vector<Json> hostile = {
        {{"do", "tools.list"}, {"preview", "x"}},
        {{"do", "tools.list"}, {"preview", 1}},
        {{"do", one}},
        {{"do", "offsets.set"},
         {"incremental", "x"},
         {"channel", 1},
         {"number", 1},
         {"field", "X"},
         {"value", 1}},
        {{"do", "zeros.set"}, {"incremental", one}, {"channel", 1}, {"field", "X"}, {"value", 1}},
        {{"do", "tools.add"}, {"fields", one}},
        {{"do", "parts.add"}, {"fields", "x"}},
        {{"do", "pallets.set"}, {"row", 1}, {"fields", one}},
        {{"do", "backup.to"}, {"file", rig.folder + "/b.ptb"}, {"make_folder", "x"}},
        {{"do", "restore.from"}, {"file", one}, {"with_plc", 3}},
        {{"do", "offsets.set"},
         {"channel", "9999999999999999999"},
         {"number", 1},
         {"field", "X"},
         {"value", 1}},
        {{"do", "offsets.list"}, {"channel", Json::object()}},
        {{"do", "history.list"}, {"most", "x"}},
        {{"do", "users.login"}, {"name", one}, {"password", one}},
        {{"do", "life.reset"}, {"tools", Json::array({one, "x", 99999999999})}},
        {{"do", "compensation.set"}, {"cells", Json::array({one})}},
        {{"do", "alarms.note"}, {"events", Json::array({1, "x", one})}},
        {{"do", "stops.note"}, {"utc", 5}, {"channel", one}},
        {{"do", "tools.import"}, {"text", one}}};
    for (const Json& request : hostile) {
        const Json told = operate(rig, request);
        ASSERT_TRUE(told.is_object()) << request.dump() << " " << rig.messages();
        EXPECT_FALSE(told.value("ok", true)) << request.dump() << told.dump();
    }
    std::string nested =
        R"({"do":"tools.list","x":)" + std::string(20'000, '[') + std::string(20'000, ']') + "}";
    constexpr std::size_t kPiece = sizeof(StoreRequest{}.name) - 1;
    std::uint64_t last = 0;
    for (std::size_t at = 0; at < nested.size(); at += kPiece) {
        StoreRequest request =
            store_request(StoreRequestKind::Operation, 0, static_cast<std::int32_t>(at),
                          at + kPiece < nested.size() ? kMoreFollows : 0, 0);
        put_name(request, std::string_view(nested).substr(at, kPiece));
        while (rig.supervisor->requests.head - (*rig.store)->request_tail.tail >= 250) usleep(100);
        last = rig.send(request);
    }
    std::string answer;
    for (int i = 0; i < 100'000 && answer.empty() && !rig.ended(); ++i, usleep(100))
        while (const auto piece = rig.take_answer())
            if (piece->id == last) answer += piece->text.data();
    EXPECT_NE(answer.find("PT0013"), std::string::npos) << answer;
    EXPECT_FALSE(rig.ended());
    EXPECT_EQ(rig.pid, pid);
}

// The store dies in the middle of an operation, by whatever: its successor finds it begun, does not
// read it again, says so to whoever waits, and serves the next one. A hash of a password takes long
// enough to be met at work.
TEST(StoreRequests, OneThatKilledItsReaderIsNotReadAgain) {
    StoreRig rig("killer");
    const std::vector<std::string> arguments{"--store", rig.folder + "/store", "--machine",
                                             kMachine};
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    int refused = 0;
    for (int round = 0; round < 6; ++round) {
        const std::string name = "user" + std::to_string(round);
        StoreRequest request = store_request(StoreRequestKind::Operation, 0, 0, 0, 0);
        request.level = static_cast<std::uint32_t>(UserLevel::Maker);
        put_name(
            request,
            Json{{"do", "users.add"}, {"name", name}, {"level", "maker"}, {"password", "secret1"}}
                .dump());
        const auto& answers = (*rig.store)->answers;
        const auto head = answers.head.load();
        const auto id = rig.send(request);
        const volatile auto& begun = answers.slot(head).id;  // where it says what it works on
        while (begun != id && answers.head.load() == head) {}
        usleep(static_cast<useconds_t>(round) * 4000);
        rig.kill_now();
        const bool told_before = answers.head.load() != head;
        ASSERT_TRUE(rig.start(arguments)) << rig.messages();
        std::string answer;
        for (int i = 0; i < 100'000 && answer.empty() && !rig.ended(); ++i, usleep(100))
            while (const auto piece = rig.take_answer())
                if (piece->id == id) answer += piece->text.data();
        const Json told = Json::parse(answer, nullptr, false);
        ASSERT_TRUE(told.is_object()) << round << " " << answer << rig.messages();
        // Nothing of it or all of it; and what was not done is said.
        const Json users = operate(rig, {{"do", "users.list"}});
        ASSERT_TRUE(users.value("ok", false)) << "it goes on: " << rig.messages();
        const bool there = users.dump().find('"' + name + '"') != std::string::npos;
        EXPECT_EQ(there, told.value("ok", false)) << told.dump() << users.dump();
        if (told_before || there) continue;
        ++refused;
        EXPECT_EQ(told.value("number", ""), "PT0335") << told.dump();
        EXPECT_NE(told.value("text", "").find("not read again"), std::string::npos) << told.dump();
    }
    EXPECT_GE(refused, 1) << "it was never met at work";
}

}  // namespace
