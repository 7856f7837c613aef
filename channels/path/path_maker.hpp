// From programmed moves to final path records: corners become blends or stops, every record gets
// its limits.
//
//   programmed   |----------A----------|----------B----------|
//   records      |---A---|~half~|~half~|----B----|~half~| ...       ~ blend; the first half belongs
//                                                                   to A, the second to B
//
// Invariants
//   I1  Consecutive records of one path meet in position, tangent and curvature, or the earlier one
//       has kExactStop.
//   I2  Each block that moves has exactly one record with kBlockBegin and one, the same or a later
//       one, with kBlockEnd.
//   I3  One move is kept back, of a smooth run of short lines (spline_run.hpp) some dozens; all go
//       out before flush() returns.
//   I4  What is not motion leaves in its order: between the last record of the move before and the
//       first of the next.
//
// A stop instead of a blend: where it is faster (a sharp corner within 5 um is passed at about 1
// mm/s), asked for (G9, G61), tolerance 0, a turn of more than 160 degrees, more than kMaxCurveAxes
// in the corner, one side measured in degrees and the other in millimetres, a rapid move on either
// side unless N0421 ROL (two rapid moves then overlap as far as N0422 says, whatever the
// tolerance), a thread begins or ends, the record between needs one. Where threads are joined the
// spindle leads: it does not slow down for a corner, so the corner is rounded as far as its speed
// asks for, beyond the tolerance if it must, also beyond tolerance 0 (fagor_8037t part 1, 6.11:
// joined with G05). Where a stop is asked for, or the turn is too sharp to round, they are not
// joined: the second one begins anew from rest.
#pragma once
#include <deque>

#include "channels/path/spline_run.hpp"

namespace polyturn::channels {

// Where finished records go: the ring, or a test's vector.
class RecordOut {
public:
    virtual ~RecordOut() = default;
    virtual PathRecord& claim() = 0;  // the slot to fill completely; may wait for room
    virtual void commit() = 0;        // it is final
};

class PathMaker {
public:
    PathMaker(RecordOut& out, const PathLimits& limits) : out_(&out), limits_(&limits) {}

    // Other limits from here on; nothing is kept back (after flush or discard).
    void use_limits(const PathLimits& limits) { limits_ = &limits; }

    // Runs of short lines from here on (after flush).
    void smooth(const Smoothing& smoothing) { smoothing_ = smoothing; }

    // The next move: fill the cleared record (kind Line or Arc, slots, start, end, shape of an arc,
    // feed, flags except the block's begin and end, block, note), then add it. length and limits
    // are computed here. kExactStop: stop at its end.
    PathRecord& next_move();
    double length_of_next();
    void add_move();

    // Revolutions a second of the spindle that the threads behind this follow; 0: not known.
    void thread_turns(double rev_s) { thread_rev_s_ = rev_s; }

    // A record without motion. `stops`: the path comes to rest before it.
    void add_event(const PathRecord& record, bool stops);

    void flush();    // everything goes out; the path ends here
    void discard();  // forget what is kept back: reset

private:
    struct Kept {
        PathRecord move;             // as programmed
        RecordLimits record_limits;  // of the whole move
        double from = 0;             // path before it is already out
        bool begun = false;          // so is its kBlockBegin
        std::uint64_t number = 0;    // counts moves
    };
    struct Between {  // not motion, behind the move of that number
        std::uint64_t number;
        PathRecord record;
    };
    void close_chain();
    void join(Kept& a, Kept& b);
    bool must_stop(const PathRecord& a, const PathRecord& b) const;
    double overlap_way(const Kept& of) const;
    bool stop_is_faster(const Kept& a, const Kept& b, const RecordLimits& rules);
    double through_blend(const Kept& a, const Kept& b, double& length);
    double wanted_speed(const PathRecord& r) const;
    Junction blend_threads(const Kept& a, const Kept& b, double speed, double& most);
    void put_part(Kept& of, double to, bool last, bool stop);
    void put_pieces(Kept& of, const Blend& blend, std::size_t first, std::size_t end,
                    const RecordLimits& rules, bool last);
    void put_between(std::uint64_t up_to);
    double nose_of(const PathRecord& move, std::uint8_t axis) const;
    bool may_run(const PathRecord& a, PathRecord& b);
    bool agree_on_axes(PathRecord& a, PathRecord& b) const;
    void run_on();
    void begin_run();
    void end_run();
    void put_run();

    RecordOut* out_;
    const PathLimits* limits_;
    Smoothing smoothing_;
    // moves that are not wholly out; more than one only in a run of short lines
    std::deque<Kept> chain_;
    Kept coming_;
    std::uint64_t number_ = 0;
    double thread_rev_s_ = 0;
    bool running_ = false;          // spline_ has begun
    std::uint64_t run_number_ = 0;  // of the run's first line
    SplineRun spline_;
    std::deque<Between> between_;
    // PathRecord::nose of each machine axis behind the newest of chain_
    std::array<double, kMaxAxes> nose_{};
    Blend blend_;
    PathRecord scratch_;
};

// A piece of a curve neither begins nor ends the curve's move unless it is the first or the last
// one.
inline std::uint32_t begin_flag(const PathRecord& r) {
    return (r.flags & kMoreBefore) ? 0u : std::uint32_t{kBlockBegin};
}
inline std::uint32_t end_flag(const PathRecord& r) {
    return (r.flags & kMoreBehind) ? 0u : std::uint32_t{kBlockEnd};
}

// Length of a programmed move in its metric: millimetres over the linear axes, degrees when none of
// them moves.
double path_length(const PathRecord& move, const PathLimits& limits);
// The part [from, to] of a Line, Arc or Curve.
void cut(const PathRecord& whole, double from, double to, PathRecord& part);

}  // namespace polyturn::channels
