// Writes finished records into the channel's ring. Waits for room on the kernel's doorbell, never
// longer than the process may be silent; gives up when a reset or the end comes in between: from
// then on records are dropped until resume().
//
// The kernel's bell is rung when the ring comes to hold the horizon (the kernel may wait for that
// in virtual time), before sleeping and by whoever says quiet; never per record. A crossing that is
// missed because the tail moved at the same instant costs nothing but time: the next sleep or quiet
// rings.
#pragma once
#include "channels/path/path_maker.hpp"
#include "channels/process/event_inbox.hpp"

namespace polyturn::channels {

class RingOut : public RecordOut {
public:
    RingOut(ChannelSegment& own, const KernelSegment& kernel, unsigned index, std::uint64_t horizon,
            EventInbox& inbox);
    PathRecord& claim() override;
    void commit() override;

    void resume() { aborted_ = false; }
    bool aborted() const { return aborted_; }
    // Entry (from 1) of the segment's transformations that holds it. The ring is drained when a new
    // one comes: a barrier.
    std::uint16_t enter(const Kinematics& kinematics);
    std::uint64_t last_index() const { return producer_.head() - 1; }  // of the newest record
    bool has_room() const;  // for a few hundred records, without waiting
    std::uint64_t pushed() const { return producer_.head(); }
    // Before a wait for another process: rings, shows life; false when an interrupt has come, then
    // nothing goes out any more.
    bool may_wait();

private:
    bool wait_for_kernel();
    ChannelSegment* own_;
    const KernelSegment* kernel_;
    unsigned index_;
    std::uint64_t horizon_;
    EventInbox* inbox_;
    RingProducer<RingHead<PathRecord, kPathRing>> producer_;
    PathRecord scratch_;
    PathRecord* claimed_ = nullptr;
    bool aborted_ = false;
    std::uint16_t entry_ = 0;  // newest; 0 none yet
};

}  // namespace polyturn::channels
