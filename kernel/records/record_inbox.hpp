// The only entry of a channel process' records into the kernel. The process may write its segment
// at any moment and with anything: only a copy in the kernel's memory counts, made once, checked
// there (record_check.hpp), and never read again in the segment.
//
//   its ring   | executed | being driven ... | checked, not planned | written, not looked at |
//              tail ^ cursor                                  taken ^                    head ^
//
// head: believed only within last head .. cursor + kPathRing
//
// Invariants
//   I1  Records in [cursor, taken()) are checked copies. Behind taken() nothing is known: record()
//       gives an empty record.
//   I2  After a refusal nothing more is taken before the channel's process has a successor, or
//       begins behind a reset.
//   I3  The work of a tick is bounded: kCopiesPerTick records, kSkipsPerTick of an older epoch.
//   I4  A transformation is copied and checked with the first record that names it after a change;
//       while a record that waits names it, it must not change.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include "kernel/records/record_check.hpp"

namespace polyturn::kernel {

class RecordInbox {
public:
    static constexpr std::uint64_t kCopiesPerTick = 256;  // twice what the planner takes
    static constexpr std::uint64_t kSkipsPerTick = 512;
    // What cannot be, by the name of the field; nullptr: nothing.
    struct Refusal {
        const char* field = nullptr;
        std::uint64_t record = 0;
        std::uint32_t line = 0;
        std::size_t axis = kMaxAxes;  // that would have left its limits; kMaxAxes: none
    };

    // takes its memory; not in the cyclic thread
    void prepare();
    void attach(const ChannelSegment& segment) noexcept;  // at the beginning of its ring
    // Nothing before `at` is wanted any more: behind a reset, or after other records were
    // discarded.
    void begin_at(std::uint64_t at) noexcept;

    // Where the ring ends now. One that cannot be is a refusal with the next look(), and is not
    // used.
    std::uint64_t head(std::uint64_t cursor) const noexcept {
        // P1: the records before head are complete
        const std::uint64_t now = segment_->path.head.load(std::memory_order_acquire);
        return believable(now, cursor) ? now : head_;
    }
    void look(std::uint64_t cursor) noexcept;
    // Of a record that is judged, or only lies there.
    std::uint32_t epoch_of(std::uint64_t index) const noexcept {
        return index < taken_ ? record(index).epoch : segment_->path.slot(index).epoch;
    }
    // Likewise: whether a run in virtual time may go on is decided before the tick that takes it.
    // Nothing is driven by these.
    RecordKind kind_of(std::uint64_t index) const noexcept {
        return static_cast<RecordKind>(index < taken_ ? record(index).kind
                                                      : segment_->path.slot(index).kind);
    }
    std::uint32_t flags_of(std::uint64_t index) const noexcept {
        return index < taken_ ? record(index).flags : segment_->path.slot(index).flags;
    }
    // Copies and judges up to `end`, those of `epoch`.
    void take(std::uint64_t cursor, std::uint64_t end, std::uint32_t epoch, const Core& core,
              unsigned channel) noexcept;
    std::uint64_t taken() const noexcept { return taken_; }

    const PathRecord& record(std::uint64_t index) const noexcept {
        return index < taken_ ? copies_[index % kPathRing] : kNothing;
    }
    const Kinematics* kinematics(std::uint32_t entry) const noexcept {
        return entry >= 1 && entry <= kKinematics ? &kinematics_[entry - 1] : nullptr;
    }
    // A transformation has changed since the last call: what was driven with another one under this
    // number cannot be driven back.
    bool kinematics_changed() noexcept { return std::exchange(changed_, false); }
    const Refusal& refusal() const noexcept { return refusal_; }
    void refuse(const Refusal& why) noexcept {
        if (!refusal_.field) refusal_ = why;
    }

private:
    bool believable(std::uint64_t head, std::uint64_t cursor) const noexcept {
        return head >= head_ && head >= cursor && head - cursor <= kPathRing;
    }
    const Kinematics* look_up(const PathRecord& r, std::uint64_t cursor) noexcept;

    static const PathRecord kNothing;
    const ChannelSegment* segment_ = nullptr;
    std::unique_ptr<std::array<PathRecord, kPathRing>> memory_;
    PathRecord* copies_ = nullptr;
    std::uint64_t head_ = 0, taken_ = 0;
    std::array<Kinematics, kKinematics> kinematics_{};
    // index behind the last record that names it; 0: none does
    std::array<std::uint64_t, kKinematics> named_{};
    bool changed_ = false;
    RecordCheck check_;
    Refusal refusal_;
};

}  // namespace polyturn::kernel
