#include "ipc/model/machine/machine_config.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ipc/model/bodies/room.hpp"
#include "ipc/model/bodies/room_bodies.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/params/registry.hpp"
#include "tests/places.hpp"
#include "tests/property.hpp"

namespace {

using namespace polyturn;

const std::string kTwinTurret = std::string(kSourceFolder) + "/examples/machines/twin-turret";

TEST(TwinTurret, IsTheMachineThatTheCommandLinePromises) {
    const LoadedMachine loaded = load_machine({kTwinTurret, {}, {}});
    for (const Diagnosis& diagnosis : loaded.diagnoses)
        ADD_FAILURE() << render(diagnosis, Dialect::Polyturn, "");
    const MachineConfig m = derive_machine_config(*loaded.table);
    EXPECT_EQ(m.tick_us, 1000u);
    EXPECT_EQ(m.channel_count, 2);
    EXPECT_EQ(m.axis_count, 6);
    EXPECT_EQ(m.spindle_count, 4);
    EXPECT_TRUE(m.is_wait_code(500));
    EXPECT_TRUE(m.is_wait_code(599));
    EXPECT_FALSE(m.is_wait_code(499));
    EXPECT_FALSE(m.is_wait_code(600));
    EXPECT_EQ(m.channels_of_group(1), 3u);

    struct Row {
        unsigned axis, channel;
        const char* name;
        PlaneRole role;
        bool diameter, rotary;
        unsigned on_spindle;
    };
    const Row rows[] = {
        {1, 1, "X", PlaneRole::BasicX, true, false, 0},
        {2, 1, "Z", PlaneRole::BasicZ, false, false, 0},
        {3, 2, "X", PlaneRole::BasicX, true, false, 0},
        {4, 2, "Z", PlaneRole::BasicZ, false, false, 0},
        {5, 1, "C", PlaneRole::None, false, true, 1},
        {6, 2, "C", PlaneRole::None, false, true, 2},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.axis);
        const AxisConfig& a = m.axis(row.axis);
        EXPECT_EQ(a.channel, row.channel);
        EXPECT_EQ(a.name_text(), row.name);
        EXPECT_EQ(a.role, row.role);
        EXPECT_EQ(a.diameter, row.diameter);
        EXPECT_EQ(a.rotary, row.rotary);
        EXPECT_EQ(a.rollover, row.rotary);
        EXPECT_EQ(a.on_spindle, row.on_spindle);
        EXPECT_EQ(find_axis(m, row.channel, row.name), &a);
    }
    EXPECT_NEAR(m.axis(1).limits.rapid_mm_s, 20000.0 / 60, 1e-9);
    EXPECT_NEAR(m.axis(2).limits.rapid_mm_s, 400.0, 1e-9);
    EXPECT_NEAR(m.axis(1).limits.jerk_mm_s3, 3000 / 0.05, 1e-6);
    for (const unsigned l : {1u, 2u}) {
        const ChannelConfig& c = m.channel(l);
        EXPECT_EQ(c.kind, ChannelKind::Lathe);
        EXPECT_EQ(c.default_spindle, 1);
        EXPECT_EQ(c.offset_count, 32);
        EXPECT_EQ(c.axis_count, 3);
        EXPECT_EQ(c.decimals(), 3u);
        EXPECT_FALSE(c.inch);
    }
    EXPECT_EQ(m.channel(1).surface_speed_axis, 1);
    EXPECT_EQ(m.channel(2).surface_speed_axis, 3);
    EXPECT_EQ(find_spindle(m, "S2"), &m.spindle(2));
    EXPECT_EQ(find_spindle(m, "S5"), nullptr);
    EXPECT_EQ(find_spindle(m, "S"), nullptr);
    EXPECT_EQ(m.spindle(1).range[0].max_rpm, 4500);
}

TEST(TwinTurret, HasARoomForItsParts) {
    std::vector<Diagnosis> diagnoses;
    const LoadedMachine loaded = load_machine_file(kTwinTurret);
    const Room room = load_room(loaded.room_file, derive_machine_config(*loaded.table), diagnoses);
    for (const Diagnosis& diagnosis : diagnoses)
        ADD_FAILURE() << render(diagnosis, Dialect::Polyturn, "");
    EXPECT_EQ(room.axes.size(), 6u);
    EXPECT_EQ(room.turrets.size(), 2u);
    EXPECT_EQ(room.chucks.size(), 2u);
    EXPECT_EQ(room.axes.at(3).direction.x, -1.0);  // the lower turret comes from below
}

// The ram of the vertical lathe goes 30 degrees out of the level; what a tool is long counts at
// right angles (fanuc_lathe 10.5).
TEST(VerticalInclined, TheTipOfATool) {
    std::vector<Diagnosis> diagnoses;
    const LoadedMachine loaded =
        load_machine_file(std::string(kSourceFolder) + "/examples/machines/vertical-inclined");
    const MachineConfig machine = derive_machine_config(*loaded.table);
    const Room room = load_room(loaded.room_file, machine, diagnoses);
    std::array<double, kChannelAxes> shift{};
    shift[find_axis(machine, 1, PlaneRole::BasicX)->slot] = 40;
    shift[find_axis(machine, 1, PlaneRole::BasicZ)->slot] = 25;
    const RoomBodies::Vector tip = tip_of(room, machine, 1, shift);
    EXPECT_NEAR(tip.x, -40, 1e-6);
    EXPECT_NEAR(tip.z, -25, 1e-6);
}

TEST(MachineConfig, TakesInchesAndMinutesToMillimetresAndSeconds) {
    params::Table t = params::defaults();
    params::put(t, params::n0000_machine_group, 1, 1);
    params::put(t, params::n0104_unit_of_measure, 1, 1);  // inch
    params::put(t, params::n0002_axis_assign, 1, 1);
    params::put(t, params::n0002_axis_assign, 1, 2);
    params::put(t, params::n0100_axis_name1, 'X', 1);
    params::put(t, params::n0100_axis_name1, 'C', 2);
    // rotary: degrees, whatever the channel measures in
    params::put(t, params::n0106_axis_properties, 2, 2);
    for (const unsigned a : {1u, 2u}) {
        params::put(t, params::n0304_rapid, 600, a);
        params::put(t, params::n0400_acceleration, 100, a);
        params::put(t, params::n0401_acc_tc, 0, a);
        params::put(t, params::n1002_range1a_positive, 10, a);
    }
    const MachineConfig m = derive_machine_config(t);
    EXPECT_DOUBLE_EQ(m.axis(1).limits.rapid_mm_s, 254.0);
    EXPECT_DOUBLE_EQ(m.axis(2).limits.rapid_mm_s, 10.0);
    EXPECT_DOUBLE_EQ(m.axis(1).limits.accel_mm_s2, 2540.0);
    EXPECT_DOUBLE_EQ(m.axis(1).stroke.max_a_mm, 254.0);
    EXPECT_DOUBLE_EQ(m.axis(2).stroke.max_a_mm, 10.0);
    EXPECT_TRUE(std::isinf(m.axis(1).limits.jerk_mm_s3));  // N0401 = 0: no jerk limit
}

TEST(MachineConfig, ChoosesTheTickByTheChannelsThatOwnAxes) {
    EXPECT_EQ(auto_tick_us(1), 1000u);
    EXPECT_EQ(auto_tick_us(2), 1000u);
    EXPECT_EQ(auto_tick_us(3), 2000u);
    EXPECT_EQ(auto_tick_us(4), 2000u);
    EXPECT_EQ(auto_tick_us(5), 5000u);
    EXPECT_EQ(auto_tick_us(16), 5000u);
}

// Whatever the parameters say within their limits, every number in the result can be used as an
// index.
TEST(MachineConfig, IsSafeToIndexForAnyParameters) {
    const bool good = holds("random tables", [] {
        auto t = std::make_unique<params::Table>(params::defaults());
        const auto put_some = [&](const auto& handle, int low, int high) {
            const unsigned count = params::instances(std::decay_t<decltype(handle)>::kScope);
            for (unsigned i = 1; i <= count; ++i)
                if (*rc::gen::inRange(0, 3) > 0)
                    params::put(*t, handle, *rc::gen::inRange(low, high), i);
        };
        put_some(params::n0000_machine_group, 0, 9);
        put_some(params::n0002_axis_assign, 0, 20);
        put_some(params::n0100_axis_name1, 64, 92);
        put_some(params::n0106_axis_properties, 0, 256);
        put_some(params::n0503_axis_output_address, 0, 6);
        put_some(params::n0603_spindle_output_address, 0, 6);
        put_some(params::n0607_spindle_config, 0, 256);
        put_some(params::n0604_default_spindle, 0, 17);
        put_some(params::n0687_default_g96_axis, 0, 33);
        const auto m = std::make_unique<MachineConfig>(derive_machine_config(*t));
        for (const ChannelConfig& c : m->channels) {
            RC_ASSERT(c.axis_count <= kChannelAxes);
            for (std::size_t slot = 0; slot < c.axis_count; ++slot) {
                const AxisConfig& a = m->axis(c.axes[slot]);
                RC_ASSERT(
                    (a.exists() && a.channel == c.number && a.slot == slot && a.name[0] != 0));
            }
            RC_ASSERT((c.default_spindle == 0 || m->spindle(c.default_spindle).exists()));
            RC_ASSERT(
                (c.surface_speed_axis == 0 || m->axis(c.surface_speed_axis).channel == c.number));
        }
        for (const AxisConfig& a : m->axes) {
            if (!a.exists()) continue;
            RC_ASSERT((a.channel == 0 || m->channel(a.channel).exists()));
            RC_ASSERT((a.on_spindle == 0 || m->spindle(a.on_spindle).exists()));
        }
    });
    EXPECT_TRUE(good);
}

TEST(LoadMachine, SaysEveryWrongLineWithItsPlace) {
    const LoadedMachine loaded = load_machine(
        {kTwinTurret, {"/nowhere/a.params"}, {"N1600 L1=x", "N0304 A3=12000", "N4711=1"}});
    ASSERT_EQ(loaded.diagnoses.size(), 3u);
    EXPECT_EQ(loaded.diagnoses[0].alarm, Alarm::FileUnreadable);
    EXPECT_EQ(loaded.diagnoses[1].place.file, "--set");
    EXPECT_EQ(loaded.diagnoses[2].place.file, "--set");
    EXPECT_FALSE(loaded.ok());
    EXPECT_EQ(params::get(*loaded.table, params::n0304_rapid, 3), 12000);  // the good line acts
}

TEST(Room, DiagnosesWhatTheMachineDoesNotHave) {
    const LoadedMachine loaded = load_machine_file(kTwinTurret);
    const MachineConfig m = derive_machine_config(*loaded.table);
    struct Row {
        const char* text;
        Alarm alarm;
        unsigned line;
    };
    const Row rows[] = {
        {"[axis.A9]\norigin = { X = 0.0 }\n", Alarm::RoomEntry, 1},
        {"[axis.X]\norigin = { X = 0.0 }\n", Alarm::RoomEntry, 1},
        {"[chuck.S9]\n", Alarm::RoomEntry, 1},
        {"[turret.L5]\n", Alarm::RoomEntry, 1},
        {"[axis.A1]\ndirection = { X = 0.0 }\n", Alarm::RoomEntry, 2},
        {"[axis.A1]\norigin = { Q = 0.0 }\n", Alarm::UnknownKey, 2},
        {"[axis.A1]\norigin = 5\n", Alarm::WrongType, 2},
        {"[elephant.1]\n", Alarm::UnknownKey, 1},
        {"[chuck.S1]\ndiameter = -3.0\n", Alarm::WrongType, 2},
        {"[axis.A1\n", Alarm::TextSyntax, 1},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.text);
        std::vector<Diagnosis> diagnoses;
        const Room room = parse_room(row.text, "machine.toml", m, diagnoses);
        ASSERT_EQ(diagnoses.size(), 1u);
        EXPECT_EQ(diagnoses[0].alarm, row.alarm) << diagnoses[0].text();
        EXPECT_EQ(diagnoses[0].place.line, row.line);
        EXPECT_EQ(room.axes.size(), 6u);
    }
}

TEST(Room, AddsTheAxesOfAChannelToAPoint) {
    const LoadedMachine loaded = load_machine_file(kTwinTurret);
    const MachineConfig m = derive_machine_config(*loaded.table);
    std::vector<Diagnosis> none;
    const Room room =
        parse_room("[axis.A3]\norigin = { X = -5.0, Z = 1.0 }\ndirection = { X = -2.0 }\n",
                   "machine.toml", m, none);
    const double at[] = {30.0, -100.0, 77.0};  // X as a radius, Z, C
    const RoomVector point = room.point(m.channel(2), m, at);
    EXPECT_DOUBLE_EQ(point.x, -35.0);
    EXPECT_DOUBLE_EQ(point.z, -99.0);
}

}  // namespace
