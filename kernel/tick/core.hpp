// What all parts of the cyclic thread share: the image, the machine's state at this tick, and the
// functions that report events. No behaviour beyond that; machine.hpp has the order of a tick.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

#include "ipc/image/segments.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "kernel/axes/axis_unit.hpp"
#include "kernel/protection/stroke_guard.hpp"
#include "kernel/spindles/spindle_unit.hpp"
#include "kernel/tick/event_log.hpp"
#include "kernel/tick/sensors.hpp"
#include "kernel/tick/signals.hpp"
#include "kernel/tick/totals.hpp"
#include "kernel/tools/store_link.hpp"
#include "kernel/tools/tool_client.hpp"
#include "kernel/tools/tool_shapes.hpp"
#include "kernel/waits/waits.hpp"

namespace polyturn::kernel {

enum class MachineState : std::uint32_t { EmergencyStop = 0, Off = 1, On = 2 };

class SpindleCouplings;
class Couplings;
class Guard;

struct Core {
    Core(KernelSegment& own, const SupervisorSegment& super, const StoreSegment& keeper)
        : image(own), supervisor(super), log(own, super), store(own, keeper) {}

    KernelSegment& image;
    const SupervisorSegment& supervisor;
    // Attached later than the kernel starts, by another thread; nullptr until then.
    std::array<std::atomic<const ChannelSegment*>, kMaxChannels> channel_segment{};
    std::atomic<const PlcSegment*> plc_segment{nullptr};
    // Successors of processes that have died, found by another thread; taken at a tick's start.
    std::array<std::atomic<const ChannelSegment*>, kMaxChannels> next_channel{};
    std::atomic<const PlcSegment*> next_plc{nullptr};
    std::atomic<const StoreSegment*> next_store{nullptr};
    // outlines of tools have changed; valid until the next but one
    std::atomic<const ToolShapes*> next_shapes{nullptr};
    // taken while all axes rest; valid until the next but one
    std::atomic<const CompensationTables*> next_compensation{nullptr};
    // the file that came does not fit the parameters
    std::atomic<bool> compensation_refused{false};

    params::Table table{};
    KernelConfig config{};
    bool virtual_time = true;
    std::int64_t tick = 0;  // the running one: from tick * tick_s on
    MachineState state = MachineState::Off;
    // PLC dead, ticks late, supervisor silent: everything rests until reset
    bool all_stop = false;
    bool store_dead = false;
    // it has lost data, and the operator has not confirmed that production goes on
    bool store_unfit = false;
    bool some_slow = false;  // is_slow() of any axis, in this tick
    bool end_run = false;
    std::uint32_t alarm_count = 0;
    // given to the PLC last; channel from 1
    struct {
        std::int32_t code = -1;
        std::uint32_t channel = 0;
    } newest_m;

    EventLog log;
    Signals signals;
    Sensors sensors;
    StoreLink store;
    Totals totals;
    ToolClient tools;
    std::array<AxisUnit, kMaxAxes> axes{};
    std::array<SpindleUnit, kMaxSpindles> spindles{};
    WaitBoard waits;
    // channels with nothing planned ahead (ChannelView::stands)
    ChannelSet standing = 0;
    std::uint64_t meetings = 0;  // releases of waits so far
    // Axes that share a drive with a spindle (C axes).
    struct SharedAxis {
        bool has_drive = false;  // it, not the spindle
        // the spindle has turned it, and its channel's program does not know yet where it is
        bool displaced = false;
        double left_at = 0;  // where the axis was when it lost the drive
    };
    std::array<SharedAxis, kMaxAxes> shared_axes{};
    StrokeGuard stroke;
    ChannelSet stroke2_off = 0;  // G23: range 2 does not count in these channels
    // What programs ask of positioning axes (by_hand/positioning_axis.cpp); taken in the same tick.
    struct PositioningRequest {
        bool asked = false;
        // own coordinate; mm/s (per_turn: mm a revolution of `spindle`), 0 rapid
        double target = 0, speed = 0;
        bool per_turn = false;
        std::uint32_t channel = 0, spindle = 0;  // from 1; channel 0: the PLC
        std::uint64_t note = 0;                  // event note that ends with it
        std::uint32_t line = 0;
        std::int64_t since = 0;  // tick at which it was asked
        // a step of a program that the axis runs by itself
        bool own = false;
    };
    std::array<PositioningRequest, kMaxAxes> beside{};
    // The channel whose program drives a positioning axis. Several channels may command one (fanuc
    // F8250 = 3): their programs follow each other in the order in which they were started.
    struct PositioningTurn {
        static constexpr std::uint64_t kNobody = ~std::uint64_t{0};
        std::uint32_t channel = 0;      // channel whose program runs; 0 none
        std::uint64_t first = kNobody;  // of those that wait in this tick, the oldest
    };
    std::array<PositioningTurn, kMaxAxes> positioning_turn{};
    std::uint64_t positioning_starts = 0;
    // What a move that ends at a torque allows its drives (G31 P98), thousandths; 0: no such move.
    std::array<std::uint16_t, kMaxAxes> move_torque{};
    // What programs ask of the machine, axis by axis: torque while travelling to a fixed stop
    // (thousandths, 0 all), the window there (0: PT_STOP_WINDOW), a reference point that is to be
    // found; and whether that could not be found.
    std::array<std::uint16_t, kMaxAxes> program_torque{};
    std::array<double, kMaxAxes> program_window{};
    std::array<bool, kMaxAxes> home_request{}, home_busy{}, home_failed{};
    // What programs have requested of other channels (INIT, START): carried out when all channels
    // have had their turn in the tick.
    struct ProgramCall {
        std::array<char, kCommandText> file{};
        bool selected = false, started = false;
    };
    std::array<ProgramCall, kMaxChannels> program_calls{};
    SpindleCouplings* spindle_couplings = nullptr;     // the machine's
    const Couplings* couplings = nullptr;              // likewise
    const Guard* guard = nullptr;                      // likewise
    ChannelSet jogging = 0;                            // channels of which an axis is moved by hand
    std::array<double, kMaxSpindles> spindle_rev_s{};  // measured, for feed per revolution

    // tick: a program wants it to follow another one
    std::array<std::int64_t, kMaxSpindles> spindle_called_until{};

    // The PLC's detach flags decide whether a C axis has the drive (nct_parameters_part1 7.1); with
    // neither of them it has it while the spindle is commanded to standstill and follows no other
    // one.
    bool drive_is_for_axis(std::uint32_t axis) const noexcept {
        namespace sig = polyturn::signals;
        const std::uint32_t s = config.axes[axis].on_spindle;
        const std::int32_t rotation = signals.plc(sig::sp_rot(s));
        const bool follows = spindles[s - 1].coupled() || tick < spindle_called_until[s - 1];
        const bool stands = !follows && rotation != 3 && rotation != 4 &&
                            !signals.plc(sig::sp_par(s)) && !signals.plc(sig::sp_oreq(s));
        return signals.plc(sig::sp_sdetchr(s)) != 0 ||
               (stands && !signals.plc(sig::ap_detchr(axis + 1)));
    }
    // CN_SSEL, and before a program has named any that of N0604.
    std::uint32_t selected_spindle(std::uint32_t channel) const noexcept {
        const std::int32_t selected = signals.nc(polyturn::signals::cn_ssel(channel));
        return selected != 0 ? static_cast<std::uint32_t>(selected)
                             : config.channels[channel - 1].default_spindle;
    }
    // One that counts for «referenced»: it has an order (PT_REF_ORDER), a loop of its own, and
    // exists.
    bool must_be_referenced(std::uint32_t a) const noexcept {
        const AxisConfig& axis = config.axes[a];
        return axis.exists && !axes[a].detached && !axis.servo.open && axis.reference.order != 0;
    }
    // Programs may move it before it has its reference, no faster than N0302 (nct_parameters_part1
    // 5, 10.2).
    bool is_slow(std::uint32_t a) const noexcept {
        const AxisConfig& axis = config.axes[a];
        return axis.exists && !axes[a].referenced && !axes[a].detached && !axis.servo.open &&
               axis.reference.order == 0 && axis.reference.rapid > 0;
    }
    // The door is open and setup mode is off.
    bool door_open(std::uint32_t channel) const noexcept {
        namespace sig = polyturn::signals;
        return signals.plc(sig::cp_dooropen(channel)) != 0 && !signals.plc(sig::cp_setup(channel));
    }
    bool on() const noexcept { return state == MachineState::On; }
    std::uint32_t no_wait() const noexcept {
        std::uint32_t set = 0;
        for (std::size_t l = 1; l <= kMaxChannels; ++l)
            if (signals.plc(polyturn::signals::cp_nowt(l))) set |= 1u << (l - 1);
        return set;
    }
    // the PLC's or the program's, whichever is lower
    std::uint16_t torque_limit(std::uint32_t a) const noexcept {
        const std::int32_t by_plc = signals.plc(polyturn::signals::ap_torq(a + 1));
        const auto told = static_cast<std::uint16_t>(by_plc < 0      ? 0
                                                     : by_plc > 1000 ? 1000
                                                                     : by_plc);
        return program_torque[a] == 0                  ? told
               : told == 0 || program_torque[a] < told ? program_torque[a]
                                                       : told;
    }
    void event(KernelEventKind kind, std::uint32_t channel, std::int32_t code = 0, double value = 0,
               std::uint32_t line = 0, std::string_view text = {}) noexcept {
        KernelEvent* e = log.claim(kind, channel, tick);
        if (!e) return;
        e->code = code;
        e->value = value;
        e->line = line;
        copy_text(e->text, text);
        log.put();
    }
    // Reports it; the caller stops what has to stop because of it.
    void alarm(Alarm number, std::uint32_t channel, std::string_view detail = {}, double value = 0,
               std::uint32_t line = 0) noexcept {
        const bool error = alarm_row(number).severity == Severity::Error;
        if (error) ++alarm_count;
        event(error ? KernelEventKind::Alarm : KernelEventKind::Message, channel,
              static_cast<std::int32_t>(number), value, line, detail);
    }
};

// "A3": how parameters and traces name an axis; S and L likewise.
inline ShortText name_of(char letter, std::size_t index_from_0) noexcept {
    ShortText text;
    text << std::string_view(&letter, 1) << static_cast<std::int64_t>(index_from_0 + 1);
    return text;
}

}  // namespace polyturn::kernel
