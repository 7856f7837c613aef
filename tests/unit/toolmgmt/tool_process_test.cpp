// Tools in the real store process: operations in pieces, T calls, life over kills, backups,
// schemas.
#include <sqlite3.h>
#include <sys/mman.h>

#include <nlohmann/json.hpp>
#include <random>

#include "store_rig.hpp"
#include "tests/places.hpp"
#include "tests/seeds.hpp"
#include "toolmgmt/schema.hpp"

namespace {

using namespace polyturn;
using polyturn::test::StoreRig;
using Json = nlohmann::json;

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
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < until) {
        const auto piece = rig.take_answer();
        if (!piece) {
            usleep(100);
            continue;
        }
        if (piece->id != last) continue;
        answer += piece->text.data();
        if (!piece->more) return Json::parse(answer, nullptr, false);
    }
    return {};
}

Json add_tool(StoreRig& rig, const Json& fields, int pot) {
    const Json added = operate(rig, {{"do", "tools.add"}, {"fields", fields}});
    EXPECT_TRUE(added.value("ok", false)) << added.dump();
    const Json loaded = operate(
        rig,
        {{"do", "tools.load"}, {"tool", added.value("tool", 0)}, {"magazine", 1}, {"pot", pot}});
    EXPECT_TRUE(loaded.value("ok", false)) << loaded.dump();
    return added;
}

std::unique_ptr<ToolTable> tools_of(StoreRig& rig) {
    auto out = std::make_unique<ToolTable>();
    EXPECT_TRUE((*rig.store)->tools.read(*out));
    return out;
}

TEST(ToolOperations, AreAnsweredInPiecesAndShownInTheImage) {
    StoreRig rig("tools");
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    for (int n = 1; n <= 12; ++n)
        add_tool(rig, {{"name", "TOOL_" + std::to_string(n)}, {"type", n}}, n);
    const Json list = operate(rig, {{"do", "tools.list"}});
    ASSERT_EQ(list["tools"].size(), 12u);  // some thousand characters: many answers
    EXPECT_EQ(list["tools"][11]["place"], "magazine 1 pot 12");
    const auto tools = tools_of(rig);
    EXPECT_STREQ(tools->rows[4].name.data(), "TOOL_5");
    EXPECT_EQ(tools->rows[4].pot, 5);
    auto places = std::make_unique<ToolPlaceTable>();
    ASSERT_TRUE((*rig.store)->places.read(*places));
    EXPECT_EQ(places->places[4].tool, 5);
    const Json low = operate(rig, {{"do", "tools.delete"}, {"tool", 1}}, UserLevel::Operator);
    EXPECT_EQ(low["number"], "PT0432") << low.dump();
    EXPECT_EQ(rig.stop(), 0);
}

TEST(ToolCalls, AreAnsweredBeforeTheirQuestionIsPassed) {
    StoreRig rig("calls");
    rig.make_kernel();
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine, "--set", "N2900=00000001"}))
        << rig.messages();
    add_tool(rig,
             {{"name", "A"},
              {"type", 7},
              {"h", 3},
              {"life_kind", "minutes"},
              {"life", 60},
              {"counter", 12.5},
              {"warning", 5}},
             4);
    StoreRequest call{};
    call.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolCall);
    call.channel = 1;
    call.value = 7;
    const auto index = rig.push(call);
    ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, index));
    ASSERT_EQ((*rig.store)->tool_answers.head.load(), 1u);
    const ToolAnswer answer = (*rig.store)->tool_answers.slot(0);
    EXPECT_EQ(answer.id, index);
    EXPECT_EQ(answer.alarm, -1);
    EXPECT_EQ(answer.magazine, 1);
    EXPECT_EQ(answer.pot, 4);
    EXPECT_EQ(answer.offset, 3);
    EXPECT_EQ(answer.left, 47.5);
    (*rig.kernel)->tool_tail.tail.store(1);
    call.value = 8;
    ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, rig.push(call)));
    EXPECT_EQ((*rig.store)->tool_answers.slot(1).alarm,
              static_cast<std::int32_t>(Alarm::ToolNotFound));
    EXPECT_EQ(rig.stop(), 0);
}

// A disk that is full stops tool changes, and says why; when it takes values again tools can be
// called again.
TEST(ToolCalls, AreRefusedWhileTheDiskRefuses) {
    StoreRig rig("full-tools");
    rig.make_kernel();
    ASSERT_TRUE(rig.start(
        {"--store", rig.folder + "/store", "--machine", kMachine, "--set", "N2900=00000001"}))
        << rig.messages();
    add_tool(rig, {{"name", "A"}, {"type", 7}, {"life_kind", "pieces"}, {"life", 1e6}}, 4);
    StoreRequest call{}, use{};
    call.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolCall);
    call.channel = 1;
    call.value = 7;
    use.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolLife);
    use.number = 1;
    use.field = static_cast<std::int32_t>(LifeKind::Pieces);
    use.value = 1;
    const auto answer = [&] {
        EXPECT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, rig.push(call)));
        const auto head = (*rig.store)->tool_answers.head.load();
        (*rig.kernel)->tool_tail.tail.store(head);
        return (*rig.store)->tool_answers.slot(head - 1);
    };
    EXPECT_EQ(answer().alarm, -1);
    const rlimit full{4096, RLIM_INFINITY};  // no file grows any more
    ASSERT_EQ(prlimit(rig.pid, RLIMIT_FSIZE, &full, nullptr), 0);
    int alarm = -1;
    for (int ms = 0; ms < 8000 && alarm == -1; ms += 50) {
        rig.push(use);
        usleep(50'000);
        alarm = answer().alarm;
    }
    EXPECT_EQ(alarm, static_cast<int>(Alarm::ToolsUnserved)) << rig.messages();
    EXPECT_NE(rig.messages().find("PT0403"), std::string::npos);
    const rlimit free{RLIM_INFINITY, RLIM_INFINITY};
    ASSERT_EQ(prlimit(rig.pid, RLIMIT_FSIZE, &free, nullptr), 0);
    for (int ms = 0; ms < 8000 && alarm != -1; ms += 100) {
        usleep(100'000);
        alarm = answer().alarm;
    }
    EXPECT_EQ(alarm, -1);
    EXPECT_EQ(rig.stop(), 0);
}

// Killed at random moments while life is counted: what counts at the end is exactly what was sent,
// never more.
TEST(ToolLife, IsCountedOnceWhateverIsKilled) {
    StoreRig rig("life");
    rig.make_kernel();
    const std::vector<std::string> arguments = {"--store", rig.folder + "/store", "--machine",
                                                kMachine};
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    add_tool(rig, {{"type", 1}, {"life_kind", "pieces"}, {"life", 100000}}, 1);
    StoreRequest use{};
    use.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolLife);
    use.number = 1;
    use.field = static_cast<std::int32_t>(LifeKind::Pieces);
    use.value = 1;
    std::mt19937 random(test_seed(7));
    double sent = 0;
    std::uint64_t index = 0;
    for (int round = 0; round < 20; ++round) {
        for (int n = 0; n < 40; ++n) {
            index = rig.push(use);
            ++sent;
            usleep(random() % 2500);
        }
        rig.kill_now();
        ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    }
    ASSERT_TRUE(StoreRig::reached((*rig.store)->on_disk, index));
    EXPECT_EQ(tools_of(rig)->rows[0].counter, sent);
    EXPECT_EQ(rig.stop(), 0);
    ASSERT_TRUE(rig.start(arguments));
    EXPECT_EQ(tools_of(rig)->rows[0].counter, sent);
    EXPECT_EQ(rig.stop(), 0);
}

// Killed behind the commit and before it could say so: the successor finds all on the disk, and
// says it although nothing more comes.
TEST(ToolLife, IsSaidToBeOnDiskByASuccessorThatHasNothingToWrite) {
    StoreRig rig("said");
    rig.make_kernel();
    const std::vector<std::string> arguments = {"--store", rig.folder + "/store", "--machine",
                                                kMachine};
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    add_tool(rig, {{"type", 1}, {"life_kind", "pieces"}, {"life", 100000}}, 1);
    StoreRequest use{};
    use.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolLife);
    use.number = 1;
    use.field = static_cast<std::int32_t>(LifeKind::Pieces);
    use.value = 1;
    const std::uint64_t index = rig.push(use);
    ASSERT_TRUE(StoreRig::reached((*rig.store)->on_disk, index));
    rig.kill_now();
    {
        const std::string name = "/dev/shm/polyturn." + rig.instance + ".store";
        const int file = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
        ASSERT_GE(file, 0) << name;
        void* const memory =
            ::mmap(nullptr, sizeof(StoreSegment), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        ::close(file);
        ASSERT_NE(memory, MAP_FAILED);
        static_cast<StoreSegment*>(memory)->on_disk.store(index - 1);
        ::munmap(memory, sizeof(StoreSegment));
    }
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_TRUE(StoreRig::reached((*rig.store)->on_disk, index))
        << (*rig.store)->on_disk.load() << " of " << index;
    EXPECT_EQ(tools_of(rig)->rows[0].counter, 1);
    EXPECT_EQ(rig.stop(), 0);
}

TEST(Backups, BringEverythingBackAndShowBeforeWhatWouldChange) {
    StoreRig rig("backup");
    const std::string store = rig.folder + "/store", file = rig.folder + "/good.ptb";
    ASSERT_TRUE(rig.start({"--store", store, "--machine", kMachine})) << rig.messages();
    add_tool(rig, {{"name", "KEPT"}, {"type", 3}, {"D1.DP6", 0.8}}, 3);
    ASSERT_EQ(rig.ask(parameter_request("N1600 L1=2.5"))->ok, 1u);
    ASSERT_EQ(rig.ask(offset_request(1, 3, OffsetTable::Wear, OffsetField::X, 0.02))->ok, 1u);
    const Json made = operate(rig, {{"do", "backup.to"}, {"file", file}});
    ASSERT_TRUE(made.value("ok", false)) << made.dump();
    EXPECT_NE(made["files"].dump().find("machine/machine.params"), std::string::npos);
    ASSERT_TRUE(operate(rig, {{"do", "tools.unload"}, {"tool", 1}}).value("ok", false));
    ASSERT_TRUE(operate(rig, {{"do", "tools.delete"}, {"tool", 1}}).value("ok", false));
    ASSERT_EQ(rig.ask(parameter_request("N1600 L1=4"))->ok, 1u);
    const Json shown = operate(rig, {{"do", "restore.from"}, {"file", file}, {"preview", true}});
    EXPECT_TRUE(shown.value("ok", false)) << shown.dump();
    EXPECT_NE(shown["changes"].dump().find("N1600 L1"), std::string::npos) << shown.dump();
    EXPECT_EQ(rig.value_of("N1600 L1"), "4");
    const Json done = operate(rig, {{"do", "restore.from"}, {"file", file}});
    ASSERT_TRUE(done.value("ok", false)) << done.dump();
    EXPECT_EQ(rig.value_of("N1600 L1"), "2.5");
    const auto tools = tools_of(rig);
    EXPECT_STREQ(tools->rows[0].name.data(), "KEPT");
    EXPECT_EQ(tools->rows[0].pot, 3);
    const Json again = operate(rig, {{"do", "restore.from"}, {"file", file}, {"preview", true}});
    EXPECT_EQ(again["total"], 0) << again.dump();
    EXPECT_FALSE(operate(rig, {{"do", "restore.from"}, {"file", kMachine + "/machine.params"}})
                     .value("ok", true));
    EXPECT_EQ(rig.stop(), 0);
    // A damaged file: there is no production, the reason is said, and the backup takes its place.
    {
        std::fstream out(store + "/store.sqlite", std::ios::in | std::ios::out | std::ios::binary);
        out << std::string(8192, 'x');
    }
    ASSERT_TRUE(rig.start({"--store", store, "--machine", kMachine})) << rig.messages();
    EXPECT_EQ(rig.stop(), 0);
    EXPECT_NE(rig.messages().find("PT0401"), std::string::npos) << rig.messages();
    rig.start({"--store", store, "--machine", kMachine, "--restore", file});
    EXPECT_EQ(rig.wait_end(), 0) << rig.messages();
    ASSERT_TRUE(rig.start({"--store", store, "--machine", kMachine})) << rig.messages();
    EXPECT_STREQ(tools_of(rig)->rows[0].name.data(), "KEPT");
    EXPECT_EQ(rig.stop(), 0);
}

void run_sql(const std::string& file, const char* sql) {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
    char* wrong = nullptr;
    EXPECT_EQ(sqlite3_exec(db, sql, nullptr, nullptr, &wrong), SQLITE_OK) << (wrong ? wrong : "");
    sqlite3_close(db);
}

TEST(Schema, OfAnOlderVersionIsBroughtUpToDateWithItsData) {
    StoreRig rig("upgrade");
    const std::vector<std::string> arguments = {"--store", rig.folder + "/store", "--machine",
                                                kMachine};
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    ASSERT_EQ(rig.ask(offset_request(1, 3, OffsetTable::Wear, OffsetField::X, 0.02))->ok, 1u);
    EXPECT_EQ(rig.stop(), 0);
    const std::string file = rig.folder + "/store/store.sqlite";
    polyturn::test::forget_acknowledged(rig.folder + "/store");
    run_sql(
        file,
        "DROP TABLE promise; DROP TABLE records; DROP INDEX history_utc; DELETE FROM migrations "
        "WHERE version > 1; PRAGMA user_version=1");
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    EXPECT_EQ(rig.channel(1)->offsets[3].wear[0], 0.02);
    add_tool(rig, {{"type", 3}}, 3);
    EXPECT_EQ(rig.stop(), 0);
    // as a later version leaves it: refused, with the reason
    run_sql(file, "PRAGMA user_version=99");
    EXPECT_FALSE(rig.start(arguments));
    EXPECT_EQ(rig.wait_end(), 1);
    EXPECT_NE(rig.messages().find("schema 99"), std::string::npos) << rig.messages();
}

}  // namespace
