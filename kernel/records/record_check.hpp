// Checks that a record from a channel's process can be driven. The process may be broken or
// hostile: nothing of it is trusted.
//
// Called on the kernel's own copy, once, before anything of it acts (record_inbox.hpp). What holds
// behind it, for every record of an inbox:
//   V1  axis_count fits the arrays; the axes of a motion exist, are the channel's (by the routes in
//   force) and none is there twice V2  slots of a plane, spindles, channels, inputs, letters, modes
//   and kinds are within their ranges; texts end V3  every number that is computed with is finite,
//   and small enough to be counted in increments V4  a motion begins where the one before it ended,
//   and its geometry says so too
// Speed limits are not trusted either, but monitored where they act: watch_commands().
#pragma once
#include <cstdint>

#include "ipc/kinematics/kinematics.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class RecordCheck {
public:
    // What the path has done is not known any more: the next motion may begin anywhere.
    void begin_anew() noexcept { has_end_ = false; }
    // The name of the field that cannot be, nullptr: none. `k`: the transformation that the record
    // names, already judged.
    const char* fault_of(const PathRecord& record, const Kinematics* k, const Core& core,
                         unsigned channel) noexcept;
    static bool sound(const Kinematics& k) noexcept;

    // mm, degrees, and what else is a number of a machine
    static constexpr double kFarthest = 1e9;
    static constexpr double kSame = 1e-6;  // mm, degrees: records meet

private:
    const char* motion(const PathRecord& r, const Kinematics* k, const Core& core,
                       unsigned channel) noexcept;
    void keep_end(const PathRecord& r) noexcept;

    bool has_end_ = false;
    std::uint8_t axis_count_ = 0;
    std::uint16_t transform_ = 0;
    std::array<std::uint8_t, kMaxPathAxes> axis_{};
    std::array<double, kMaxPathAxes> end_{};
};

}  // namespace polyturn::kernel
