// T calls that ask the store, and life that is counted while the tool cuts (nct part 2 30.3 to
// 30.6).
#include <limits>

#include "ipc/image/store_changes.hpp"
#include "ipc/requests/command_levels.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();

// A rig whose store answers T calls from a list.
struct Context {
    TickRig rig;
    std::vector<ToolAnswer> tools;
    std::vector<StoreRequest> asked;
    std::uint64_t read = 0;
    bool answers = true;

    explicit Context(const std::function<void(params::Table&)>& more = {})
        : rig([&](params::Table& t, RunOptions&) {
              params::put(t, params::n2900_tool_m_config, 1);
              for (unsigned l = 1; l <= 3; ++l) params::put(t, params::pt_life_end, 0, l);
              if (more) more(t);
          }) {
        rig.on_tick = [this] { serve(); };
    }
    static ToolAnswer tool(int number, int pot, LifeKind kind, double left, double warning = 0) {
        ToolAnswer a{};
        a.alarm = -1;
        a.tool = number;
        a.magazine = 1;
        a.pot = pot;
        a.offset = 10 + number;
        a.life_kind = static_cast<std::uint32_t>(kind);
        a.left = a.group_left = left;
        a.warning = warning;
        return a;
    }
    void serve() {
        const auto head = rig.kernel->persist.head.load();
        for (; answers && read < head; ++read) {
            const StoreRequest request = rig.kernel->persist.slot(read);
            asked.push_back(request);
            if (static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::ToolCall) {
                ToolAnswer answer{};
                answer.alarm = static_cast<int>(Alarm::ToolNotFound);
                for (const ToolAnswer& one : tools)
                    if (one.tool == static_cast<int>(request.value)) answer = one;
                answer.id = request.id;
                answer.channel = request.channel;
                say(answer);
            }
            rig.store->persist_tail.tail.store(read + 1);
        }
    }
    void say(const ToolAnswer& answer) {
        auto& ring = rig.store->tool_answers;
        ring.slot(ring.head.load()) = answer;
        ring.head.store(ring.head.load() + 1);
    }
    // Virtual time: the clock would wait for answers that are due.
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) rig.tick();
    }
    double used(int number, LifeKind kind) const {
        double sum = 0;
        for (const StoreRequest& one : asked)
            if (static_cast<StoreRequestKind>(one.kind) == StoreRequestKind::ToolLife &&
                one.number == number && one.field == static_cast<int>(kind))
                sum += one.value;
        return sum;
    }
    int nc(const NcSignal& signal, unsigned l = 1) {
        return rig.machine->core().signals.nc(signal(l));
    }
};

TEST(ToolClient, AsksTheStoreBeforeThePlcHearsOfTheT) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::None, kEver)};
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(5);
    EXPECT_EQ(d.nc(signals::cn_tstr), 0);  // the answer acts PT_ANSWER_TICKS later
    d.run(200);
    EXPECT_EQ(d.nc(signals::cn_tstr), 1);
    EXPECT_EQ(d.nc(signals::cn_mgzno), 1);
    EXPECT_EQ(d.nc(signals::cn_potno), 4);
    EXPECT_EQ(d.nc(signals::cn_toolno), 7);
    EXPECT_EQ(d.nc(signals::cn_tcode), 7);
    EXPECT_EQ(d.rig.state(1), ChannelState::Ended);
    MachineStatus status;
    ASSERT_TRUE(d.rig.kernel->status.read(status));
    EXPECT_EQ(status.channels[0].tool, 7);
    EXPECT_EQ(status.channels[0].tool_offset, 17);
    const StoreRequest* in_place = nullptr;
    for (const StoreRequest& one : d.asked)
        if (static_cast<StoreRequestKind>(one.kind) == StoreRequestKind::ToolInPlace)
            in_place = &one;
    ASSERT_NE(in_place, nullptr);
    EXPECT_EQ(in_place->number, 7);
    EXPECT_EQ(in_place->field, 1);  // a turret: it works now
}

TEST(ToolClient, WithoutToolManagementNobodyIsAsked) {
    Context d([](params::Table& t) { params::put(t, params::n2900_tool_m_config, 0); });
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.line(1, {0, -50}, 50));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(2000);
    for (const StoreRequest& one : d.asked)
        EXPECT_TRUE(static_cast<StoreRequestKind>(one.kind) < StoreRequestKind::ToolCall)
            << one.kind;
    EXPECT_EQ(d.nc(signals::cn_mgzno), 0);
    EXPECT_EQ(d.nc(signals::cn_potno), 7);
}

TEST(ToolClient, AToolThatNobodyFindsStopsTheChannelByItsAlarm) {
    Context d;
    d.rig.push(1, d.rig.aux(1, 'T', 9));
    d.rig.start(1);
    d.run(200);
    EXPECT_TRUE(d.rig.alarmed(Alarm::ToolNotFound, 1));
    EXPECT_EQ(d.nc(signals::cn_tstr), 0);
    // Somebody loads it meanwhile: nothing moves by itself.
    d.tools = {Context::tool(9, 4, LifeKind::None, kEver)};
    d.run(200);
    EXPECT_EQ(d.nc(signals::cn_tstr), 0);
    EXPECT_EQ(d.rig.state(1), ChannelState::Interrupted);
    int calls = 0;
    for (const StoreRequest& one : d.asked)
        calls += static_cast<StoreRequestKind>(one.kind) == StoreRequestKind::ToolCall;
    EXPECT_EQ(calls, 1);
}

TEST(ToolClient, WhatTheStoreCouldNotKeepIsToldTheOperator) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::None, kEver)};
    ToolAnswer message{};
    message.alarm = kStoreMessage;
    message.tool = static_cast<int>(Alarm::NotKept);
    d.say(message);
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(200);
    EXPECT_TRUE(d.rig.alarmed(Alarm::NotKept));
    EXPECT_EQ(d.rig.state(1), ChannelState::Ended)
        << "the program goes on, and answers behind it are taken";
}

// Data were lost: said, and nothing starts until somebody has confirmed it.
TEST(ToolClient, AStoreThatHasLostDataStartsNothingUntilItIsWholeAgain) {
    Context d;
    ToolAnswer message{};
    message.alarm = kStoreUnfit;
    message.tool = static_cast<int>(Alarm::StoreLost);
    d.say(message);
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.run(10);
    EXPECT_TRUE(d.rig.alarmed(Alarm::StoreLost));
    d.rig.start(1);
    d.run(200);
    EXPECT_NE(d.rig.state(1), ChannelState::Ended);
    message.alarm = kStoreWhole;
    d.say(message);
    d.run(10);
    d.rig.start(1);
    d.run(200);
    EXPECT_EQ(d.rig.state(1), ChannelState::Ended);
}

TEST(ToolClient, ANumberThatIsNoAlarmsIsARefusalToo) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::None, kEver)};
    d.tools[0].alarm = kAlarmCount;
    ToolAnswer message{};
    message.alarm = kStoreMessage;
    message.tool = -1;
    d.say(message);
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(200);
    EXPECT_TRUE(d.rig.alarmed(Alarm::ToolsUnserved));
    EXPECT_TRUE(d.rig.alarmed(Alarm::ToolsUnserved, 1));
    EXPECT_EQ(d.nc(signals::cn_tstr), 0);
}

TEST(ToolClient, TimeCountsOnlyWhileTheToolCuts) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Minutes, 10)};
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.line(1, {0, 100}, 0, kRapid));
    d.rig.push(1, d.rig.line(1, {0, -100}, 50));
    d.rig.push(1, d.rig.dwell(1, 2.0));
    d.rig.push(1, d.rig.line(1, {0, 100}, 0, kRapid));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(8000);
    ASSERT_EQ(d.rig.state(1), ChannelState::Ended);
    // 100 mm at 50 mm/s and its ramps
    EXPECT_NEAR(d.used(7, LifeKind::Minutes) * 60, 2.0 + 50.0 / 2000 + 0.05, 0.05);
}

TEST(ToolClient, AHoldACutInADryRunAndALockedMachineCostNoLife) {
    for (const CommandKind key : {CommandKind::DryRun, CommandKind::MachineLock}) {
        Context d;
        d.tools = {Context::tool(7, 4, LifeKind::Metres, 10)};
        SCOPED_TRACE(static_cast<int>(key));
        d.rig.command(key, 1, 1);
        d.run(5);
        d.rig.push(1, d.rig.aux(1, 'T', 7));
        d.rig.push(1, d.rig.line(1, {0, -100}, 50));
        d.rig.push(1, d.rig.stop(1, StopReason::M30));
        d.rig.start(1);
        d.run(8000);
        EXPECT_EQ(d.used(7, LifeKind::Metres), 0);
    }
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Minutes, 10)};
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.line(1, {0, -100}, 50));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(700);
    d.rig.command(CommandKind::FeedHold, 1);
    d.run(500);
    const double before = d.used(7, LifeKind::Minutes);
    d.run(3000);
    // what was counted and not yet told
    EXPECT_NEAR(d.used(7, LifeKind::Minutes), before, 1.1 / 60);
    d.rig.start(1);
    d.run(3000);
    EXPECT_NEAR(d.used(7, LifeKind::Minutes) * 60, 2.15, 0.1);
}

TEST(ToolClient, DistanceCountsTheWayCut) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Metres, 10)};
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.line(1, {30, -40}, 50));
    d.rig.push(1, d.rig.line(1, {0, 100}, 0, kRapid));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(5000);
    EXPECT_NEAR(d.used(7, LifeKind::Metres), 0.050, 0.0002);
}

TEST(ToolClient, APieceCountsForEachToolThatHasWorkedOnIt) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Pieces, 10),
               Context::tool(8, 5, LifeKind::Pieces, 10)};
    for (const int tool : {7, 8, 7}) {
        d.rig.push(1, d.rig.aux(1, 'T', tool));
        d.rig.push(1, d.rig.line(1, {0, -1}, 50));
    }
    d.rig.push(1, d.rig.blank(1, RecordKind::Part));
    d.rig.push(1, d.rig.line(1, {0, -1}, 50));
    d.rig.push(1, d.rig.blank(1, RecordKind::Part));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(3000);
    EXPECT_EQ(d.used(7, LifeKind::Pieces), 2);
    EXPECT_EQ(d.used(8, LifeKind::Pieces), 1);
    // The next part begins with another tool: the one that still stood in work has no share in it.
    d.rig.push(1, d.rig.aux(1, 'T', 8));
    d.rig.push(1, d.rig.line(1, {0, -1}, 50));
    d.rig.push(1, d.rig.blank(1, RecordKind::Part));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(1000);
    EXPECT_EQ(d.used(7, LifeKind::Pieces), 2);
    EXPECT_EQ(d.used(8, LifeKind::Pieces), 2);
}

// SETPIECE (sinumerik_part3 7.5): what it has counted, the end of the part counts no more.
TEST(ToolClient, CountsThePiecesThatAProgramTellsOnce) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Pieces, 10),
               Context::tool(8, 5, LifeKind::Pieces, 10)};
    PathRecord told = d.rig.blank(1, RecordKind::ToolData);
    told.mask = 0;
    told.value = 3;
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.line(1, {0, -20}, 50));
    d.rig.push(1, told);  // in the tick in which the cut has ended
    d.rig.push(1, d.rig.aux(1, 'T', 8));
    d.rig.push(1, d.rig.line(1, {0, 20}, 50));
    d.rig.push(1, d.rig.blank(1, RecordKind::Part));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(4000);
    EXPECT_EQ(d.rig.state(1), ChannelState::Ended);
    EXPECT_EQ(d.used(7, LifeKind::Pieces), 3);
    EXPECT_EQ(d.used(8, LifeKind::Pieces), 1);
}

// A restart passes a T: the store is asked, the PLC hears nothing; the tool that it names is the
// one whose offset counts until the real T.
TEST(ToolClient, ATThatARestartPassesIsOnlyLookedUp) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::None, kEver),
               Context::tool(8, 5, LifeKind::None, kEver)};
    const auto passed = [&](char letter, double value) {
        PathRecord r = d.rig.aux(1, letter, value);
        r.plane[2] = 1;
        return r;
    };
    d.rig.push(1, passed('T', 8));
    d.rig.push(1, passed('T', 7));
    d.rig.push(1, d.rig.dwell(1, 0.5));
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(150);
    EXPECT_EQ(d.nc(signals::cn_tstr), 0);
    MachineStatus status;
    ASSERT_TRUE(d.rig.kernel->status.read(status));
    EXPECT_EQ(status.channels[0].tool, 7);
    EXPECT_EQ(status.channels[0].tool_offset, 17);
    d.run(1500);
    EXPECT_EQ(d.nc(signals::cn_tstr), 1);
    EXPECT_EQ(d.rig.state(1), ChannelState::Ended);
}

TEST(ToolClient, AnotherSisterThanTheRestartHasSeenIsAnAlarm) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::None, kEver),
               Context::tool(8, 5, LifeKind::None, kEver)};
    PathRecord passed = d.rig.aux(1, 'T', 7);
    passed.plane[2] = 1;
    d.rig.push(1, passed);
    d.rig.push(1, d.rig.aux(1, 'T', 8));
    d.rig.start(1);
    d.run(300);
    EXPECT_TRUE(d.rig.alarmed(Alarm::ToolNotFound, 1));
    EXPECT_EQ(d.nc(signals::cn_tstr), 0);
    d.rig.command(CommandKind::Reset, 1);  // forgotten with it
    d.run(100);
    d.rig.push(1, d.rig.aux(1, 'T', 8));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(300);
    EXPECT_EQ(d.nc(signals::cn_tstr), 1);
}

TEST(ToolClient, WarnsStrictlyBelowTheWarningOfToolOrGroup) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Pieces, 3, 2)};
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    for (int part = 0; part < 3; ++part) {
        d.rig.push(1, d.rig.line(1, {0, -10}, 50));
        d.rig.push(1, d.rig.blank(1, RecordKind::Part));
    }
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    std::vector<std::array<int, 3>> seen;  // SN_TLNL CN_TLNL CN_TLEND after each part
    for (int i = 0, parts = 0; i < 5000; ++i) {
        d.rig.tick();
        MachineStatus status;
        ASSERT_TRUE(d.rig.kernel->status.read(status));
        if (static_cast<int>(status.channels[0].parts) > parts) {
            ++parts;
            seen.push_back(
                {d.nc(signals::sn_tlnl), d.nc(signals::cn_tlnl), d.nc(signals::cn_tlend)});
        }
    }
    ASSERT_EQ(seen.size(), 3u);
    EXPECT_EQ(seen[0], (std::array<int, 3>{0, 0, 0}));  // 2 left: equal does not switch
    EXPECT_EQ(seen[1], (std::array<int, 3>{1, 1, 0}));
    EXPECT_EQ(seen[2], (std::array<int, 3>{1, 1, 1}));
    EXPECT_TRUE(d.rig.alarmed(Alarm::ToolLifeNear, 1));
    EXPECT_TRUE(d.rig.alarmed(Alarm::ToolLifeOver, 1));
}

TEST(ToolClient, TlnLooksAtTheWholeGroup) {
    Context d([](params::Table& t) { params::put(t, params::n2900_tool_m_config, 3); });
    d.tools = {Context::tool(7, 4, LifeKind::Pieces, 1, 2)};
    d.tools[0].group_left = 20;
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.dwell(1, 1));
    d.rig.start(1);
    d.run(300);
    EXPECT_EQ(d.nc(signals::sn_tlnl), 0);  // one piece is left of the tool, twenty of the group
}

TEST(ToolClient, TheEndOfLifeActsAsTheParameterSays) {
    for (const int end : {0, 1, 2, 3}) {
        SCOPED_TRACE(end);
        Context d([&](params::Table& t) { params::put(t, params::pt_life_end, end, 1); });
        d.tools = {Context::tool(7, 4, LifeKind::Minutes, 1.0 / 60)};
        d.rig.push(1, d.rig.aux(1, 'T', 7));
        d.rig.push(1, d.rig.line(1, {0, -150}, 50));
        d.rig.push(1, d.rig.stop(1, StopReason::M30));
        d.rig.start(1);
        d.run(6000);
        EXPECT_EQ(d.nc(signals::cn_tlend), 1);
        EXPECT_EQ(d.rig.alarmed(Alarm::ToolLifeOver, 1), end != 3);
        EXPECT_EQ(d.rig.state(1), end == 2 ? ChannelState::Held : ChannelState::Ended);
        if (end == 2) { EXPECT_NEAR(d.rig.position(2), -51.5, 2.0); }
    }
}

TEST(ToolClient, AResetOfTheLifeIsNewsOfTheToolAtWork) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::Pieces, 0, 1)};
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.dwell(1, 1));
    d.rig.start(1);
    d.run(200);
    EXPECT_EQ(d.nc(signals::cn_tlend), 1);
    ToolAnswer news = Context::tool(7, 4, LifeKind::Pieces, 50, 1);
    news.alarm = kToolChanges;
    news.channel = 1;
    d.say(news);
    d.run(2);
    EXPECT_EQ(d.nc(signals::cn_tlend), 0);
    EXPECT_EQ(d.nc(signals::sn_tlnl), 0);
}

TEST(ToolClient, AToolForASpindleWorksAfterM06UnlessTlcSaysT) {
    for (const bool by_t : {false, true}) {
        SCOPED_TRACE(by_t);
        Context d([&](params::Table& t) {
            params::put(t, params::n2901_search_config, by_t ? 6 : 4, 1);
        });
        d.tools = {Context::tool(7, 4, LifeKind::Metres, 10)};
        d.tools[0].spindle_place = 1;
        d.rig.push(1, d.rig.aux(1, 'T', 7));
        d.rig.push(1, d.rig.line(1, {0, -20}, 50));
        d.rig.push(1, d.rig.aux(1, 'M', 6));
        d.rig.push(1, d.rig.line(1, {0, -30}, 50));
        d.rig.push(1, d.rig.stop(1, StopReason::M30));
        d.rig.start(1);
        d.run(4000);
        ASSERT_EQ(d.rig.state(1), ChannelState::Ended);
        EXPECT_NEAR(d.used(7, LifeKind::Metres), by_t ? 0.050 : 0.030, 0.0002);
    }
}

TEST(ToolClient, AQuestionThatAStoreTookWithItIsAskedOfItsSuccessor) {
    Context d;
    d.tools = {Context::tool(7, 4, LifeKind::None, kEver)};
    d.answers = false;
    d.rig.push(1, d.rig.aux(1, 'T', 7));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(8);
    d.read = d.rig.kernel->persist.head.load();  // the dead one had taken it and not answered
    d.rig.store->persist_tail.tail.store(d.read);
    d.rig.machine->core().tools.rebind(*d.rig.kernel, *d.rig.store);
    d.answers = true;
    d.run(200);
    EXPECT_EQ(d.rig.state(1), ChannelState::Ended);
    EXPECT_EQ(d.nc(signals::cn_potno), 4);
}

PathRecord wear(TickRig& rig, int number, double value) {
    PathRecord r = rig.blank(1, RecordKind::Offset);
    r.mask = static_cast<std::uint32_t>(number);
    r.value = value;
    return r;
}

// Writes fly: the path does not stop for them, and with tool management each of them is a question
// with an answer of its own.
TEST(ToolClient, KeepsEveryWriteOfAProgramHoweverManyTheyAre) {
    Context d;
    constexpr int kWrites = 200;
    for (int i = 1; i <= kWrites; ++i) d.rig.push(1, wear(d.rig, i, 0.001 * i));
    d.rig.push(1, d.rig.stop(1, StopReason::M30));
    d.rig.start(1);
    d.run(100);
    ASSERT_EQ(d.rig.state(1), ChannelState::Ended);
    std::vector<int> numbers;
    for (const StoreRequest& q : d.asked)
        if (static_cast<StoreRequestKind>(q.kind) == StoreRequestKind::OffsetValue)
            numbers.push_back(q.number);
    ASSERT_EQ(numbers.size(), kWrites);
    for (int i = 0; i < kWrites; ++i) EXPECT_EQ(numbers[static_cast<std::size_t>(i)], i + 1);
}

// In real time nobody waits for the store. A path that would write more than the ring holds stands
// until it is back.
TEST(ToolClient, AStoreThatIsAwayStopsThePathBeforeAWriteWouldBeLost) {
    Context d;
    d.rig.machine->core().virtual_time = false;
    d.answers = false;
    constexpr int kWrites = 9000;  // the ring holds 8192
    int pushed = 0;
    const auto feed = [&] {
        for (; pushed < kWrites &&
               d.rig.channel[0]->path.head.load() - d.rig.kernel->path_tail[0].tail.load() < 1000;
             ++pushed)
            d.rig.push(1, wear(d.rig, pushed % 900 + 1, pushed));
    };
    feed();
    d.rig.start(1);
    for (int i = 0; i < 400; ++i) {
        feed();
        d.rig.tick();
    }
    EXPECT_LT(d.rig.kernel->persist.head.load(), 8192U);
    EXPECT_LT(pushed, kWrites);
    d.answers = true;
    for (int i = 0; i < 400; ++i) {
        feed();
        d.rig.tick();
    }
    ASSERT_EQ(pushed, kWrites);
    int next = 0;
    for (const StoreRequest& q : d.asked) {
        if (static_cast<StoreRequestKind>(q.kind) != StoreRequestKind::OffsetValue) continue;
        EXPECT_EQ(q.value, next++);
    }
    EXPECT_EQ(next, kWrites);
}

TEST(CommandLevels, TheKernelRefusesWhatTheSupervisorShouldNotHaveSent) {
    TickRig rig;
    const auto command = [&](CommandKind kind, unsigned level) {
        rig.command(kind, 1, 1);
        auto& ring = rig.supervisor->commands;
        ring.slot(ring.head.load() - 1).level = level + 1;
    };
    rig.push(1, rig.dwell(1, 5));
    command(CommandKind::CycleStart, 0);  // looking is all that this one may do
    rig.run(20);
    EXPECT_TRUE(rig.alarmed(Alarm::LevelTooLow, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    command(CommandKind::CycleStart, 1);
    rig.run(20);
    EXPECT_EQ(rig.state(1), ChannelState::Running);
    command(CommandKind::FeedHold, 0);  // stopping a machine needs no level
    rig.run(50);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
}

}  // namespace
}  // namespace polyturn::kernel
