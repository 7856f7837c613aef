// Records of asynchronous motion: positioning axes and spindles, waiting for them, torque limits,
// reference points. The moving axes are registered here, so that no move of the path takes an axis
// that has not arrived, whatever the language.
#include <algorithm>
#include <charconv>

#include "channels/records/record_place.hpp"
#include "ipc/image/positioning_step.hpp"

namespace polyturn::channels {

void RecordSink::beside(const Move& move, const BlockContext& at) {
    // a step of its own program: they wait for each other in the kernel
    const bool own = at.own_axis >= 0;
    if (!own) await_axes_of(move, at);  // the same axis again: one after the other
    if (own) own_room(at);
    if (own && !own_moved_) {
        own_from_ = move.machine_start;
        own_moved_ = true;
    }
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        if (!(move.moved >> i & 1u)) continue;
        PathRecord r = event(RecordKind::PositioningAxis, at, note_move(move, at));
        const ChannelAxis& axis = view_->axes[i];
        r.code = static_cast<std::int32_t>(!own            ? PositioningStep::Plain
                                           : at.own_by_way ? PositioningStep::MoveBy
                                                           : PositioningStep::Move);
        r.axis_count = 1;
        r.axis[0] = axis.machine_axis;
        r.start[0] = move.machine_start[i];
        r.end[0] = at.own_by_way ? move.machine[i] - own_from_[i] : move.machine[i];
        r.feed_mode = static_cast<std::uint8_t>(move.feed_mode);
        r.spindle = move.spindle;
        const double feed = move.feed * shares_.beside[i];
        if (move.feed_mode == FeedMode::PerRevolution) r.feed = feed;
        if (move.feed_mode == FeedMode::PerMinute)
            r.v_max =
                std::min(feed, axis.max_feed_mm_min > 0 ? axis.max_feed_mm_min * shares_.velocity[i]
                                                        : feed) /
                60.0;
        under_way_.axis[axis.machine_axis] = true;
        // behind a move of its own it begins from rest
        push(r, (last_moved_ >> i & 1u) != 0, false);
    }
    last_ = at;
}

// Counts the step that follows.
void RecordSink::own_room(const BlockContext& at) {
    if (++own_steps_ < kStepsAtOnce) return;
    own_step(PositioningStep::Room, at);
    own_steps_ = 0;
}

// OWN_BEGIN and OWN_END around the steps, and those that are not moves.
void RecordSink::own_step(PositioningStep step, const BlockContext& at) {
    PathRecord r = event(RecordKind::PositioningAxis, at, 0);
    if (step == PositioningStep::Begin) {
        own_steps_ = 0;
        own_moved_ = false;
    }
    r.code = static_cast<std::int32_t>(step);
    r.axis_count = 1;
    r.axis[0] = view_->axes[static_cast<std::size_t>(at.own_axis)].machine_axis;
    under_way_.axis[r.axis[0]] = true;
    push(r, step != PositioningStep::End, false);
    last_ = at;
}

void RecordSink::own_dwell(const Dwell& dwell, const BlockContext& at) {
    own_room(at);
    PathRecord r = event(RecordKind::PositioningAxis, at, note_step(&dwell, nullptr, at));
    r.code = static_cast<std::int32_t>(PositioningStep::Dwell);
    r.axis_count = 1;
    r.axis[0] = view_->axes[static_cast<std::size_t>(at.own_axis)].machine_axis;
    r.feed = dwell.value;
    push(r, false, false);
}

void RecordSink::own_function(const Aux& aux, const BlockContext& at) {
    own_room(at);
    PathRecord r =
        event(RecordKind::PositioningAxis, at, aux.silent ? 0 : note_step(nullptr, &aux, at));
    r.code = static_cast<std::int32_t>(PositioningStep::Function);
    r.axis_count = 1;
    r.axis[0] = view_->axes[static_cast<std::size_t>(at.own_axis)].machine_axis;
    r.mask = static_cast<std::uint32_t>(aux.letter);
    r.value = aux.value;
    push(r, false, false);
}

void RecordSink::await(const Outstanding& whom, const BlockContext& at) {
    PathRecord r;
    const auto put = [&] {
        if (r.axis_count == 0) return;
        r.kind = static_cast<std::uint8_t>(RecordKind::Await);
        r.flags = kBlockBegin | kBlockEnd;
        place(at, r);
        push(r, true, false);
        r = {};
    };
    const auto take = [&](std::size_t slot) {
        r.axis[r.axis_count++] = static_cast<std::uint8_t>(slot);
        if (r.axis_count == r.axis.size()) put();
    };
    const Outstanding wanted = whom;  // it may be under_way_ itself
    for (std::size_t a = 0; a < kMaxAxes; ++a)
        if (wanted.axis[a] && under_way_.axis[a]) {
            under_way_.axis[a] = false;
            take(a);
        }
    for (std::size_t s = 0; s < kMaxSpindles; ++s)
        if (wanted.spindle[s]) {
            under_way_.spindle[s] = false;
            take(kMaxAxes + s);
        }
    put();
}

void RecordSink::await_axes_of(const Move& move, const BlockContext& at) {
    Outstanding whom;
    bool any = false;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if ((move.moved >> i & 1u) && under_way_.axis[view_->axes[i].machine_axis])
            whom.axis[view_->axes[i].machine_axis] = any = true;
    if (any) await(whom, at);
}

void RecordSink::await_spindles(const BlockContext& at) {
    Outstanding whom;
    whom.spindle = under_way_.spindle;
    await(whom, at);
}

// OWN_BEGIN, OWN_END; HOME with a set of places; WINDOW<place> and TORQUE<place>.
bool RecordSink::demand(std::string_view name, double value, const BlockContext& at) {
    const auto place_in = [&](std::string_view word, unsigned& place_of) {
        if (name.substr(0, word.size()) != word) return false;
        const char* const end = name.data() + name.size();
        return std::from_chars(name.data() + word.size(), end, place_of).ptr == end &&
               place_of < view_->axis_count;
    };
    unsigned i = 0;
    if ((name == "OWN_BEGIN" || name == "OWN_END") && at.own_axis >= 0) {
        own_step(name == "OWN_BEGIN" ? PositioningStep::Begin : PositioningStep::End, at);
        return true;
    }
    if (name == "HOME") {
        PathRecord r = event(RecordKind::Home, at, 0);
        for (unsigned k = 0; k < view_->axis_count && r.axis_count < r.axis.size(); ++k)
            if (static_cast<AxisSet>(value) >> k & 1u)
                r.axis[r.axis_count++] = view_->axes[k].machine_axis;
        push(r, true, false);
        return true;
    }
    if (place_in("WINDOW", i)) {
        window_mm_[i] = value;
        return true;
    }
    if (!place_in("TORQUE", i)) return false;
    PathRecord r = event(RecordKind::Torque, at, 0);
    r.axis_count = 1;
    r.axis[0] = view_->axes[i].machine_axis;
    r.value = value;
    r.shape[0] = window_mm_[i];
    push(r, true, false);
    return true;
}

}  // namespace polyturn::channels
