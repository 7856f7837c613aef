// The store's segment: what it publishes to all others, and its position in the rings of kernel
// and supervisor. A store that was killed is followed by another one in the same segment: nobody
// attaches again, no request is lost and none is answered for another. A segment that an earlier
// controller of that name left behind is replaced.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/segments.hpp"
#include "ipc/memory/segment.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

class StoreImage {
public:
    static Result<StoreImage> create(const std::string& instance, const SegmentHeader& supervisor);
    // Persist requests from here to persist_tail were only in the image of the dead predecessor;
    // see Service.
    std::uint64_t replay_from() const { return replay_from_; }
    // True when a dead predecessor's segment was taken over; it still shows what that one knew.
    bool taken_over() const { return taken_over_; }
    void read_into(StoreValues& values) const;
    void read_zeros_into(StoreValues& values) const;
    // Fills everything and lets the others attach.
    void publish_all(const StoreValues& values);
    // What these changes touched; then `version` grows. The kernel's list of parameter changes is
    // the caller's.
    void publish(const StoreValues& values, const std::vector<Change>& changes);
    // Nobody has rights: others see a user who cannot log in, where an empty list would make
    // everybody a maker.
    void set_locked(bool locked) { locked_ = locked; }
    // False: the kernel has left no space.
    bool push(const ToolAnswer& answer, std::uint64_t taken);
    StoreSegment& segment() { return *own_; }

private:
    void publish_totals(const StoreValues& values);
    void publish_tools(const StoreValues& values, const std::vector<Change>& changes);
    void publish_users(const StoreValues& values);
    // tool rows of the last publication: the other slot has older ones
    std::vector<std::size_t> written_;
    bool all_written_ = true, locked_ = false;
    std::uint64_t tool_version_ = 0;
    OwnSegment<StoreSegment> own_;
    std::uint64_t replay_from_ = 0;
    bool taken_over_ = false;
};

}  // namespace polyturn::toolmgmt
