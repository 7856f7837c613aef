// Which block begins, goes on and ends compensation. The moves that come of it are made in
// nose_moves.cpp.
#include "channels/compensation/compensator.hpp"

#include "channels/compensation/interference.hpp"
#include "channels/compensation/left_block.hpp"

namespace polyturn::channels::compensation {

void Compensator::open(Sink& out, unsigned p, unsigned q, const Options& options) {
    *this = Compensator();
    look_back_.open(out);
    out_ = &look_back_;
    configure(p, q, options);
}

void Compensator::set_options(const Options& options) {
    options_ = options;
    look_back_.configure(p_, q_, options.check == Check::Off ? 0 : options.look_back_blocks);
}

bool Compensator::closed() const {
    return state_ == State::Off && !holds() && !halted_ && !displaced() && !suspended_;
}

void Compensator::pump() {
    if (failed_) {
        trailing_.clear();
        ready_.clear();
    } else if (!halted_ && !ready_.empty()) {
        halted_ = ready_.pass_on(*out_);
    }
}

void Compensator::resume() {
    halted_ = false;
    pump();
}

bool Compensator::holds_moves_back() {
    bool any = false;
    ready_.change_moves([&any](Move&) { any = true; });
    return any;
}

void Compensator::ensure_halt(const BlockContext& at) {
    if (!halted_ && !ready_.will_halt() && !trailing_.will_halt()) queue().barrier(at);
    pump();
}

void Compensator::halt_before_held(const BlockContext& at) {
    ready_.barrier(at);
    pump();
}

void Compensator::select(int side) {
    cancel_ = false;
    selected_ = true;
    if (state_ == State::Off)
        state_ = State::Armed;
    else if (state_ == State::Leaving)
        state_ = State::On;
    else if (state_ == State::On && side == side_)
        repeated_ = true;
    side_ = side;
}

void Compensator::nose(double radius, Vec tip, bool has_offset, Vec offset_step) {
    nose_ = std::fabs(radius);
    nose_sign_ = radius < 0 ? -1 : 1;
    tip_ = tip;
    has_offset_ = has_offset;
    offset_step_ = offset_step;
}

bool Compensator::in_plane(const Move& m) const {
    constexpr double kSame = 1e-9;  // mm, as Core compares it
    if (m.offset_alone) return false;
    return is_arc(m) || std::fabs(m.machine[p_] - m.machine_start[p_]) > kSame ||
           std::fabs(m.machine[q_] - m.machine_start[q_]) > kSame;
}

// Where the move begins as seen with the offset that it ends with. Corners are made of what their
// two elements have there, each from its own end of them.
Vec Compensator::contour_start(const Move& m) const { return begins_at(m) + offset_step_; }

Element Compensator::element_of(const Move& m) const {
    const Vec start = contour_start(m), end{m.machine[p_], m.machine[q_]};
    Element e = is_arc(m) ? arc(start, end, {m.centre_p, m.centre_q}, m.sweep) : line(start, end);
    e.nose = nose_;
    e.side = side_ * nose_sign_;
    return e;
}

void Compensator::move(const Move& m, const BlockContext& at) {
    if (failed_) return;
    if (m.beside) {  // no move of the path
        queue().move(m, at);
        return pump();
    }
    if (bypass_ != Bypass::None && state_ != State::Off) {
        moved_ = true;
        if (bypass_ == Bypass::Plain) {
            straight_to_programmed(m, at);
            return;
        }
        Move shifted = m;
        shift(shifted);
        deliver(shifted, at);
        return;
    }
    if (suspended_) {
        moved_ = true;
        suspended_ = false;
        straight_to_programmed(m, at);
        state_ = cancel_ || state_ == State::Leaving || state_ == State::Off ? State::Off
                 : options_.resume_at_intersection                           ? State::Resuming
                                                                             : State::Armed;
        cancel_ = repeated_ = false;
        return;
    }
    if (!in_plane(m)) {  // it waits with the others until the nose's place is known
        if (held_) {
            trailing_.move(m, at);
        } else {
            Move shifted = m;
            shift(shifted);
            deliver(shifted, at);
        }
        return;
    }
    moved_ = true;
    idle_blocks_ = 0;
    const bool cancels = cancel_;
    cancel_ = false;
    if (cancels && (state_ == State::Armed || state_ == State::Resuming)) state_ = State::Off;
    if (options_.rapid_suspends && m.kind == MoveKind::Rapid && state_ == State::On && !cancels) {
        // The cut behind it is not known yet: the move is the approach, or it is driven as
        // programmed.
        if (held_rapid())
            finish_at_programmed();
        else if (held_)
            finish(before_rapid());
        if (!failed_) hold(m, at, Role::Begin);
        return;
    }
    // CUTCONON: the vector of the last normal point stays
    if (options_.constant && state_ == State::On && !cancels) {
        if (held_) settle();
        if (failed_) return;
        Move shifted = m;
        shift(shifted);
        deliver(shifted, at);
        constant_ = true;
        return;
    }
    switch (state_) {
        case State::Off:
            deliver(m, at);
            return;
        case State::Armed:
        case State::Resuming:
            if (!has_offset_) {
                deliver(m, at);
                return;
            }
            if (in_place_) {  // from its position square onto the contour
                in_place_ = false;
                start_ = Vectors::one({});
                hold(m, at, Role::Contour);
                start_.add(block_.element.nose * block_.element.normal_at_start());
                state_ = State::On;
                return;
            }
            if (is_arc(m)) {
                fail(Alarm::CompArcStartEnd, true, at);
                return;
            }
            hold(m, at, state_ == State::Armed ? Role::Begin : Role::Resume);
            state_ = State::On;
            return;
        case State::On:
            if (cancels)
                cancel_block(m, at);
            else
                contour_block(m, at);
            return;
        case State::Leaving:
            if (is_arc(m)) {
                fail(Alarm::CompArcStartEnd, true, at);
                return;
            }
            straight_to_programmed(m, at);
            state_ = State::Off;
            return;
    }
}

void Compensator::hold(const Move& m, const BlockContext& at, Role role) {
    block_ = {m, at, element_of(m), tip_, role, false, false};
    held_ = true;
    repeated_ = settled_ = false;
}

void Compensator::contour_block(const Move& m, const BlockContext& at) {
    bool slow = false;  // the corner between the held element and this one
    if (held_) {
        const Element next = element_of(m);
        slow = slow_corner(block_, m, next);
        block_.slow_end = slow;
        CornerResult corner;
        if (repeated_)
            corner.vectors = Vectors::one(block_.element.nose * block_.element.normal_at_end());
        else if (block_.role == Role::Begin)
            corner = start_corner(from_nose(block_.element), next, options_);
        else
            corner = offset_corner(block_.element, next, options_);
        if (corner.fault != CornerFault::None) {
            fail(Alarm::CompNoIntersection, false, block_.at);
            return;
        }
        // rad, a little less than pi: an arc of half a turn is one in spite of rounding. Its last
        // vector is kept, for the nose goes round to the other side of its centre.
        constexpr double kHalfTurn = 3.14159;
        drop_small(corner.vectors, options_.small_vector,
                   next.arc && std::fabs(next.sweep) >= kHalfTurn);
        Vec gap;
        unsigned left_out = 0;
        if (!before_.empty() && !leave_out_short(next, corner, gap, left_out)) return;
        if (first_) {  // the approach ends on an element farther on
            hold(m, at, Role::Contour);
            return;
        }
        if (waits(next, corner)) {
            before_.push_back({block_, corner.vectors, {}, gap, left_out});
            before_.back().trailing.append(trailing_);
            hold(m, at, Role::Contour);
            block_.slow_begin = slow;
            return;
        }
        if (block_.role == Role::Begin && options_.entry >= Entry::Smooth) touches_ = next;
        const bool done = finish(corner.vectors);
        touches_.reset();
        if (!done) return;
        follow(gap);
    }
    if (constant_) {
        constant_ = false;
        start_ = Vectors::one(displacement_ - tip_);
        hold(m, at, Role::Contour);
        start_.add(block_.element.nose * block_.element.normal_at_start());
        drop_small(start_, 0.0, false);
        return;
    }
    const bool apart = !held_ && settled_ && options_.straight_after_halt;
    hold(m, at, Role::Contour);
    block_.slow_begin = slow;
    if (!apart) return;
    start_.add(block_.element.nose * block_.element.normal_at_start());
    drop_small(start_, 0.0, false);
}

void Compensator::cancel_block(const Move& m, const BlockContext& at) {
    std::optional<Element> left;  // the retract is tangential to it
    if (is_arc(m)) {
        settle();
        if (!failed_) fail(Alarm::CompArcStartEnd, true, at);
        return;
    }
    if (held_ && !before_.empty() && options_.short_last != ShortLast::None) {
        bool done = false;
        if (!leave_short_last(m, done)) return;
        if (done) {
            straight_to_programmed(m, at);
            wish_set_ = repeated_ = false;
            state_ = State::Off;
            return;
        }
    }
    if (held_) {
        CornerResult corner;
        if (options_.rapid_suspends && m.kind == MoveKind::Rapid) {
            if (held_rapid())
                finish_at_programmed();
            else if (!finish(before_rapid()))
                return;
            wish_set_ = repeated_ = false;
            straight_to_programmed(m, at);
            state_ = State::Off;
            return;
        }
        if (wish_set_)
            corner = retract_corner(block_.element, wish_);
        else
            corner = cancel_corner(block_.element, to_nose(element_of(m)), options_);
        drop_small(corner.vectors, options_.small_vector, false);
        if (options_.entry >= Entry::Smooth && !wish_set_) left = block_.element;
        if (!finish(corner.vectors)) return;
    }
    wish_set_ = repeated_ = false;
    touches_ = left;
    straight_to_programmed(m, at);
    touches_.reset();
    state_ = State::Off;
    constant_ = false;
}

// Outside compensation the axes carry the tip: position of the nose centre at the free end of
// approach and retract.
Element Compensator::from_nose(Element e) const {
    if (options_.entry == Entry::Tangent) e.start = e.start - block_.tip;
    return e;
}
Element Compensator::to_nose(Element e) const {
    if (options_.entry == Entry::Tangent) e.end = e.end - block_.tip;
    return e;
}

// The nose stops its radius before the end of the element: what is there is not cut into (fagor
// 8.2.7).
Vectors Compensator::before_rapid() const {
    const Element& e = block_.element;
    const double way = e.arc ? std::fabs(e.sweep) * e.end_radius : length(e.end - e.start),
                 before = std::fmin(e.nose, way);
    const double path = e.arc ? e.nose_path_radius(e.end_radius) : 0.0;
    // On an arc the right angle is path^2 = before^2 + (distance outwards)^2, seen from the centre:
    // it stays on its circle about the centre, and touches the perpendicular there
    if (path > before && e.end_radius > 0) {
        const Vec outwards = (1.0 / e.end_radius) * (e.end - e.centre);
        return Vectors::one((std::sqrt(path * path - before * before) - e.end_radius) * outwards -
                            before * e.end_dir);
    }
    return Vectors::one(e.nose * e.normal_at_end() - before * e.end_dir);
}

// G40 without movement: straight from the compensated end to the programmed one.
void Compensator::leave_in_place() {
    here_ = block_.element.end + displacement_;
    go(block_, block_.element.end, false, {});
    start_ = Vectors::one({});
    displacement_ = {};
}

void Compensator::settle() {
    settled_ = true;
    if (held_rapid() && options_.rapid_suspends && !failed_) {
        finish_at_programmed();
        state_ = State::Armed;
        return;
    }
    if (held_ && first_ && !failed_) fail(Alarm::CompNoOffsetMeeting, false, block_.at);
    if (held_ && !failed_)
        finish(Vectors::one(block_.element.nose * block_.element.normal_at_end()));
}

void Compensator::suspend() {
    settle();
    if (state_ != State::Off && !failed_) suspended_ = true;
}

void Compensator::bypass(Bypass how) {
    settle();
    if (how == Bypass::None && bypass_ == Bypass::Plain &&
        (state_ == State::On || state_ == State::Resuming))
        state_ = options_.resume_at_intersection ? State::Resuming : State::Armed;
    bypass_ = how;
}

void Compensator::drop_vector() {
    if (failed_) return;
    if (held_) finish_at_programmed();
    if (state_ == State::On) state_ = State::Resuming;
}

void Compensator::block_done(bool counts) {
    if (cancel_) {  // G40 in a block that does not move in the plane
        settle();
        state_ = state_ == State::On && displaced() ? State::Leaving : State::Off;
        in_place_ = false;
        if (state_ == State::Leaving && options_.in_place && !failed_) {
            leave_in_place();
            state_ = State::Off;
        }
        cancel_ = wish_set_ = repeated_ = false;
        if (!failed_) look_back_.let_out();  // the contour is over
    } else if (!moved_ && selected_ && state_ == State::Armed && options_.in_place) {
        in_place_ = true;
    } else if (!moved_ && held_) {
        if (counts) ++idle_blocks_;
        if (idle_blocks_ > options_.idle_blocks && options_.idle_is_fault)
            fail(Alarm::CompIdleBlocks, true, block_.at);
        else if (!options_.idle_is_fault && (zero_ || idle_blocks_ >= options_.idle_blocks))
            settle();
    }
    moved_ = zero_ = selected_ = false;
}

// The held block may not be delivered (I2).
bool Compensator::fail(Alarm alarm, bool this_block, const BlockContext& at) {
    fault_ = {alarm, this_block, at};
    failed_ = true;
    held_ = false;
    before_.clear();
    first_.reset();
    trailing_.clear();
    look_back_.let_out();
    return false;
}

void Compensator::stop(const Stop& s, const BlockContext& at) {
    if (s.reason != StopReason::M00 && s.reason != StopReason::M01) settle();  // nothing follows
    queue().stop(s, at);
    pump();
}

void Compensator::barrier(const BlockContext& at) {
    settle();
    ready_.barrier(at);
    pump();
}

void Compensator::alarm(const Diagnosis& diagnosis, const BlockContext& at) {
    if (diagnosis.severity() != Severity::Error) {
        out_->alarm(diagnosis, at);
        return;
    }
    if (!failed_) {
        if (leaves_held_block(diagnosis.alarm)) settle();
        if (!halted_) ready_.pass_on_before_halt(*out_);
        failed_ = true;
        held_ = false;
        before_.clear();
        first_.reset();
        trailing_.clear();
    }
    ready_.clear();
    out_->alarm(diagnosis, at);
}

}  // namespace polyturn::channels::compensation
