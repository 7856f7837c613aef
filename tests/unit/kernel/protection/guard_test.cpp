#include <algorithm>

#include "ipc/image/block_pictures.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// Two carriers of 20 x 20 mm that share the room's X and Z; N2000 of both on. L1 stands at X 100,
// L2 at X 0.
struct TwoCarriers {
    TickRig rig;
    explicit TwoCarriers(const std::function<void(params::Table&)>& more = {})
        : rig([&](params::Table& t, RunOptions& o) {
              params::put(t, params::n0103_axis_to_plane, 1, 1);
              params::put(t, params::n0103_axis_to_plane, 3, 2);
              params::put(t, params::n0103_axis_to_plane, 1, 3);
              params::put(t, params::n0103_axis_to_plane, 3, 4);
              o.start_known[0] = 1;
              o.start_position[0] = 100;
              if (more) more(t);
          }) {
        Room room;
        for (unsigned a = 1; a <= 4; ++a)
            room.axes[a] = {{}, a % 2 ? RoomVector{1, 0, 0} : RoomVector{0, 0, 1}};
        room.turrets[1].body = room.turrets[2].body = {{-10, 10, -10, 10}};
        rig.machine->take_room(room, derive_machine_config(rig.machine->core().table));
        for (unsigned l = 1; l <= 2; ++l)
            params::put(rig.machine->core().table, params::n2000_check_config, 15, l);
        rig.machine->adopt_parameters();
        rig.place(1, 0, 100);
    }
};

TEST(Guard, StopsACarrierBeforeItTouchesTheOther) {
    TwoCarriers m;
    m.rig.push(1, m.rig.line(1, {-100, 0}, 100));
    m.rig.start(1);
    m.rig.run(3000);
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
    EXPECT_GE(m.rig.position(1), 21.0);  // 20 mm of bodies and PT_GUARD_DISTANCE
    EXPECT_LE(m.rig.position(1), 23.0);
    const KernelEvent* e = nullptr;
    for (const KernelEvent& event : m.rig.log)
        if (event.code == static_cast<int>(Alarm::GuardStop)) e = &event;
    ASSERT_NE(e, nullptr);
    EXPECT_STREQ(e->text.data(), "tool carrier of L1 and tool carrier of L2");
}

// What is not guarded is said, never left out in silence.
TEST(Guard, TellsWhichShapesItHasNoRoomFor) {
    TwoCarriers m;
    m.rig.run(5);
    EXPECT_FALSE(m.rig.alarmed(Alarm::GuardConfig));
    Room room;
    for (unsigned a = 1; a <= 4; ++a)
        room.axes[a] = {{}, a % 2 ? RoomVector{1, 0, 0} : RoomVector{0, 0, 1}};
    room.turrets[1].body.assign(4000, {-10, 10, -10, 10});
    m.rig.machine->take_room(room, derive_machine_config(m.rig.machine->core().table));
    m.rig.machine->adopt_parameters();
    m.rig.run(5);
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardConfig));
    EXPECT_EQ(std::count_if(m.rig.log.begin(), m.rig.log.end(),
                            [](const KernelEvent& e) {
                                return e.code == static_cast<int>(Alarm::GuardConfig);
                            }),
              1);
}

// Eight turrets of 24 stations with three boxes each: the last one guards as the first does.
TEST(Guard, HoldsTheToolsOfAllTurrets) {
    TwoCarriers m;
    auto shapes = std::make_unique<ToolShapes>();
    for (std::uint32_t l = 3; l <= 9; ++l)
        for (std::uint32_t station = 1; station <= 24; ++station)
            for (int i = 0; i < 3; ++i)
                shapes->shapes[shapes->count++] = {l, station, -1, 1, -1, 1};
    // a tool that looks 30 mm out of its carrier
    shapes->shapes[shapes->count++] = {2, 1, 10, 40, -5, 5};
    m.rig.machine->take_tool_shapes(*shapes);
    m.rig.machine->adopt_parameters();
    m.rig.push(2, m.rig.aux(2, 'T', 1));
    m.rig.push(2, m.rig.stop(2, StopReason::M30));
    m.rig.start(2);
    m.rig.run(100);
    m.rig.push(1, m.rig.line(1, {-100, 0}, 100));
    m.rig.start(1);
    m.rig.run(3000);
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
    EXPECT_GE(m.rig.position(1), 51.0);
    EXPECT_LE(m.rig.position(1), 53.0);
}

// The turret of L1 has twelve stations on a radius of 100 mm behind the carrier's point; the tool
// of station 2 reaches 80 mm out.
struct Turret : TwoCarriers {
    explicit Turret(double reach, int station_in_work = 1) {
        Room room;
        for (unsigned a = 1; a <= 4; ++a)
            room.axes[a] = {{}, a % 2 ? RoomVector{1, 0, 0} : RoomVector{0, 0, 1}};
        room.turrets[1].body = room.turrets[2].body = {{-10, 10, -10, 10}};
        room.turrets[1].stations = 12;
        room.turrets[1].reach = reach;
        room.turrets[1].direction = {-1, 0, 0};
        room.turrets[1].tools[2] = {{-80, -10, -5, 5}};
        rig.machine->take_room(room, derive_machine_config(rig.machine->core().table));
        rig.machine->adopt_parameters();
        rig.machine->core().signals.force_plc(signals::cp_actt(1), station_in_work);
    }
    double stops_at() {
        rig.push(1, rig.line(1, {-100, 0}, 100));
        rig.start(1);
        rig.run(3000);
        EXPECT_TRUE(rig.alarmed(Alarm::GuardStop, 1));
        return rig.position(1);
    }
};

TEST(Guard, WatchesTheToolsOfTheOtherStationsWhereTheTurretHasTurnedThem) {
    // From the axis the tool goes from 110 to 180 mm and is 10 mm wide: turned by 30 degrees it
    // reaches 180 cos 30 + 5 sin 30.
    const double ahead = 180 * std::cos(M_PI / 6) + 2.5 - 100;
    Turret near(100), unknown(0), opposite(100, 8), in_place(100, 2), away(100, 5);
    EXPECT_NEAR(near.stops_at(), 11 + ahead, 1.5);
    EXPECT_NEAR(unknown.stops_at(), 21, 2);   // where the axis is nobody has said: in work only
    EXPECT_NEAR(opposite.stops_at(), 21, 2);  // it looks the other way
    EXPECT_NEAR(away.stops_at(), 21, 2);      // a quarter of a turn away: behind the body
    // turned into work, whatever T the program has called
    EXPECT_NEAR(in_place.stops_at(), 91, 2);
}

// N0421 ROL: where L1 stands, on its rapid way from X 100 to 250, when its T reaches the PLC. It
// brakes from 200 mm/s with 2000 mm/s2 and 40 000 mm/s3, which takes 15 mm. The circle of the tool
// has the radius 180.07 about an axis 100 mm behind the carrier's point: it reaches 80.07 mm in
// front of that. Its station looks away from the part, so only a turning turret comes near the
// other carrier, which stands 30 mm beside the way of the body: the tool is as wide.
struct EarlyTurret : Turret {
    double given_at = -1;
    bool open_in_rapid = false;
    explicit EarlyTurret(bool overlaps, double other_at = -200, std::uint32_t protection = 15,
                         double share = 100)
        : Turret(100, 8) {
        Room room;
        for (unsigned a = 1; a <= 4; ++a)
            room.axes[a] = {{}, a % 2 ? RoomVector{1, 0, 0} : RoomVector{0, 0, 1}};
        room.turrets[1].body = room.turrets[2].body = {{-10, 10, -10, 10}};
        room.turrets[1].stations = 12;
        room.turrets[1].reach = 100;
        room.turrets[1].direction = {-1, 0, 0};
        room.turrets[1].tools[2] = {{-80, -10, -5, 40}};
        rig.machine->take_room(room, derive_machine_config(rig.machine->core().table));
        params::put(rig.machine->core().table, params::n0421_acc_contr, overlaps ? 1 : 0, 1);
        for (unsigned a = 1; a <= 2; ++a)
            params::put(rig.machine->core().table, params::n0422_rapid_reduct_ratio, share, a);
        params::put(rig.machine->core().table, params::n2000_check_config, protection, 1);
        rig.machine->adopt_parameters();
        rig.place(2, 0, 0);
        rig.push(2, rig.line(2, {0, 30}, 100));
        // the other carrier goes out of the way, or into it
        rig.push(2, rig.line(2, {other_at, 0}, 100));
        rig.push(2, rig.stop(2, StopReason::M30));
        rig.start(2);
        rig.run(6000);
        // a turret that turns for half a second
        rig.plc_program = [this, done = 0, since = 0](const PlcInputs& in,
                                                      PlcOutputs& out) mutable {
            TickRig::lathe(in, out);
            const int asked = in.signal[signals::cn_tstr(1)];
            if (asked != done && ++since > 50) {
                done = asked;
                since = 0;
            }
            out.signal[signals::cp_tfin(1)] = done;
            out.signal[signals::cp_turretopen(1)] = asked != done;
        };
        rig.push(1, rig.line(1, {150, 0}, 0, kRapid));
        rig.push(1, serial(rig.aux(1, 'T', 2)));
        rig.push(1, serial(rig.stop(1, StopReason::M30)));
        rig.start(1);
        for (int i = 0; i < 4000; ++i) {
            rig.tick();
            if (given_at < 0 && rig.machine->core().signals.nc(signals::cn_tstr(1)) != 0)
                given_at = rig.position(1);
            open_in_rapid =
                open_in_rapid || (rig.speed_of(1) > 1 &&
                                  rig.machine->core().signals.plc(signals::cp_turretopen(1)) != 0);
        }
        EXPECT_EQ(rig.state(1), ChannelState::Ended);
        EXPECT_FALSE(rig.alarmed(Alarm::InterlockStop, 1));
    }
    PathRecord serial(PathRecord r) {
        r.serial = ++serial_;
        return r;
    }
    std::uint64_t serial_ = 0;
};

TEST(Guard, LetsTheTurretTurnWhileTheRapidMoveBrakes) {
    EarlyTurret overlapped(true), never(false), late(true, -200, 15, 30);
    EXPECT_NEAR(overlapped.given_at, 250 - 15, 2.5);
    EXPECT_TRUE(overlapped.open_in_rapid);
    EXPECT_NEAR(never.given_at, 250, 1e-6);
    EXPECT_FALSE(never.open_in_rapid);
    EXPECT_GT(late.given_at, 244);  // below 60 mm/s only
    EXPECT_LT(late.given_at, 250);
}

// The other carrier's body ends 10 mm above where that stands; PT_GUARD_DISTANCE is 1 mm. The
// circle has half the tool's width in its radius.
TEST(Guard, ATurretTurnsInRapidOnlyWhileItsCircleIsFree) {
    EarlyTurret just_free(true, 138), beside(true, 148), in_the_way(true, 165),
        unguarded(true, 165, 0);
    const double ahead = std::hypot(180, 22.5) - 100;
    EXPECT_NEAR(just_free.given_at, 235, 2.5);
    EXPECT_NEAR(beside.given_at, 148 + 11 + ahead, 1.0);  // free a little later
    EXPECT_NEAR(in_the_way.given_at, 250, 1e-6);          // it stays within the circle to the end
    EXPECT_NEAR(unguarded.given_at, 235, 2.5);            // nobody protects: ROL alone says it
    EXPECT_EQ(just_free.rig.position(3), 138);
    EXPECT_EQ(in_the_way.rig.position(3), 165);
}

TEST(Guard, GivesATurretThatTurnsItsWholeCircle) {
    Turret m(100, 8);
    m.rig.machine->core().signals.force_plc(signals::cp_turretopen(1), 1);
    // A start is refused while the turret is open, so a hand moves it.
    m.rig.run(25);
    m.rig.command(CommandKind::Jog, 0, -5, 0, 1);
    m.rig.run(6000);
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
    EXPECT_NEAR(m.rig.position(1), 11 + std::hypot(180, 5) - 100, 2);
}

TEST(Guard, StopsBothWhenBothMove) {
    TwoCarriers m;
    m.rig.push(1, m.rig.line(1, {-90, 0}, 150));
    m.rig.push(2, m.rig.line(2, {90, 0}, 150));
    m.rig.start(1);
    m.rig.start(2);
    m.rig.run(3000);
    EXPECT_GE(m.rig.position(1) - m.rig.position(3), 21.0);
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 2));
}

TEST(Guard, LetsThemPassBesideEachOtherAndAwayAgain) {
    TwoCarriers m;
    m.rig.push(1, m.rig.line(1, {0, 40}, 100));
    m.rig.push(1, m.rig.line(1, {-150, 0}, 150));
    m.rig.start(1);
    m.rig.run(4000);
    EXPECT_FALSE(m.rig.alarmed(Alarm::GuardStop));
    EXPECT_NEAR(m.rig.position(1), -50, 1e-9);
}

TEST(Guard, WatchesTheHandTooAndLeavesTheWayBackFree) {
    TwoCarriers m;
    m.rig.run(25);                                 // the PLC has set the jog feed
    m.rig.command(CommandKind::Jog, 0, -5, 0, 1);  // X of L1 downwards for 5 s
    m.rig.run(6000);
    EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
    EXPECT_GE(m.rig.position(1), 21.0);
    EXPECT_LE(m.rig.position(1), 23.0);
    const double stood = m.rig.position(1);
    m.rig.command(CommandKind::Step, 0, 5, 0, 1);
    m.rig.run(1000);
    EXPECT_NEAR(m.rig.position(1), stood + 5, 1e-9);
}

// Station 1 is drawn as a tool of 30 mm below the carrier; the offset in use says how long it
// really is.
TEST(Guard, TheShapeOfTheToolGoesWithItsOffset) {
    // 0: no offset, it counts as it is drawn
    for (const double length : {0.0, 30.0, 55.0, 20.0}) {
        SCOPED_TRACE(length);
        TwoCarriers m([](params::Table& t) {
            for (unsigned a = 1; a <= 4; ++a)
                params::put(t, params::n0100_axis_name1, a % 2 ? 'X' : 'Z', a);
        });
        Room room;
        for (unsigned a = 1; a <= 4; ++a)
            room.axes[a] = {{}, a % 2 ? RoomVector{1, 0, 0} : RoomVector{0, 0, 1}};
        room.turrets[1].body = room.turrets[2].body = {{-10, 10, -10, 10}};
        room.turrets[1].tools[1] = {{-30, 0, -5, 5}};
        room.turrets[1].tips[1] = {-30, 0, 0};
        m.rig.machine->take_room(room, derive_machine_config(m.rig.machine->core().table));
        m.rig.machine->adopt_parameters();
        m.rig.machine->core().signals.set_nc(signals::cn_tcode(1), 1);
        BlockPicture picture{};
        picture.serial = 5;
        picture.tool_shift[0] = length;  // the carrier stands this far above the tip
        push_picture(*m.rig.channel[0], picture);
        picture.serial = 9;  // blocks that are read ahead say nothing yet
        picture.tool_shift[0] = 90;
        push_picture(*m.rig.channel[0], picture);
        PathRecord r = m.rig.line(1, {-100, 0}, 80);
        r.serial = 7;
        m.rig.push(1, r);
        m.rig.start(1);
        m.rig.run(3000);
        EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
        const double reach = std::max(10.0, length > 0 ? length : 30.0);
        EXPECT_GE(m.rig.position(1), 10 + reach + 1.0);
        EXPECT_LE(m.rig.position(1), 10 + reach + 3.0);
    }
}

TEST(Guard, ChuckBarrierOfParametersActsUntilThePlcTakesItAway) {
    for (const bool off : {false, true}) {
        TwoCarriers m([](params::Table& t) {
            params::put(t, params::n1901_l1_length_of_jaws, 30, 1);
            params::put(t, params::n1902_w1_width_of_jaws, 200, 1);
            params::put(t, params::n1906_chuck_position_z, -200, 1);
        });
        if (off) m.rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_chuckoff(1), 1);
        m.rig.push(1, m.rig.line(1, {0, -180}, 100));
        m.rig.start(1);
        m.rig.run(4000);
        EXPECT_EQ(m.rig.alarmed(Alarm::GuardStop, 1), !off);
        if (off)
            EXPECT_NEAR(m.rig.position(2), -180, 1e-9);
        else
            EXPECT_GE(m.rig.position(2), -170 + 10 + 1.0);
    }
}

// N1900 TYP: beside a grip that holds a bore the carrier goes as far as the jaws; a grip around the
// part is as wide as they are.
TEST(Guard, TheGripIsAsWideAsTheChuckHolds) {
    for (const int outside : {0, 1}) {
        TwoCarriers m([&](params::Table& t) {
            params::put(t, params::n1901_l1_length_of_jaws, 30, 1);
            params::put(t, params::n1902_w1_width_of_jaws, 200, 1);
            params::put(t, params::n1903_l2_holding_length_of_jaws, 40, 1);
            params::put(t, params::n1904_w2_holding_width_of_jaws, 20, 1);
            params::put(t, params::n1906_chuck_position_z, -200, 1);
            params::put(t, params::n1900_chuck_config, outside, 1);
        });
        m.rig.push(1, m.rig.line(1, {0, -180}, 100));
        m.rig.start(1);
        m.rig.run(4000);
        EXPECT_TRUE(m.rig.alarmed(Alarm::GuardStop, 1));
        EXPECT_NEAR(m.rig.position(2), (outside ? -130 : -170) + 11, 2);
    }
}

// Outlines come from the tool table: a longer drill at station 3 makes a safe program stop, and
// instead of what the room says.
TEST(Guard, ALongerToolOfTheTableStopsWhatWasSafe) {
    for (const double length : {5.0, 60.0}) {
        SCOPED_TRACE(length);
        TwoCarriers m;
        ToolShapes shapes;
        // below the carrier, towards L2
        shapes.shapes[0] = {1, 3, -10.0 - length, -10.0, -5.0, 5.0};
        shapes.count = 1;
        m.rig.machine->take_tool_shapes(shapes);
        m.rig.machine->adopt_parameters();
        m.rig.push(1, m.rig.aux(1, 'T', 3));
        m.rig.push(1, m.rig.line(1, {-50, 0}, 100));
        m.rig.push(1, m.rig.stop(1, StopReason::M30));
        m.rig.start(1);
        m.rig.run(3000);
        const bool safe = length < 10;
        EXPECT_EQ(m.rig.alarmed(Alarm::GuardStop, 1), !safe);
        EXPECT_EQ(m.rig.state(1) == ChannelState::Ended, safe);
        // 10 + 60 + 10 mm of bodies and PT_GUARD_DISTANCE
        if (!safe) { EXPECT_GE(m.rig.position(1), 81.0); }
    }
}

// The store's table, as the kernel reads it: tools in turrets only, by channel and station, in the
// room's radius.
TEST(Guard, OutlinesAreThoseOfTheToolsInTheTurrets) {
    auto store = std::make_unique<StoreSegment>();
    params::Table& t = store->parameters.draft();
    params::set_defaults(t);
    params::put(t, params::pt_turret_magazine, 2, 1);
    ToolTable& tools = store->tools.draft();
    const auto put = [&](std::size_t number, int magazine, int pot) {
        ToolRow& row = tools.rows[number - 1];
        row.used = 1;
        row.magazine = magazine;
        row.pot = pot;
        row.boxes = 1;
        row.outline[0] = -80;
        row.outline[1] = 0;
        row.outline[2] = -4;
        row.outline[3] = 4;
    };
    put(5, 2, 3);
    put(6, 1, 3);
    put(7, 0, 0);
    store->tools.publish();
    store->parameters.publish();
    ToolShapes out;
    ASSERT_TRUE(read_tool_shapes(*store, out));
    ASSERT_EQ(out.count, 1u);
    EXPECT_EQ(out.shapes[0].channel, 1u);
    EXPECT_EQ(out.shapes[0].station, 3u);
    EXPECT_EQ(out.shapes[0].x_low, -80);
}

}  // namespace
}  // namespace polyturn::kernel
