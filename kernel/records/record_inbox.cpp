#include "kernel/records/record_inbox.hpp"

#include <algorithm>
#include <cstring>

namespace polyturn::kernel {
namespace {
PathRecord nothing() noexcept {
    PathRecord r{};
    r.epoch = ~0u;  // of no channel
    return r;
}

// The compiler must not look at the original again: it may be another one by then.
template <class T>
T copy_of(const T& original) noexcept {
    T copy;
    std::memcpy(static_cast<void*>(&copy), &original, sizeof copy);
    __asm__ volatile("" : : "r"(&copy) : "memory");
    return copy;
}
}  // namespace

const PathRecord RecordInbox::kNothing = nothing();

void RecordInbox::prepare() {
    if (memory_) return;
    memory_ = std::make_unique<std::array<PathRecord, kPathRing>>();
    copies_ = memory_->data();
}

void RecordInbox::attach(const ChannelSegment& segment) noexcept {
    segment_ = &segment;
    head_ = 0;
    refusal_ = {};
    kinematics_.fill({});
    begin_at(0);
}

void RecordInbox::begin_at(std::uint64_t at) noexcept {
    taken_ = at;
    head_ = std::max(head_, at);
    named_.fill(0);
    check_.begin_anew();
}

void RecordInbox::look(std::uint64_t cursor) noexcept {
    // P1: the records before head are complete
    const std::uint64_t now = segment_->path.head.load(std::memory_order_acquire);
    if (believable(now, cursor))
        head_ = now;
    else
        refuse({"head", now});
}

// Of the entry as it is now, read once.
const Kinematics* RecordInbox::look_up(const PathRecord& r, std::uint64_t cursor) noexcept {
    if (r.transform == 0 || r.transform > kKinematics) return nullptr;
    Kinematics& known = kinematics_[r.transform - 1u];
    const Kinematics now = copy_of(segment_->kinematics[r.transform - 1u]);
    if (!same(now, known)) {
        if (named_[r.transform - 1u] > cursor || !RecordCheck::sound(now)) return nullptr;
        known = now;
        changed_ = true;
    } else if (!RecordCheck::sound(known)) {
        return nullptr;
    }
    return &known;
}

void RecordInbox::take(std::uint64_t cursor, std::uint64_t end, std::uint32_t epoch,
                       const Core& core, unsigned channel) noexcept {
    if (taken_ < cursor) begin_at(cursor);
    end = std::min(end, head_);
    for (std::uint64_t n = 0; taken_ < end && n < kCopiesPerTick && !refusal_.field; ++n) {
        PathRecord& copy = copies_[taken_ % kPathRing];
        copy = copy_of(segment_->path.slot(taken_));
        // pushed before a reset was heard of, or after one that is still to come
        if (copy.epoch != epoch) return;
        const Kinematics* const k = copy.kind <= static_cast<std::uint8_t>(RecordKind::Curve)
                                        ? look_up(copy, cursor)
                                        : nullptr;
        if (const char* const field = check_.fault_of(copy, k, core, channel)) {
            return refuse({field, taken_, copy.line});
        }
        if (k) named_[copy.transform - 1u] = taken_ + 1;
        ++taken_;
    }
}

}  // namespace polyturn::kernel
