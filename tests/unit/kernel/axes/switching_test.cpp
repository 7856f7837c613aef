// Issue 4's figure: switching any coupling or compensation causes no step of the command beyond the
// axis limits. Each row switches something on and off again at moments that have nothing to do with
// the programs, which drive on all the time; speed, acceleration and jerk are the raw differences
// of what the drives are told (the command, and what compensation adds behind it), from outside.
#include <random>

#include "ipc/model/compensation/compensation_tables.hpp"
#include "tests/seeds.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct Row {
    const char* what;
    std::function<void(params::Table&)> machine;  // that it can be switched at all
    std::function<void(TickRig&, bool)> turn;     // on or off
    std::function<bool(TickRig&)> acts;
    // of the limits that the programs' moves may use
    double share = 1.0;
};

void flag(TickRig& rig, std::uint32_t slot, bool on) {
    rig.command(CommandKind::SetSignal, 0, on ? 1 : 0, 0, slot, 1);
}
bool nc(TickRig& rig, std::uint32_t slot) { return rig.machine->core().signals.nc(slot) != 0; }
std::function<void(TickRig&, bool)> level(std::uint32_t slot) {
    return [slot](TickRig& rig, bool on) { flag(rig, slot, on); };
}
std::function<bool(TickRig&)> shows(std::uint32_t slot) {
    return [slot](TickRig& rig) { return nc(rig, slot); };
}
// A compensation whose parameters are changed while everything runs: `on` puts them in, off takes
// the enabling bit away.
template <class Handle>
std::function<void(TickRig&, bool)> bit_of(Handle handle, unsigned scope, int value) {
    return [handle, scope, value](TickRig& rig, bool on) {
        params::put(rig.machine->core().table, handle, on ? value : 0, scope);
        rig.machine->adopt_parameters();
    };
}
std::function<bool(TickRig&)> shifted(unsigned axis) {
    return [axis](TickRig& rig) {
        return std::fabs(rig.machine->core().axes[axis - 1].compensation()) > 0.02;
    };
}

CompensationTables tables() {
    CompensationTables t;
    t.measured = true;
    t.cells.assign(static_cast<std::size_t>(kLastCell - kFirstCell + 1), 0.0f);
    for (std::size_t i = 0; i <= 40; ++i) t.cells[i] = 0.05f + 0.03f * static_cast<float>(i % 2);
    for (std::size_t i = 100; i <= 140; ++i) t.cells[i] = -0.06f;
    for (int k = 0; k < 4; ++k) t.points[0].push_back({0.05f, 0.04f, 0.0f});
    return t;
}
void layout(params::Table& t, unsigned a) {
    params::put(t, params::n2501_primary_interval, 10, a);
    params::put(t, params::n2502_cell_no_of_mach_zero, 10020, a);
    params::put(t, params::n2503_primary_smallest_cell_no, 10000, a);
    params::put(t, params::n2504_primary_largest_cell_no, 10040, a);
    params::put(t, params::n2505_primary_smallest_cell_no_both_dir, 10100, a);
}

const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        {"synchronous",
         [](params::Table& t) { params::put(t, params::n2101_synchronous_master, 2, 4); },
         level(signals::ap_syncr(4)), shows(signals::an_synca(4))},
        {"synchronous, mirrored",
         [](params::Table& t) {
             params::put(t, params::n2101_synchronous_master, 2, 4);
             params::put(t, params::n2102_synchron_config, 1, 4);
         },
         level(signals::ap_syncr(4)), shows(signals::an_synca(4))},
        {"superimposed",
         [](params::Table& t) { params::put(t, params::n2107_superimposed_master, 2, 4); },
         level(signals::ap_sprpnr(4)), shows(signals::an_sprpna(4)), 0.5},
        {"exchange", [](params::Table& t) { params::put(t, params::n2104_composit_axis, 1, 3); },
         level(signals::ap_mixr(3)), shows(signals::an_mixa(3))},
        {"pitch", [](params::Table& t) { layout(t, 2); },
         bit_of(params::n2500_pitch_comp_contr, 2, 1), shifted(2)},
        {"pitch, both directions", [](params::Table& t) { layout(t, 2); },
         bit_of(params::n2500_pitch_comp_contr, 2, 3), shifted(2)},
        {"gradient",
         [](params::Table& t) {
             params::put(t, params::n2801_position_a, -20, 2);
             params::put(t, params::n2802_position_b, 0, 2);
             params::put(t, params::n2803_position_c, 20, 2);
             params::put(t, params::n2804_position_d, 40, 2);
             params::put(t, params::n2805_gradient_value_a, 0.05, 2);
             params::put(t, params::n2806_gradient_value_b, 0.1, 2);
             params::put(t, params::n2807_gradient_value_c, 0.05, 2);
             params::put(t, params::n2808_gradient_value_d, 0.1, 2);
         },
         bit_of(params::n2800_gradient_comp_contr, 2, 1), shifted(2)},
        {"straightness",
         [](params::Table& t) {
             layout(t, 2);
             params::put(t, params::n2607_no_of_compensation_axis_1, 1, 1);
             params::put(t, params::n2613_smallest_cell_no_of_moving_axis_1, 10100, 1);
         },
         bit_of(params::n2601_no_of_moving_axis_1, 1, 2), shifted(1)},
        {"grid",
         [](params::Table& t) {
             params::put(t, params::n2703_no_of_points_on_1st_axis, 2, 1);
             params::put(t, params::n2704_no_of_points_on_2nd_axis, 2, 1);
             params::put(t, params::n2701_2nd_axis_of_3d_compensation, 2, 1);
             params::put(t, params::n2709_comp_interval_on_1st_axis, 50, 1);
             params::put(t, params::n2710_comp_interval_on_2nd_axis, 50, 1);
         },
         bit_of(params::n2700_1st_axis_of_3d_compensation, 1, 1), shifted(1)},
        {"temperature", [](params::Table& t) { params::put(t, params::pt_temp_shift, 0.01, 2); },
         [](TickRig& rig, bool on) {
             rig.command(CommandKind::SetSignal, 0, on ? 800 : 0, 0, signals::ap_temp(2), 1);
         },
         shifted(2)},
    };
    return kRows;
}

// Worst of the axes' first, second and third differences, each over its limit.
struct Watch {
    std::array<std::array<double, 4>, 4> last{};  // axis: position, speed, acceleration
    double speed = 0, acceleration = 0, jerk = 0;
    int known = 0;
    void look(TickRig& rig) {
        for (unsigned a = 0; a < 4; ++a) {
            const AxisUnit& axis = rig.machine->core().axes[a];
            const double p = axis.command() + axis.compensation(), v = (p - last[a][0]) / 0.001,
                         b = (v - last[a][1]) / 0.001, j = (b - last[a][2]) / 0.001;
            if (known > 0) speed = std::max(speed, std::fabs(v) / TickRig::kVelocity);
            if (known > 1)
                acceleration = std::max(acceleration, std::fabs(b) / TickRig::kAcceleration);
            if (known > 2) jerk = std::max(jerk, std::fabs(j) / TickRig::kJerk);
            last[a] = {p, v, b, 0};
        }
        ++known;
    }
};

TEST(Switching, OfAnyCouplingOrCompensationMakesNoStepBeyondTheLimits) {
    for (const Row& row : rows()) {
        SCOPED_TRACE(row.what);
        TickRig rig([&](params::Table& t, RunOptions&) {
            row.machine(t);
            params::put(t, params::pt_couple_timeout, 0);
        });
        rig.machine->take_tables(tables());
        rig.machine->adopt_parameters();
        rig.run(5);
        Watch watch;
        rig.on_tick = [&] { watch.look(rig); };
        std::mt19937 dice(test_seed(7));
        int on = 0, off = 0;
        bool wanted = false, seen = false;
        for (int i = 0; i < 24; ++i) {  // a move of each channel, the switch in the middle of it
            const bool slave = rig.machine->core().axes[3].slave,
                       exchanged = nc(rig, signals::an_mixa(3));
            for (unsigned l = 1; l <= 2; ++l) {
                if (l == 2 && (slave || exchanged)) continue;
                if (exchanged) continue;
                for (unsigned k = 0; k < 2; ++k)
                    rig.place(l, k, rig.machine->core().axes[2 * (l - 1) + k].own());
                const double way = i % 2 ? -12.5 : 12.5;
                PathRecord r = rig.line(l, {way * 0.6, way}, 180);
                // Half of everything where two channels move one axis; what compensation may take
                // stays free.
                r.v_max *= 0.97 * row.share;
                r.a_max *= 0.97 * row.share;
                r.j_max *= 0.94 * row.share;
                rig.push(l, r);
                rig.start(l);
            }
            rig.run(static_cast<int>(20 + dice() % 100));
            row.turn(rig, wanted = !wanted);
            rig.run(700);
            const bool now = row.acts(rig);
            on += now && !seen;
            off += !now && seen;
            seen = now;
        }
        EXPECT_GE(on, 8);
        EXPECT_GE(off, 8);
        EXPECT_GT(watch.speed, 0.2) << "the programs moved";
        EXPECT_LE(watch.speed, 1.0001);
        EXPECT_LE(watch.acceleration, 1.001);
        EXPECT_LE(watch.jerk, 1.01);
    }
}

// Spindles that turn: the follower's commanded speed keeps its ramp when it is coupled, uncoupled,
// taken into phase, reversed.
TEST(Switching, OfATurningSpindleKeepsItsRamp) {
    TickRig rig([](params::Table& t, RunOptions&) {
        for (unsigned s = 1; s <= 2; ++s) {
            params::put(t, params::n0701_r1_spindle_gain, 20, s);
            params::put(t, params::n0761_r1_s_serrl1, 0, s);
            params::put(t, params::n0769_r1_s_serrl2, 0, s);
            params::put(t, params::n0777_r1_s_serrl3, 0, s);
        }
        params::put(t, params::pt_spindle_master, 1, 2);
    });
    double before = 0, steepest = 0;
    int tick = 0;
    rig.on_tick = [&] {
        const double now = rig.machine->core().spindles[1].true_speed();
        if (++tick % 20) return;  // the encoder's noise in the loop apart
        steepest = std::max(steepest, std::fabs(now - before) / 0.02);
        before = now;
    };
    rig.push(1, rig.spindle(1, 900));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.start(1);
    rig.run(1200);
    std::mt19937 dice(test_seed(11));
    int coupled = 0;
    for (int i = 0; i < 12; ++i) {
        const bool phase = i % 3 == 2;
        rig.command(CommandKind::SetSignal, 0, 1, 0, signals::sp_syncr(2), 1);
        if (phase) rig.command(CommandKind::SetSignal, 0, 1, 0, signals::sp_phaser(2), 1);
        rig.run(static_cast<int>(200 + dice() % 3000));
        coupled += nc(rig, signals::sn_synca(2));
        rig.command(CommandKind::ReleaseSignal, 0, 0, 0, signals::sp_phaser(2), 1);
        rig.command(CommandKind::ReleaseSignal, 0, 0, 0, signals::sp_syncr(2), 1);
        rig.run(static_cast<int>(10 + dice() % 900));
    }
    EXPECT_GE(coupled, 1);  // of twelve; how many have the time depends on the seed
    EXPECT_LE(steepest, 1500 * 1.05);
}

}  // namespace
}  // namespace polyturn::kernel
