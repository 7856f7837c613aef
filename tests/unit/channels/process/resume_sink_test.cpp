// A block goes on in its middle with other offsets; a program is restarted at a block.
#include "channels/hold/resume_sink.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "channels/hold/approach.hpp"
#include "channels/hold/operator_changes.hpp"
#include "channels/hold/restart_sink.hpp"
#include "ipc/image/segments.hpp"

namespace polyturn::channels {
namespace {

struct Seen final : Sink {
    std::vector<Move> moves;
    std::vector<std::string> aux_texts, messages;
    std::vector<StopReason> stops;
    std::vector<Spindle> spindles;
    std::vector<std::uint32_t> waits, parts;
    void move(const Move& m, const BlockContext& at) override {
        moves.push_back(m);
        parts.push_back(at.part);
    }
    void dwell(const Dwell&, const BlockContext&) override {}
    void aux(const Aux& a, const BlockContext&) override { aux_texts.emplace_back(a.text); }
    void spindle(const Spindle& s, const BlockContext&) override { spindles.push_back(s); }
    void wait(const Wait& w, const BlockContext&) override { waits.push_back(w.channels); }
    void variable(const Variable&, const BlockContext&) override {}
    void offset(const OffsetWrite&, const BlockContext&) override {}
    void message(std::string_view text, const BlockContext&) override {
        messages.emplace_back(text);
    }
    void stop(const Stop& s, const BlockContext&) override { stops.push_back(s.reason); }
    void part(double, const BlockContext&) override {}
    void alarm(const Diagnosis&, const BlockContext&) override {}
    void barrier(const BlockContext&) override {}
    void block_end(const BlockContext&) override {}
};

struct Bench {
    std::unique_ptr<params::Table> table = std::make_unique<params::Table>();
    std::unique_ptr<MachineView> view;
    Seen seen;
    Bench() {
        params::set_defaults(*table);
        params::put(*table, params::n0000_machine_group, 1, 1);
        params::put(*table, params::n0002_axis_assign, 1, 1);
        params::put(*table, params::n0100_axis_name1, 'X', 1);
        params::put(*table, params::n0103_axis_to_plane, 1, 1);
        params::put(*table, params::n0002_axis_assign, 1, 2);
        params::put(*table, params::n0100_axis_name1, 'Z', 2);
        params::put(*table, params::n0103_axis_to_plane, 3, 2);
        view.reset(new MachineView(make_machine_view(*table, 1)));
    }
};

Move line(AxisValues from, AxisValues to) {
    Move m;
    m.kind = MoveKind::Linear;
    m.feed_mode = FeedMode::PerMinute;
    m.feed = 300;
    m.machine_start = from;
    m.machine = m.pos = to;
    for (unsigned i = 0; i < 2; ++i)
        if (from[i] != to[i]) m.moved |= 1u << i;
    return m;
}

BlockContext block(std::uint64_t serial, std::int64_t number = -1) {
    BlockContext at;
    at.serial = serial;
    at.block = number;
    return at;
}

TEST(ResumeSink, NumbersWhatABlockCauses) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    sink.move(line({0, 0}, {1, 0}), block(1));
    sink.move(line({1, 0}, {2, 0}), block(1));
    sink.move(line({2, 0}, {3, 0}), block(2));
    EXPECT_EQ(b.seen.parts, (std::vector<std::uint32_t>{1, 2, 1}));
}

// Held at Z-4 of Z0 to Z-10; X has become 0.5 greater: a short step at feed to the new line, then
// the rest of it.
TEST(ResumeSink, GoesOnFromTheNearestPointOfTheNewPath) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    sink.go_back(7, 2, true, {20, -4}, {20, -4});
    sink.move(line({30.5, 0}, {20.5, 0}), block(7));  // executed
    sink.move(line({20.5, 0}, {20.5, -10}), block(7));
    sink.move(line({20.5, -10}, {25, -10}), block(8));
    ASSERT_EQ(b.seen.moves.size(), 3u);
    EXPECT_EQ(b.seen.moves[0].machine_start[0], 20);
    EXPECT_EQ(b.seen.moves[0].machine[0], 20.5);
    EXPECT_EQ(b.seen.moves[0].machine[1], -4);
    EXPECT_EQ(b.seen.moves[0].kind, MoveKind::Linear);
    EXPECT_EQ(b.seen.moves[1].machine_start[0], 20.5);
    EXPECT_EQ(b.seen.moves[1].machine_start[1], -4);
    EXPECT_EQ(b.seen.moves[1].machine[1], -10);
    EXPECT_EQ(b.seen.moves[2].machine[0], 25);
}

TEST(ResumeSink, NeverGoesBackAlongThePath) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    sink.go_back(7, 1, true, {20, -4}, {20, -4});
    sink.move(line({20, -1}, {20, -11}), block(7));  // the zero went 1 mm along Z
    ASSERT_EQ(b.seen.moves.size(), 1u);
    EXPECT_EQ(b.seen.moves[0].machine_start[1], -4);
    EXPECT_EQ(b.seen.moves[0].machine[1], -11);
}

TEST(ResumeSink, DrivesAPartThatHasNotBegunFromItsBeginning) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    sink.go_back(7, 1, false, {20, 0}, {20, 0});
    sink.move(line({20, 1}, {20, -9}), block(7));
    ASSERT_EQ(b.seen.moves.size(), 2u);
    EXPECT_EQ(b.seen.moves[0].machine[1], 1);
    EXPECT_EQ(b.seen.moves[1].machine_start[1], 1);
}

TEST(ResumeSink, KeepsTheRestOfAnArc) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    // A quarter circle about (10, 0) from (10, 5) to (15, 0), X first axis; held half way; X has
    // grown by 0.1.
    const double h = 5 * std::numbers::sqrt2 / 2;
    sink.go_back(3, 1, true, {10 + h, h}, {10 + h, h});
    Move arc = line({10.1, 5}, {15.1, 0});
    arc.kind = MoveKind::ArcCw;
    arc.plane_p = 1;
    arc.plane_q = 0;
    arc.centre_p = 0;
    arc.centre_q = 10.1;
    arc.radius = arc.radius_end = 5;
    arc.sweep = std::numbers::pi / 2;
    sink.move(arc, block(3));
    ASSERT_EQ(b.seen.moves.size(), 2u);
    const Move& rest = b.seen.moves[1];
    EXPECT_EQ(rest.kind, MoveKind::ArcCw);
    EXPECT_NEAR(std::hypot(rest.machine_start[0] - 10.1, rest.machine_start[1]), 5, 1e-9);
    EXPECT_NEAR(rest.sweep, std::numbers::pi / 4, 0.03);
    EXPECT_EQ(rest.machine[0], 15.1);
}

// A curve over (1, -4) and (3, -7): what it has passed at the nearest point is left out.
TEST(ResumeSink, KeepsTheRestOfACurve) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    sink.go_back(3, 1, true, {2, -5.5}, {2, -5.5});
    Move curve = line({0, 0}, {6, -9});
    curve.through =
        std::make_shared<std::vector<AxisValues>>(std::vector<AxisValues>{{1, -4}, {3, -7}});
    sink.move(curve, block(3));
    ASSERT_EQ(b.seen.moves.size(), 1u);
    const Move& rest = b.seen.moves[0];
    EXPECT_EQ(rest.machine_start[0], 2);
    EXPECT_EQ(rest.machine_start[1], -5.5);
    ASSERT_EQ(rest.through->size(), 1u);
    EXPECT_EQ((*rest.through)[0][0], 3);
    EXPECT_EQ(rest.machine[0], 6);
}

TEST(ResumeSink, ComesBackInOrderWhenTheAxesWereMovedAway) {
    Bench b;
    ResumeSink sink(*b.view, b.seen);
    sink.go_back(7, 1, true, {60, 30}, {20, -4});
    sink.move(line({20, 0}, {20, -10}), block(7));
    ASSERT_EQ(b.seen.moves.size(), 3u);
    EXPECT_EQ(b.seen.moves[0].moved, 2u) << "Z first, the cross axis behind";
    EXPECT_EQ(b.seen.moves[0].kind, MoveKind::Rapid);
    EXPECT_EQ(b.seen.moves[1].moved, 1u);
    EXPECT_EQ(b.seen.moves[2].machine_start[1], -4);
}

TEST(Approach, FollowsTheOrderOfTheParameter) {
    Bench b;
    params::put(*b.table, params::pt_restart_order, 1, 1);
    params::put(*b.table, params::pt_restart_order, 2, 2);
    b.view.reset(new MachineView(make_machine_view(*b.table, 1)));
    EXPECT_EQ(approach_order(*b.view, {0, 0}, {1, 1}), (std::vector<AxisSet>{1u, 2u}));
    EXPECT_EQ(approach_order(*b.view, {0, 0}, {0, 1}), (std::vector<AxisSet>{2u}));
    EXPECT_TRUE(approach_order(*b.view, {1, 1}, {1, 1}).empty());
}

TEST(RestartSink, GathersAndThenShowsStopsAndApproaches) {
    Bench b;
    b.view->start = {100, 50};
    RestartSink sink(*b.view, b.seen);
    sink.search(30, 1);
    sink.aux({'T', 101, "T0101", false, false, false, {}, {}}, block(1, 10));
    sink.aux({'M', 8, "M8", false, false, false, {}, {}}, block(2, 12));
    sink.aux({'T', 303, "T0303", false, false, false, {}, {}}, block(3, 14));
    sink.aux({'M', 9, "M9", false, false, false, {}, {}}, block(4, 16));
    Spindle s;
    s.value = 800;
    sink.spindle(s, block(5, 18));
    s.value = 1200;
    sink.spindle(s, block(6, 19));
    sink.move(line({100, 50}, {30, 2}), block(7, 20));
    Wait w;
    w.code = 501;
    w.channels = 3;
    sink.wait(w, block(8, 22));
    EXPECT_TRUE(b.seen.moves.empty());
    EXPECT_TRUE(b.seen.waits.empty()) << "the partner does not restart";
    EXPECT_EQ(sink.position(0), 30);
    sink.move(line({30, 2}, {30, -40}), block(9, 30));
    EXPECT_FALSE(sink.searching());
    EXPECT_EQ(b.seen.aux_texts, (std::vector<std::string>{"T0303", "M9"}));
    ASSERT_EQ(b.seen.spindles.size(), 1u);
    EXPECT_EQ(b.seen.spindles[0].value, 1200);
    EXPECT_EQ(b.seen.stops, (std::vector<StopReason>{StopReason::Restart}));
    ASSERT_EQ(b.seen.messages.size(), 1u);
    EXPECT_NE(b.seen.messages[0].find("T0303"), std::string::npos) << b.seen.messages[0];
    ASSERT_EQ(b.seen.moves.size(), 3u) << "Z, X, and the block";
    EXPECT_EQ(b.seen.moves[0].machine[1], 2);
    EXPECT_EQ(b.seen.moves[0].machine[0], 100);
    EXPECT_EQ(b.seen.moves[1].machine[0], 30);
    EXPECT_EQ(b.seen.moves[2].machine[1], -40);
}

TEST(RestartSink, ReplaysWaitsOfChannelsThatRestartToo) {
    Bench b;
    RestartSink sink(*b.view, b.seen);
    sink.search(30, 0b11);
    Wait w;
    w.code = 501;
    w.channels = 0b111;
    sink.wait(w, block(1, 10));
    EXPECT_EQ(b.seen.waits, (std::vector<std::uint32_t>{0b11}));
}

TEST(RestartSink, LoadsTheToolBeforeTheLastM6AndPreparesTheNext) {
    Bench b;
    params::put(*b.table, params::n1338_block_no_search, 1, 1);
    b.view.reset(new MachineView(make_machine_view(*b.table, 1)));
    RestartSink sink(*b.view, b.seen);
    sink.search(30, 1);
    for (const auto& [letter, value, text] :
         std::initializer_list<std::tuple<char, double, const char*>>{{'T', 1, "T1"},
                                                                      {'M', 6, "M6"},
                                                                      {'T', 2, "T2"},
                                                                      {'M', 6, "M6"},
                                                                      {'T', 3, "T3"},
                                                                      {'T', 4, "T4"}})
        sink.aux({letter, value, text, false, false, false, {}, {}}, block(1, 10));
    sink.block_read(block(2, 30));
    EXPECT_EQ(b.seen.aux_texts, (std::vector<std::string>{"T2", "M6", "T4"}));
}

TEST(OperatorChanges, KnowsWhatTheProgramHasWrittenItself) {
    auto store = std::make_unique<ChannelStore>();
    OperatorChanges changes;
    changes.begin(*store);
    EXPECT_FALSE(changes.look(*store));
    OffsetWrite own;
    own.store_table = OffsetTable::Wear;
    own.field = OffsetField::Z;
    own.number = 3;
    own.value = 0.25;
    changes.wrote(own);
    store->offsets[3].wear[2] = 0.25;
    EXPECT_FALSE(changes.look(*store));
    store->offsets[3].wear[2] = 0.3;
    EXPECT_TRUE(changes.look(*store));
    EXPECT_FALSE(changes.look(*store)) << "once";
    store->zeros[kZeroG54 * kChannelAxes] = 1;
    EXPECT_TRUE(changes.look(*store));
}

}  // namespace
}  // namespace polyturn::channels
