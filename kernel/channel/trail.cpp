#include "kernel/channel/trail.hpp"

#include <algorithm>

namespace polyturn::kernel {
namespace {

bool is_motion(const PathRecord& r) noexcept {
    return r.kind >= 1 && r.kind <= static_cast<std::uint8_t>(RecordKind::Curve);
}
bool is_wait(const PathRecord& r) noexcept {
    return static_cast<RecordKind>(r.kind) == RecordKind::Wait;
}

// What cannot be taken back.
bool is_wall(const PathRecord& r) noexcept {
    if (is_motion(r)) return (r.flags & (kThread | kTapping | kSkipMove | kFixedStop)) != 0;
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Aux:
        case RecordKind::PositioningAxis:
        case RecordKind::Torque:
        case RecordKind::Home:
        case RecordKind::Wait:
        case RecordKind::Stop:
            return true;
        case RecordKind::SpindleMode:
            return static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Position;
        default:
            return (r.flags & kDrains) != 0;
    }
}

}  // namespace

void Trail::prepare(std::size_t records) {
    if (ring_.size() == records) return;
    ring_.assign(records, {});
    if (!planner_) planner_ = std::make_unique<PathPlanner>();
    driven_.assign(kPlannerWindow, 0);
    clear();
}

void Trail::configure(double tick_s, std::uint32_t horizon) noexcept {
    if (planner_) planner_->configure(tick_s, horizon);
    clear();
}

void Trail::clear() noexcept {
    begin_ = end_ = 0;
    active_ = false;
    direction_ = 0;
    left_s_ = 0;
    if (planner_) planner_->clear(0);
}

void Trail::add(const PathRecord& record, double length, std::uint64_t meeting) noexcept {
    if (ring_.empty()) return;
    if (end_ - begin_ == ring_.size()) ++begin_;
    Entry& fresh = entry(end_);
    const std::uint64_t before = end_ > begin_ ? entry(end_ - 1).last_meeting : 0;
    fresh.record = record;
    fresh.length = is_motion(record) ? length : 0.0;
    fresh.meeting = is_wait(record) ? meeting : 0;
    fresh.last_meeting = fresh.meeting ? fresh.meeting : before;
    ++end_;
}

void Trail::met(std::uint64_t meeting) noexcept {
    constexpr std::uint64_t kMost = 64;  // records of a flying wait's own tick at the most
    for (std::uint64_t i = end_; i > begin_ && end_ - i < kMost; --i) {
        Entry& e = entry(i - 1);
        e.last_meeting = meeting;
        if (!is_wait(e.record)) continue;
        e.meeting = meeting;
        return;
    }
}

void Trail::enter(const PathRecord* record, double s) noexcept {
    if (!planner_) return;
    left_s_ = record ? s : 0.0;
    if (record) left_ = *record;
    at_ = limit();
    s_ = 0;
    active_ = true;
    direction_ = 0;
    planner_->clear(0);
}

bool Trail::blocks(std::uint64_t i) const noexcept { return is_wall(piece(i)); }

// Non-motion in between is passed over; a wall, the end of the memory or the place that was left
// end the search.
bool Trail::next(std::uint64_t from, std::uint64_t& i) const noexcept {
    for (std::uint64_t gap = from;;) {
        if (direction_ < 0 ? gap <= begin_ : gap >= limit()) return false;
        const std::uint64_t k = direction_ < 0 ? gap - 1 : gap;
        if (blocks(k)) return false;
        if (drives(k)) {
            i = k;
            return true;
        }
        gap = direction_ < 0 ? gap - 1 : gap + 1;
    }
}

void Trail::turn(int direction, bool through_waits) noexcept {
    direction_ = direction;
    through_waits_ = through_waits;
    planner_->clear(0);
    appended_ = false;
}

bool Trail::tick(const PathInput& input) noexcept {
    if (!active_ || direction_ == 0) return false;
    while (planner_->wants_record()) {
        std::uint64_t i = at_;
        double way = 0;
        if (!appended_ && s_ > 0) {  // the rest of the piece that contains it
            way = direction_ < 0 ? s_ : length(i) - s_;
            from_s_ = s_;
        } else {
            const std::uint64_t gap = !appended_       ? at_
                                      : direction_ < 0 ? last_appended_
                                                       : last_appended_ + 1;
            if (!next(gap, i)) break;
            way = length(i);
            if (!appended_) from_s_ = direction_ < 0 ? way : 0.0;
        }
        PlannedRecord planned = PlannedRecord::from(piece(i), false);
        planned.length = way;
        planned.wait_in_position = planned.block_end = false;
        // the corner at its beginning is the one at the end of what was driven before
        if (direction_ < 0) {
            planned.stop_after = false;
            for (std::uint64_t k = i; k > begin_; --k) {
                if (!drives(k - 1)) continue;
                planned.stop_after = (entry(k - 1).record.flags & (kExactStop | kInPosition)) != 0;
                break;
            }
        }
        driven_[planner_->next_record() % kPlannerWindow] = i;
        planner_->append(planned);
        appended_ = true;
        last_appended_ = i;
    }
    if (!appended_) return false;
    const PathStep step = planner_->tick(input);
    const std::uint64_t n = std::min(step.record, planner_->next_record() - 1);
    shown_ = driven_[n % kPlannerWindow];
    const double whole = length(shown_), from = n == 0 ? from_s_ : direction_ < 0 ? whole : 0.0;
    const bool over = step.ended_to > n || step.record > n;
    shown_s_ =
        over ? (direction_ < 0 ? 0.0 : whole) : std::clamp(from + direction_ * step.s, 0.0, whole);
    at_ = shown_;
    s_ = shown_s_;
    // I1
    if (s_ >= whole) {
        ++at_;
        s_ = 0;
    }
    return true;
}

bool Trail::stands() const noexcept {
    std::uint64_t i = 0;
    return active_ && planner_->at_rest() && direction_ != 0 && s_ <= 0 && !next(at_, i);
}

std::uint64_t Trail::nearest_obstacle() const noexcept {
    for (std::uint64_t gap = at_; s_ <= 0;) {
        if (direction_ < 0 ? gap <= begin_ : gap >= limit()) return kNone;
        const std::uint64_t k = direction_ < 0 ? gap - 1 : gap;
        if (blocks(k)) return k;
        if (drives(k)) return kNone;
        gap = direction_ < 0 ? gap - 1 : gap + 1;
    }
    return kNone;
}

const PathRecord* Trail::obstacle() const noexcept {
    const std::uint64_t k = nearest_obstacle();
    return k == kNone ? nullptr : &piece(k);
}

std::uint64_t Trail::obstacle_meeting() const noexcept {
    const std::uint64_t k = nearest_obstacle();
    return k == kNone || k >= end_ || !through_waits_ ? 0 : entry(k).meeting;
}

void Trail::pass() noexcept {
    const std::uint64_t k = nearest_obstacle();
    if (k == kNone) return;
    at_ = direction_ < 0 ? k : k + 1;
    s_ = 0;
    planner_->clear(0);
    appended_ = false;
}

std::uint64_t Trail::last_meeting() const noexcept {
    const std::uint64_t gap = active_ ? std::min(at_, end_) : end_;
    return gap > begin_ ? entry(gap - 1).last_meeting : 0;
}

bool Trail::beside(std::uint64_t meeting) const noexcept {
    if (!active_ || !planner_->at_rest() || s_ > 0) return false;
    for (std::uint64_t k = std::min(at_, end_); at_ <= end_ && k > begin_ && !drives(k - 1); --k)
        if (entry(k - 1).meeting == meeting) return true;
    for (std::uint64_t k = at_; k < end_ && !drives(k); ++k)
        if (entry(k).meeting == meeting) return true;
    return false;
}

}  // namespace polyturn::kernel
