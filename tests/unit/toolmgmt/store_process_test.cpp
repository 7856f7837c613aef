// The store as a process: what it publishes at its start, what requests do, what it keeps.
#include <sqlite3.h>

#include <cmath>
#include <thread>

#include "ipc/image/store_changes.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/params/registry.hpp"
#include "store_rig.hpp"
#include "tests/places.hpp"

namespace {

using namespace polyturn;
using polyturn::test::StoreRig;

const std::string kMachine = std::string(kSourceFolder) + "/examples/machines/twin-turret";

std::string write_file(const StoreRig& rig, const std::string& name, const std::string& text) {
    const std::string path = rig.folder + "/" + name;
    std::ofstream(path) << text;
    return path;
}

TEST(StoreAtItsStart, PublishesMachineSetsAndSetup) {
    StoreRig rig("start");
    const std::string setup = write_file(rig, "setup.toml", R"(
[channel.1]
work = { G54 = { X = 1.0, Z = -150.0 }, shift = { Z = 2.0 } }
variables = { "#500" = 12.5, "#100" = 3.0 }
[channel.1.offset.3]
geometry = { X = -12.3, Z = 4.5, R = 0.8, T = 3 }
wear = { X = 0.05 }
)");
    ASSERT_TRUE(
        rig.start({"--memory", "--machine", kMachine, "--set", "N1600 L1=2.5", "--setup", setup}))
        << rig.messages();
    const auto table = rig.parameters();
    EXPECT_EQ(params::get(*table, params::n0000_machine_group, 2), 1);
    EXPECT_EQ(params::get(*table, params::n2201_waiting_m_codes_min), 500);
    EXPECT_EQ(rig.value_of("N1600 L1"), "2.5");
    const auto channel = rig.channel(1);
    EXPECT_EQ(channel->offsets[3].geometry[0], -12.3);
    EXPECT_EQ(channel->offsets[3].geometry[2], 4.5);
    EXPECT_EQ(channel->offsets[3].geometry_r, 0.8);
    EXPECT_EQ(channel->offsets[3].tip, 3);
    EXPECT_EQ(channel->offsets[3].wear[0], 0.05);
    EXPECT_EQ(channel->zeros[kZeroG54 * kChannelAxes + 1], -150.0);
    EXPECT_EQ(channel->zeros[kZeroShift * kChannelAxes + 1], 2.0);
    EXPECT_EQ(channel->variables[0], 12.5);
    EXPECT_TRUE(std::isnan(channel->variables[1]));
    EXPECT_EQ(rig.stop(), 0);
}

TEST(StoreAtItsStart, RefusesAContradictionWithParameterAndValue) {
    StoreRig rig("contradiction");
    EXPECT_FALSE(rig.start({"--memory", "--machine", kMachine, "--set", "N0002 A7=5"}));
    EXPECT_EQ(rig.wait_end(), 2);
    EXPECT_NE(rig.messages().find("N0002 A7=5"), std::string::npos) << rig.messages();
}

TEST(StoreAtItsStart, RefusesBadInputWithExitStatusTwo) {
    StoreRig rig("bad-input");
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"--memory", "--machine", "/nowhere/at/all"},
             {"--memory", "--machine", kMachine, "--set", "N9999=1"},
             {"--memory", "--machine", kMachine, "--setup", "/nowhere.toml"},
             {"--machine", kMachine},
             {"--memory", "--machine", kMachine, "--param-file", "/nowhere"}}) {
        EXPECT_FALSE(rig.start(arguments));
        EXPECT_EQ(rig.wait_end(), 2) << rig.messages();
        EXPECT_FALSE(rig.messages().empty());
    }
}

// A cell that a program gives a value and that cannot be written: the operator must know, the
// program has gone on.
TEST(StoreRequests, WhatCannotBeKeptIsAMessageForTheOperator) {
    StoreRig rig("cell");
    rig.make_kernel();
    // the rig's supervisor has no folder of a machine
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    const std::uint64_t end = rig.push(parameter_request("10000=0.02"));
    ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, end));
    const auto& ring = (*rig.store)->tool_answers;
    ASSERT_EQ(ring.head.load(), 1u);
    EXPECT_EQ(ring.slot(0).alarm, kStoreMessage);
    EXPECT_EQ(ring.slot(0).tool, static_cast<std::int32_t>(Alarm::NotKept));
    EXPECT_NE(std::string(ring.slot(0).text.data()).find("folder"), std::string::npos)
        << ring.slot(0).text.data();
}

TEST(StoreRequests, AreAnsweredAndPublished) {
    StoreRig rig("requests");
    rig.make_kernel();
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    auto answer = rig.ask(parameter_request("N0304 A3=12000"));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->ok, 1u) << answer->text.data();
    EXPECT_EQ(params::get(*rig.parameters(), params::n0304_rapid, 3), 12000);
    // The kernel gets the same number as a change of one complete import.
    ASSERT_EQ((*rig.store)->param_changes.head.load(), 1u);
    const ParamChange& change = (*rig.store)->param_changes.slot(0);
    EXPECT_EQ(rig.parameters()->numbers[change.slot], 12000);
    EXPECT_EQ(change.value, 12000);
    EXPECT_EQ(change.last, 1u);

    answer = rig.ask(offset_request(1, 5, OffsetTable::Wear, OffsetField::X, 0.25));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->ok, 1u) << answer->text.data();
    EXPECT_EQ(rig.channel(1)->offsets[5].wear[0], 0.25);

    StoreRequest zero = store_request(StoreRequestKind::WorkZero, 2, 0, 0, -33.5);
    put_name(zero, "G54.1P3 Z");
    answer = rig.ask(zero);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->ok, 1u) << answer->text.data();
    EXPECT_EQ(rig.channel(2)->zeros[(kZeroG541 + 3) * kChannelAxes + 1], -33.5);
}

// What mefi writes by G92 and G93: it holds until power-off, through the death of the store, and is
// no value of the disk.
TEST(StoreZeros, ThatHoldUntilPowerOffNeverReachTheDisk) {
    StoreRig rig("volatile");
    rig.make_kernel();
    const std::vector<std::string> arguments{"--store", rig.folder + "/store", "--machine",
                                             kMachine};
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    rig.push(work_zero_request(1, 3, 0, 5.0));
    const auto end = rig.push(work_zero_request(1, 3, 1 + kVolatile, 7.0));
    ASSERT_TRUE(StoreRig::reached((*rig.store)->on_disk, end));
    EXPECT_EQ(rig.channel(1)->zeros[3 * kChannelAxes + 0], 5.0);
    EXPECT_EQ(rig.channel(1)->zeros[3 * kChannelAxes + 1], 7.0);
    rig.kill_now();
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();  // the same power-on: it goes on holding
    EXPECT_EQ(rig.channel(1)->zeros[3 * kChannelAxes + 0], 5.0);
    EXPECT_EQ(rig.channel(1)->zeros[3 * kChannelAxes + 1], 7.0);
    rig.kill_now();
    StoreRig next("volatile-next");  // another controller on the same disk
    next.make_kernel();
    ASSERT_TRUE(next.start(arguments)) << next.messages();
    EXPECT_EQ(next.channel(1)->zeros[3 * kChannelAxes + 0], 5.0);
    EXPECT_EQ(next.channel(1)->zeros[3 * kChannelAxes + 1], 0.0);
}

TEST(StoreRequests, OfOneImportAreDoneTogetherOrNotAtAll) {
    StoreRig rig("import");
    rig.make_kernel();
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", kMachine}))
        << rig.messages();
    for (int a = 1; a <= 4; ++a) {
        const auto more = rig.ask(
            parameter_request("N0304 A" + std::to_string(a) + "=1500" + std::to_string(a), true));
        ASSERT_TRUE(more);
        EXPECT_EQ(more->ok, 1u);
        EXPECT_EQ((*rig.store)->param_changes.head.load(), 0u);
    }
    auto answer = rig.ask(parameter_request("N0304 A5=nonsense"));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->ok, 0u);
    EXPECT_EQ(rig.value_of("N0304 A1"), "20000");  // none of them
    for (const char* line : {"N0304 A1=15001", "N0304 A2=15002", "N0304 A1=15003"})
        ASSERT_TRUE(rig.ask(parameter_request(line, true)));
    answer = rig.ask(parameter_request("N1600 L1=4"));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->ok, 1u) << answer->text.data();
    ASSERT_EQ((*rig.store)->param_changes.head.load(), 3u);  // A1 once
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ((*rig.store)->param_changes.slot(static_cast<std::uint64_t>(i)).last,
                  i == 2 ? 1u : 0u);
    // An import that nobody finishes leaves nothing behind.
    ASSERT_TRUE(rig.ask(parameter_request("N1600 L1=9", true)));
    EXPECT_EQ(rig.value_of("N1600 L1"), "4");
    ASSERT_TRUE(rig.ask(parameter_request("N1600 L2=5")));
    EXPECT_EQ(rig.value_of("N1600 L1"), "4");
    rig.kill_now();
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", kMachine}))
        << rig.messages();
    EXPECT_EQ(rig.value_of("N0304 A1"), "15003");
    EXPECT_EQ(rig.value_of("N0304 A2"), "15002");
    EXPECT_EQ(rig.value_of("N1600 L1"), "4");
}

// A value for every axis, channel and spindle of every row: more than the kernel's ring holds at
// once.
TEST(StoreRequests, OfAHugeImportReachTheKernelWhole) {
    StoreRig rig("huge");
    rig.make_kernel();
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    std::size_t expected = 0;
    for (const params::Row& row : params::rows()) {
        if (row.type != params::Type::Real || row.max < 2 || row.min > 1 || row.array > 1) continue;
        expected += params::instances(row.scope);
        for (const char* value : {"=1", "=2"}) {  // whatever it was, it changes
            const auto answer =
                rig.ask(parameter_request(std::string(row.number) + value, value[1] == '1'));
            ASSERT_TRUE(answer);
            ASSERT_EQ(answer->ok, 1u) << answer->text.data();
        }
        (*rig.kernel)->param_tail.tail.store((*rig.store)->param_changes.head);
    }
    EXPECT_GT(expected, 8192u);
    std::thread kernel([&] {  // takes complete imports only, as the kernel does
        std::uint64_t tail = (*rig.kernel)->param_tail.tail;
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        for (std::size_t taken = 0; taken < expected && std::chrono::steady_clock::now() < until;) {
            const auto head = (*rig.store)->param_changes.head.load();
            std::uint64_t complete = tail;
            for (auto i = tail; i < head; ++i)
                if ((*rig.store)->param_changes.slot(i).last) complete = i + 1;
            taken += complete - tail;
            tail = complete;
            (*rig.kernel)->param_tail.tail.store(tail);
            usleep(500);
        }
    });
    std::optional<StoreAnswer> answer;
    std::vector<std::string> lines;
    for (const params::Row& row : params::rows())
        if (row.type == params::Type::Real && row.max >= 2 && row.min <= 1 && row.array == 1)
            lines.push_back(std::string(row.number) + "=1.5");
    for (const std::string& line : lines)
        answer = rig.ask(parameter_request(line, &line != &lines.back()));
    kernel.join();
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->ok, 1u) << answer->text.data();
    EXPECT_EQ((*rig.kernel)->param_tail.tail.load(), (*rig.store)->param_changes.head.load());
}

TEST(StoreRequests, ThatAreWrongAreRefusedWithTheReason) {
    StoreRig rig("refused");
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    struct Row {
        StoreRequest request;
        const char* says;
    };
    StoreRequest unknown_zero = store_request(StoreRequestKind::WorkZero, 1, 0, 0, 1.0),
                 unknown_axis = unknown_zero;
    put_name(unknown_zero, "G60 X");
    put_name(unknown_axis, "G54 Q");
    const Row rows[] = {
        {parameter_request("N1600 L1=abc"), "N1600"},
        {parameter_request("N1600 L99=1"), "L99"},
        {parameter_request(""), "empty"},
        {offset_request(1, 0, OffsetTable::Geometry, OffsetField::X, 1.0), "does not exist"},
        {offset_request(1, 33, OffsetTable::Geometry, OffsetField::X, 1.0), "N1400"},
        {offset_request(1, 1, OffsetTable::Wear, OffsetField::Z, 1.5), "N1415"},
        {offset_request(1, 1, OffsetTable::Geometry, OffsetField::T, 10), "0 to 9"},
        {offset_request(1, 1, OffsetTable::Geometry, OffsetField::X, NAN), "not a number"},
        {offset_request(3, 1, OffsetTable::Geometry, OffsetField::X, 1.0), "L3"},
        {offset_request(17, 1, OffsetTable::Geometry, OffsetField::X, 1.0), "L17"},
        {work_zero_request(1, 5000, 0, 1.0), "does not exist"},
        {work_zero_request(1, 1, -1, 1.0), "does not exist"},
        {unknown_zero, "G60"},
        {unknown_axis, "axis Q"},
        {store_request(static_cast<StoreRequestKind>(77), 1, 0, 0, 0), "77"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.says);
        const auto answer = rig.ask(row.request);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->ok, 0u);
        EXPECT_NE(std::string(answer->text.data()).find(row.says), std::string::npos)
            << answer->text.data();
    }
}

TEST(StorePersist, IsInTheImageBeforeTheTailMovesAndOnDiskSoonAfter) {
    StoreRig rig("persist");
    rig.make_kernel();
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", kMachine}))
        << rig.messages();
    for (int round = 1; round <= 50; ++round) {
        rig.push(variable_request(1, "#512", round));
        rig.push(variable_request(1, "#100", 7));  // not kept, no error
        const auto index = rig.push(parameter_request("N1600 L1=" + std::to_string(round)));
        ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, index));
        EXPECT_EQ(rig.channel(1)->variables[12], round);
        EXPECT_EQ(rig.parameters()->numbers
                      [(*rig.store)->param_changes.slot((*rig.store)->param_changes.head - 1).slot],
                  round);
        (*rig.kernel)->param_tail.tail.store((*rig.store)->param_changes.head);
    }
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_TRUE(StoreRig::reached((*rig.store)->on_disk, 150));
    // 100 ms on an idle computer
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
    rig.kill_now();
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", kMachine}))
        << rig.messages();
    EXPECT_EQ(rig.channel(1)->variables[12], 50);
    EXPECT_EQ(rig.value_of("N1600 L1"), "50");
}

TEST(StoreKept, SurvivesAndRunsOverridesOnlyForOneRun) {
    StoreRig rig("kept");
    const std::vector<std::string> plain = {"--store", rig.folder + "/store", "--machine",
                                            kMachine};
    ASSERT_TRUE(rig.start(plain)) << rig.messages();
    ASSERT_TRUE(rig.ask(parameter_request("N1600 L1=2.5")));
    ASSERT_TRUE(rig.ask(parameter_request("N0003 L2=Below")));
    ASSERT_TRUE(rig.ask(offset_request(2, 7, OffsetTable::Geometry, OffsetField::Z, -0.125)));
    EXPECT_EQ(rig.stop(), 0);
    ASSERT_TRUE(
        rig.start({"--store", rig.folder + "/store", "--machine", kMachine, "--set", "N1600 L1=9"}))
        << rig.messages();
    EXPECT_EQ(rig.value_of("N1600 L1"), "9");
    EXPECT_EQ(rig.value_of("N0003 L2"), "Below");
    EXPECT_EQ(rig.channel(2)->offsets[7].geometry[2], -0.125);
    EXPECT_EQ(rig.stop(), 0);
    ASSERT_TRUE(rig.start(plain)) << rig.messages();
    EXPECT_EQ(rig.value_of("N1600 L1"), "2.5");
}

TEST(StoreOnDisk, IsRefusedWhenDamagedNewerOrInUse) {
    StoreRig rig("damaged");
    const std::string folder = rig.folder + "/store", file = folder + "/store.sqlite";
    const std::vector<std::string> arguments = {"--store", folder, "--machine", kMachine};
    std::filesystem::create_directories(folder);
    const std::string garbage(5000, 'x');
    std::ofstream(file) << garbage;
    EXPECT_FALSE(rig.start(arguments));
    EXPECT_EQ(rig.wait_end(), 1);
    EXPECT_NE(rig.messages().find("PT0401"), std::string::npos) << rig.messages();
    std::ifstream again(file);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(again), {}), garbage);  // not overwritten

    std::filesystem::remove_all(folder);
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    // A second controller on the same folder.
    {
        StoreRig other("second");
        EXPECT_FALSE(other.start(arguments));
        EXPECT_EQ(other.wait_end(), 1);
        EXPECT_NE(other.messages().find("PT0405"), std::string::npos) << other.messages();
    }
    EXPECT_EQ(rig.stop(), 0);

    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(db, "PRAGMA user_version=99", nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(db);
    EXPECT_FALSE(rig.start(arguments));
    EXPECT_EQ(rig.wait_end(), 1);
    EXPECT_NE(rig.messages().find("PT0402"), std::string::npos) << rig.messages();
}

TEST(StoreOnDisk, ThatIsFullRefusesTheChangeAndGoesOn) {
    StoreRig rig("full");
    const std::string folder = rig.folder + "/store";
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine})) << rig.messages();
    const rlimit limit{200'000, 200'000};  // from now on no file grows beyond this
    ASSERT_EQ(prlimit(rig.pid, RLIMIT_FSIZE, &limit, nullptr), 0);
    bool refused = false;
    int last_good = 0;
    for (int value = 1; value < 500 && !refused; ++value) {
        const auto answer = rig.ask(parameter_request("N1600 L1=" + std::to_string(value)));
        ASSERT_TRUE(answer) << rig.messages();
        refused = answer->ok == 0;
        if (refused)
            EXPECT_NE(std::string(answer->text.data()).find("PT0403"), std::string::npos)
                << answer->text.data();
        else
            last_good = value;
    }
    EXPECT_TRUE(refused);
    EXPECT_FALSE(rig.ended()) << rig.messages();
    // What was refused did not happen.
    EXPECT_EQ(params::get(*rig.parameters(), params::n1600_depth_of_cut, 1), last_good);
    rig.kill_now();
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine})) << rig.messages();
    EXPECT_EQ(rig.value_of("N1600 L1"), std::to_string(last_good));
}

TEST(StoreOnDisk, IsARowOfAnotherMachineLeftOutWithAWarning) {
    StoreRig rig("foreign");
    const std::string folder = rig.folder + "/store", file = folder + "/store.sqlite";
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine}));
    EXPECT_EQ(rig.stop(), 0);
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
    ASSERT_EQ(
        sqlite3_exec(db,
                     "INSERT INTO parameters VALUES('N9999',1,0,5,NULL); INSERT INTO parameters "
                     "VALUES('N0105',1,0,77,NULL);"
                     "INSERT INTO offsets VALUES(1,5000,0,1); INSERT INTO zeros VALUES(40,1,0,1);",
                     nullptr, nullptr, nullptr),
        SQLITE_OK);
    sqlite3_close(db);
    polyturn::test::forget_acknowledged(folder);
    ASSERT_TRUE(rig.start({"--store", folder, "--machine", kMachine})) << rig.messages();
    EXPECT_EQ(rig.value_of("N0105 L1"), "2");
    EXPECT_NE(rig.messages().find("N9999"), std::string::npos);
    EXPECT_NE(rig.messages().find("PT0406"), std::string::npos);
}

}  // namespace
