// The speed of a channel's path at this tick. Called once a tick by the cyclic thread: no
// allocation, lock, exception, system call; work bounded by the window.
//
// The kernel hands over records one by one (append) and then asks each tick for a step; the planner
// knows lengths and speed limits only, never geometry. Record numbers are the ring's own indices.
//
//     planner.clear(next ring index)      at attach, reset, new epoch: the path is at standstill
//     while (planner.wants_record() && ring has more)
//         planner.append(PlannedRecord::from(record, stands_before));
//     const PathStep step = planner.tick(input);
//         records [began_from, began_to) began in this tick, at the part planner.begin_fraction(i)
//             of it (0 to 1)
//         records [ended_from, ended_to) ended in this tick, at planner.end_fraction(i)
//         position: record step.record at step.s; before the first append after clear() it means
//         nothing (record == next)
//     step.stands != Moving says why the path is at standstill; BeforeRecord: execute step.record,
//     then planner.skip(step.record + 1)
//
// Standstill before a record (PlannedRecord::stop_before): a record that is no motion, a thread, a
// wait. Notes of length 0 that need no standstill (Variable, Offset, SpindleSpeed) are appended
// with stop_before false; they are reported as ended like any other record. A flying wait is
// appended with stop_before and let_pass() once its partners are there; nothing ever turns from
// passing to stopping.
// Invariants
//   I1  Records [first, end) are in the window, fewer than it has slots.
//   I2  The path never goes backwards: speed >= 0 behind every tick.
//   I3  What is committed is a braking that was possible.
// How it works, why it is right and what is weak: path_decision.cpp.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "kernel/motion/braking.hpp"
#include "kernel/motion/landing.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

// slots; the horizon may be up to this less 2
inline constexpr std::uint32_t kPlannerWindow = 4096;
inline constexpr std::uint32_t kAppendsPerTick = 128;  // bounds the work of a tick

// What the planner needs to know of a record. It holds along the whole record.
struct PlannedRecord {
    double length = 0;             // mm (degrees for a rotary path)
    double v_max = 0;              // mm/s, geometry and axes: never exceeded
    double a_max = 0;              // mm/s2
    double j_max = 0;              // mm/s3; infinity: no axis limits jerk
    double bend = 0, turning = 0;  // 1/mm: what speed takes of both, see limits.hpp
    double along = 0, across = 0;  // 1/mm2
    double feed = 0;               // mm/s, or mm a revolution
    std::uint16_t spindle = 0;     // from 1; feed per revolution
    FeedMode feed_mode = FeedMode::PerMinute;
    bool override_locked = false;   // feed override is 100 %
    bool stop_before = false;       // path stops at its start until the kernel skips it
    bool stop_after = false;        // path stops at its end (exact stop)
    bool wait_in_position = false;  // ... until PathInput::in_position
    bool block_end = false;         // single block stops here

    static PlannedRecord from(const PathRecord& record, bool stop_before) noexcept;
    [[nodiscard]] Limits limits() const noexcept {
        return {a_max, j_max, bend, turning, along, across};
    }
};

struct PathInput {
    double feed_override = 1;   // 0 .. 2
    double rapid_override = 1;  // 0 .. 1
    // revolutions a second (any sign) of spindle 1.., kMaxSpindles values; may be null
    const double* spindle_rev_s = nullptr;
    double dry_run_feed = 0;  // mm/s; > 0 replaces programmed feeds
    // mm/s, wanted by couplings; kept as a feed is
    double speed_ceiling = std::numeric_limits<double>::infinity();
    bool hold = false;          // brake along the path, stop
    bool single_block = false;  // stop at the end of the running block until step_block()
    bool in_position = true;    // measured axes are where they should be
    double emergency_dec = 0;   // mm/s2; > 0 brakes with it at once, exempt from jerk
};

enum class Stands : std::uint8_t {
    Moving = 0,
    NoRecord,      // nothing appended behind
    BeforeRecord,  // record `record` has stop_before: it is the kernel's turn
    InPosition,    // waits for the measured axes
    Held,
    BlockEnd,  // single block
    NoFeed,    // feed or override is 0, spindle stopped at feed per revolution
};

struct PathStep {
    std::uint64_t record = 0;  // running at the end of the tick, or stopped at its end
    double s = 0;              // mm along it
    double speed = 0;          // mm/s
    double acceleration = 0;   // mm/s2
    std::uint64_t began_from = 0, began_to = 0;
    std::uint64_t ended_from = 0, ended_to = 0;
    // the path is stopped at the end of `record`, which has ended in this tick or an earlier one
    bool over = false;
    Stands stands = Stands::NoRecord;
};

class PathPlanner {
public:
    // dt: tick in seconds. horizon: records that are considered (PT_HORIZON).
    void configure(double dt, std::uint32_t horizon) noexcept;
    // Forget everything; the next appended record is number `next`; the path is stopped.
    void clear(std::uint64_t next) noexcept;

    // Fewer than the horizon are there (counted from the running one) and this tick has not taken
    // its share yet.
    [[nodiscard]] bool wants_record() const noexcept {
        return end_ - first_ < horizon_ && appended_ < kAppendsPerTick;
    }
    void append(const PlannedRecord& record) noexcept;
    // number that append() gives
    [[nodiscard]] std::uint64_t next_record() const noexcept { return end_; }

    PathStep tick(const PathInput& input) noexcept;

    // The path is stopped at the beginning of `to - 1` (or anywhere, after a hold) and goes on at
    // the start of `to`: the records between were executed or dropped by the kernel. `to` may be
    // next_record().
    void skip(std::uint64_t to) noexcept;
    void let_pass(std::uint64_t record) noexcept;  // a record that stopped the path does so no more
    // it does again; only while the path rests in front of it
    void stand_before(std::uint64_t record) noexcept;
    // single block: drive the next one
    void step_block() noexcept {
        block_latch_ = kNone;
        block_done_ = false;
    }

    // Of a record that began or ended in the last tick: when, 0 (the tick's beginning) to 1 (its
    // end).
    [[nodiscard]] double begin_fraction(std::uint64_t record) const noexcept {
        return at(record).begin_fraction;
    }
    [[nodiscard]] double end_fraction(std::uint64_t record) const noexcept {
        return at(record).end_fraction;
    }
    [[nodiscard]] double speed() const noexcept { return state_.v; }
    [[nodiscard]] double acceleration() const noexcept { return state_.a; }
    [[nodiscard]] bool at_rest() const noexcept { return state_.v == 0 && state_.a == 0; }
    // Ticks in which no step was found that keeps the committed profile; then it brakes. Stays 0;
    // tests ask.
    [[nodiscard]] std::uint64_t anomalies() const noexcept { return anomalies_; }

private:
    // Planning uses a little less jerk than allowed; the rest is what landing needs to end exactly
    // at a point.
    static constexpr double kPlannedJerk = 0.995;
    static constexpr std::uint64_t kNone = ~0ull;
    // Pieces of brakings that a tick may try; then the committed profile is followed. Bounds the
    // work of a tick.
    static constexpr std::uint32_t kPiecesPerTick = 200;

    struct Slot : PlannedRecord {
        double begin_fraction = 0, end_fraction = 0;
    };
    // What a run of kGroup records has in common, so that the view can pass over it in one step.
    static constexpr std::uint32_t kGroup = 16;
    struct Group {
        double length, v_max, feed;  // sum; least of each
        Limits least, most;
        double longest;
        FeedMode feed_mode;
        std::uint16_t spindle;
        bool override_locked, mixed;  // the three above differ
        bool stops, block_ends;
    };
    enum class SpeedLimits : std::uint8_t { Hard, Wanted };
    // What lies ahead, read from the window as far as needed (path_view.cpp).
    class View final : public Road {
    public:
        void begin(PathPlanner& planner, SpeedLimits which, const PathInput& input) noexcept;
        // The same for a tick that begins at x on the road, from what the stretches say. False: the
        // road ends there.
        [[nodiscard]] bool around(const PathState& x) noexcept;

        // Does the limit rise within the distance over which the acceleration that the tick at x
        // leads to is released?
        [[nodiscard]] bool rises(const PathState& x) noexcept;

        double speed_limit = 0;  // over what a tick can touch
        // over what a tick can touch, at the speed and acceleration that it can come to
        Limits tick;
        std::uint32_t within = 0;  // the stretch where it begins
        // the path must stop at its end; kNone: not seen, or the window is full
        std::uint64_t end_record = kNone;

    private:
        void more() noexcept override;
        void narrow_tick(const Limits& touched, const PathState& x, double highest) noexcept;
        void join(const PlannedRecord& record, double speed_limit) noexcept;
        bool pass_group() noexcept;
        PathPlanner* planner_ = nullptr;
        const PathInput* input_ = nullptr;
        SpeedLimits which_ = SpeedLimits::Hard;
        std::uint64_t record_ = 0;  // the last that was read
        double known_ = 0;          // where it ends
        double reach_ = 0;          // how far this tick can lead
        double fast_ = 0;           // no limit above it matters
        double chunk_ = 0;          // a stretch need not be longer
    };
    // A state that this tick could lead to.
    struct Step {
        PathState next;
        double speed = 0;  // towards this ...
        Limits limits;     // ... under these; a = 0: not by profile_to_speed
    };

    [[nodiscard]] const Slot& at(std::uint64_t record) const noexcept {
        return slots_[record % kPlannerWindow];
    }
    [[nodiscard]] Slot& at(std::uint64_t record) noexcept {
        return slots_[record % kPlannerWindow];
    }
    [[nodiscard]] double speed_limit_of(const PlannedRecord& record, SpeedLimits which,
                                        const PathInput& input) const noexcept;
    void add_to_group(std::uint64_t record) noexcept;
    [[nodiscard]] bool stops_at_end(std::uint64_t record) const noexcept;
    [[nodiscard]] Step step_towards(double speed, const Limits& limits) const noexcept;
    [[nodiscard]] double speed_at(const Step& step, double distance) const noexcept;
    [[nodiscard]] bool comes_to_rest(View& view, SpeedLimits which, const PathState& x) noexcept;
    void commit(SpeedLimits which) noexcept;
    void drop_committed() noexcept;
    [[nodiscard]] bool follows_blindly() const noexcept;
    [[nodiscard]] bool push(View& view) noexcept;
    [[nodiscard]] bool commit_braking(const PathInput& input) noexcept;
    void keep_braking_profile() noexcept;
    [[nodiscard]] PathState follow_committed() noexcept;
    [[nodiscard]] bool safe(View& view, SpeedLimits which, const Step& step) noexcept;
    [[nodiscard]] bool take(View& view, SpeedLimits which, const Step& step) noexcept;
    [[nodiscard]] bool best_between(View& view, SpeedLimits which, const PathState& low,
                                    const PathState& high, PathState& next) noexcept;
    [[nodiscard]] double lowest_violated(View& view, const PathState& next) noexcept;
    [[nodiscard]] bool want(const PathInput& input) noexcept;
    [[nodiscard]] PathState choose(const PathInput& input) noexcept;
    [[nodiscard]] bool begin_landing(View& view) noexcept;
    [[nodiscard]] bool step_over_rest(View& view) noexcept;
    [[nodiscard]] Stands leave_standstill(const PathInput& input, PathStep& step) noexcept;
    void carry(const PathState& next, PathStep& step) noexcept;

    double dt_ = 0.001;
    std::uint32_t horizon_ = 1024;
    std::uint64_t first_ = 0, end_ = 0;  // records of the window; first_ runs
    std::uint32_t appended_ = 0;         // since the last tick
    PathState state_;                    // s along record first_
    bool began_ = false;                 // record first_ has begun
    // the path is stopped at the end of record first_, which has ended
    bool done_ = false;
    std::uint64_t block_latch_ = kNone;  // single block: stop at the end of this record
    bool block_done_ = false;            // and it does
    // The profile to standstill that made the last step safe, and how much of it has been driven
    // since, s; below 0: there is none.
    Braking committed_, tried_;
    std::uint32_t pieces_ = 0;  // tried in this tick
    double committed_time_ = -1;
    bool committed_wanted_ = false;  // it keeps what was wanted, too
    bool committed_aims_ = false;    // it goes through a slower stretch
    // the record at whose end it stops for want of road; kNone: it need not
    std::uint64_t committed_end_ = kNone;
    // Steps before that: a push is tried as a whole and then driven without another thought, unless
    // something else is wanted.
    static constexpr std::uint32_t kPush = 16;
    std::array<PathState, kPush> push_;  // after each tick; s is what is moved in it
    std::uint32_t pushed_ = 0, push_end_ = 0, stride_ = 1;
    // ticks for which the committed profile is followed without looking for better
    std::uint32_t timeout_ = 0, failures_ = 0;
    // what is wanted has changed, and the committed profile is still the old one
    bool other_wanted_ = false;
    std::array<double, 7> wanted_{};     // see want()
    std::uint64_t landing_end_ = kNone;  // on a fixed profile that ends at the end of this record
    Landing landing_;
    std::uint64_t anomalies_ = 0;
    View view_;  // of this tick; a member because it is large
    std::array<Group, kPlannerWindow / kGroup> groups_{};
    std::array<Slot, kPlannerWindow> slots_{};
};

}  // namespace polyturn::kernel
