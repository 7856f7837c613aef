#include "channels/records/ring_out.hpp"

#include "ipc/kinematics/kinematics.hpp"

namespace polyturn::channels {

RingOut::RingOut(ChannelSegment& own, const KernelSegment& kernel, unsigned index,
                 std::uint64_t horizon, EventInbox& inbox)
    : own_(&own),
      kernel_(&kernel),
      index_(index),
      horizon_(horizon),
      inbox_(&inbox),
      producer_(own.path, kernel.path_tail[index]) {}

bool RingOut::may_wait() {
    // P3: a counter, announces nothing
    own_->heartbeat.fetch_add(1, std::memory_order_relaxed);
    inbox_->poll();
    if (inbox_->interrupts())
        aborted_ = true;
    else
        own_->bell.ring();
    return !aborted_;
}

std::uint16_t RingOut::enter(const Kinematics& kinematics) {
    if (entry_ != 0 && same(own_->kinematics[entry_ - 1u], kinematics)) return entry_;
    entry_ = static_cast<std::uint16_t>(entry_ % kKinematics + 1u);
    // visible with the push of the first record that names it (P1)
    own_->kinematics[entry_ - 1u] = kinematics;
    return entry_;
}

bool RingOut::wait_for_kernel() {
    const Doorbell& bell = kernel_->channel_bell[index_];
    const std::uint32_t seen = bell.seen();
    if (!may_wait()) return false;
    if (!producer_.claim()) bell.wait(seen, 20'000);
    return true;
}

bool RingOut::has_room() const {
    constexpr std::uint64_t kEnough = 512;
    // P3: how much room; claim() looks itself (P2)
    return producer_.head() - kernel_->path_tail[index_].tail.load(std::memory_order_acquire) +
               kEnough <=
           kPathRing;
}

PathRecord& RingOut::claim() {
    while (!aborted_) {
        if (PathRecord* slot = producer_.claim()) return *(claimed_ = slot);
        if (!wait_for_kernel()) break;
    }
    return scratch_;
}

void RingOut::commit() {
    if (aborted_) return;
    // P4: own word
    claimed_->epoch = own_->epoch.load(std::memory_order_relaxed);
    producer_.commit();
    // P3: only whether to ring
    if (producer_.head() - kernel_->path_tail[index_].tail.load(std::memory_order_acquire) ==
        horizon_)
        own_->bell.ring();
}

}  // namespace polyturn::channels
