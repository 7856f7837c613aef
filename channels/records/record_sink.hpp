// The sink of a running channel: turns elementary results into records of the ring, in path order,
// and notes that describe them.
//
// Invariants
//   I1  A note is in its ring before the record that names it.
//   I2  A record that is not motion leaves behind the last move before it; where the machine must
//       be at standstill for it, that move ends with a stop. At standstill: dwell, M S T to the
//       PLC, wait (a flying one brakes only if it must), program stop, barrier, spindle
//       positioning. Not: spindle speed and surface speed, variables, offsets, messages, parts.
//   I3  Behind a record with kDrains nothing is pushed before the kernel has answered it;
//       drain_index() is its index.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "channels/hold/operator_changes.hpp"
#include "channels/machine_view.hpp"
#include "channels/path/transformed_out.hpp"
#include "channels/port.hpp"
#include "channels/records/ring_out.hpp"
#include "channels/sink.hpp"
#include "ipc/image/positioning_step.hpp"

namespace polyturn::channels {

class RecordSink : public Sink {
public:
    // describe: a sink that appends its event objects to `text`, one a line; nullptr when no
    // notes are wanted. put_note: number and text into the note ring, waiting for room.
    using PutNote = std::function<void(std::uint64_t, std::string_view)>;
    RecordSink(const MachineView& view, PathMaker& maker, RingOut& ring, Sink* describe,
               std::string* text, PutNote put_note)
        : view_(&view),
          maker_(&maker),
          ring_(&ring),
          describe_(describe),
          text_(text),
          put_note_(std::move(put_note)) {}

    // Where moves in path coordinates go through; `drives` are the limits without a transformation.
    void transforms(TransformedOut& out, const PathLimits& drives) {
        transformed_ = &out;
        drives_ = &drives;
    }
    // taken over with the next move
    void limits_changed() {
        entry_ = 0;
        limits_forgotten_ = true;
    }

    void move(const Move&, const BlockContext&) override;
    void add(const Move&, const BlockContext&, bool told, std::uint64_t number = 0,
             std::uint32_t flags = 0);
    void curve(const Move&, const BlockContext&);
    void thread_arc(const Move&, const BlockContext&);
    void slow_ends(const Move&, const BlockContext&);
    void dwell(const Dwell&, const BlockContext&) override;
    void aux(const Aux&, const BlockContext&) override;
    // A restart passes this T or M6: the kernel asks which tool that is, and calls none.
    void look_up_tool(const Aux&, const BlockContext&);
    void spindle(const Spindle&, const BlockContext&) override;
    void wait(const Wait&, const BlockContext&) override;
    void variable(const Variable&, const BlockContext&) override;
    void offset(const OffsetWrite&, const BlockContext&) override;
    void message(std::string_view text, const BlockContext&) override;
    void interrupts(const Interrupts& interrupts, const BlockContext& at) override;
    void parameter(std::string_view line, const BlockContext& at) override;
    void tool_write(const ToolWrite&, const BlockContext&) override;
    void life_group(const LifeGroup&, const BlockContext&) override;
    void signal(std::string_view name, double value, const BlockContext& at) override;
    void print(std::string_view text, const BlockContext& at) override;
    void stop(const Stop&, const BlockContext&) override;
    void part(double count, const BlockContext&) override;
    void alarm(const Diagnosis&, const BlockContext&) override;
    void barrier(const BlockContext&) override;
    void block_end(const BlockContext&) override;

    // The program has come to a barrier, or to its end: everything is out afterwards. `stop`: what
    // ends it unless the program itself has; a barrier without a record of its own gets one.
    void reach_barrier();
    // the next stop of the interpreter needs a barrier of its own, even if nothing is pushed
    // between
    void barrier_done() { drained_ = false; }
    // what was pushed is void: the program goes back
    void forget() {
        drained_ = stopped_ = failed_ = false;
        skip_.number = 0;
        limits_changed();
    }
    // Behind the barrier of a skip move: its note is output once more, with the point at which it
    // ended.
    void skip_ended(Port& port);
    void finish(StopReason reason);
    // the program has ended, another part follows: a barrier instead of the stop
    void end_of_part();
    void tell_writes(OperatorChanges* changes) { changes_ = changes; }
    // before its stop is pushed
    void on_dialogue(std::function<void(const DialoguePage&)> show) {
        show_dialogue_ = std::move(show);
    }
    void more_parts(bool more) { more_parts_ = more; }
    // Between: records act as soon as the machine sees them, though the path is not there yet
    // (kAtOnce); without room in the ring it is kept for push_kept(), behind the next forget().
    void at_once(bool on);
    void push_kept();

    std::uint64_t drain_index() const { return drain_index_; }
    bool failed() const { return failed_; }
    std::uint64_t next_note() const { return note_ + 1; }
    void continue_notes(std::uint64_t last) { note_ = last; }

private:
    void push_code(PathRecord& record, const Aux&);
    PathRecord event(RecordKind kind, const BlockContext& at, std::uint64_t note) const;
    void push(PathRecord& record, bool stands, bool drains);
    template <class Call>
    std::uint64_t note(Call&& call);
    std::uint64_t note_move(const Move&, const BlockContext&);
    // record_positioning.cpp: asynchronous motion, and waiting for it
    struct Outstanding {
        std::array<bool, kMaxAxes> axis{};
        std::array<bool, kMaxSpindles> spindle{};
    };
    void beside(const Move&, const BlockContext&);
    std::uint64_t note_step(const Dwell*, const Aux*, const BlockContext&);
    void own_step(PositioningStep step, const BlockContext&);
    void own_room(const BlockContext&);
    void own_dwell(const Dwell&, const BlockContext&);
    void own_function(const Aux&, const BlockContext&);
    void await(const Outstanding& whom, const BlockContext& at);
    void await_axes_of(const Move&, const BlockContext&);
    void await_spindles(const BlockContext&);
    bool demand(std::string_view name, double value, const BlockContext&);
    bool other_program(std::string_view name, double value, const BlockContext&);
    LifeGroup group_{};  // that was opened last
    int group_order_ = 0;
    Outstanding under_way_;   // output asynchronously and not waited for yet
    AxisSet last_moved_ = 0;  // by the last move of the path
    std::array<double, kChannelAxes> window_mm_{};
    // Shares of their own limits that the program allows its axes; what a positioning axis and a
    // spindle have of their speed.
    struct Shares {
        std::array<double, kChannelAxes> velocity, acceleration, jerk, beside;
        std::array<double, kMaxSpindles + 1> spindle;
        // a negative tolerance: the machine's
        double tolerance = -1, square_turn = PathLimits{}.square_turn;
        Shares() {
            velocity.fill(1.0);
            acceleration.fill(1.0);
            jerk.fill(1.0);
            beside.fill(1.0);
            spindle.fill(1.0);
        }
    };
    Shares shares_;
    PathLimits shared_limits_;
    bool takes_share(std::string_view name, double value);
    const PathLimits& limits_of_path();
    void use_transformation(const Move& move);
    void fill_retract(const Move& move, PathRecord& record) const;
    void fill_arc(const Move& move, PathRecord& record) const;

    struct SkipNote {
        std::uint64_t number = 0;  // of the note; 0: none is due
        Move move;
        BlockContext at;
        std::string tool, cycle, input;  // what the views of move and at look into
    };
    SkipNote skip_;
    const MachineView* view_;
    PathMaker* maker_;
    RingOut* ring_;
    Sink* describe_;
    std::string* text_;
    PutNote put_note_;
    std::uint64_t note_ = 0;
    std::uint64_t drain_index_ = 0;
    TransformedOut* transformed_ = nullptr;
    const PathLimits* drives_ = nullptr;
    std::uint16_t entry_ = 0;  // transformation of the newest move
    bool limits_forgotten_ = false;
    bool drained_ = false;  // the newest record drains
    std::function<void(const DialoguePage&)> show_dialogue_;
    bool stopped_ = false;  // the program has ended itself
    bool failed_ = false;   // an error was delivered
    bool more_parts_ = false;
    std::uint32_t own_steps_ = 0;  // of the program of an axis, since it was last asked for room
    AxisValues own_from_{};        // the axis' position before its first move
    bool own_moved_ = false;
    enum class Ahead : std::uint8_t { No, AtOnce, Kept } ahead_ = Ahead::No;
    std::vector<PathRecord> kept_;
    OperatorChanges* changes_ = nullptr;
    BlockContext last_{};  // place of the newest record, without texts
};

}  // namespace polyturn::channels
