// The store's segment: what it publishes to all others, and where it stands in the rings of kernel and supervisor.
// A store that was killed and started again goes on where its predecessor's segment says, so that no request is lost
// and none is answered for another.
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
    static Result<StoreImage> create(const std::string& instance, std::uint64_t generation);
    // Fills everything and lets the others attach.
    void publish_all(const StoreValues& values);
    // What these changes touched; then `version` grows. The kernel's list of parameter changes is the caller's.
    void publish(const StoreValues& values, const std::vector<Change>& changes);
    StoreSegment& segment() { return *own_; }

private:
    OwnSegment<StoreSegment> own_;
};

}  // namespace polyturn::toolmgmt
