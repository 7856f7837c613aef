// The kernel's side of drive_segment.h: drives that live in a process of their own.
//
//   begin()      takes the newest statuses       } begin() and end() once a tick, around all
//   exchange()   a drive's command and status    } exchanges of it; none of them enters the system
//   end()        publishes the commands          }
//
// The clock does what must enter the system: it wakes the drive process, in virtual time it waits
// for its answer.
#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "ipc/memory/segment.hpp"
#include "kernel/drives/drive_segment.h"

namespace polyturn::kernel {

class SegmentDrives {
public:
    // Makes the command segment of the instance. Not in the cyclic thread.
    static Result<std::unique_ptr<SegmentDrives>> create(std::string instance, bool is_virtual);

    // open() takes the slot from the setup's number; spindles follow the axes.
    const PolyturnDriveApi& axis_api();
    const PolyturnDriveApi& spindle_api();

    // After all drives were opened: allows the drive process to attach, waits for its
    // segment and first answer.
    bool attach(std::int64_t tick_ns, std::chrono::milliseconds timeout);
    // A successor of a drive process that died: attaches to what `pid` made, for begin() to take.
    // From another thread.
    bool attach_successor(int pid);

    void begin() noexcept;
    void end() noexcept;
    bool answered() const noexcept;  // all that was commanded
    void wake() noexcept;
    void await_answer(std::int64_t timeout_us) noexcept;

private:
    struct Slot {
        SegmentDrives* drives = nullptr;
        std::uint32_t index = 0;
        std::int64_t step = 0;  // increments in the last cycle
    };
    SegmentDrives() = default;
    static void* open_slot(const PolyturnDriveSetup& setup, std::uint32_t first);
    void exchange(Slot& slot, const PolyturnDriveCommand& command,
                  PolyturnDriveStatus& status) noexcept;

    std::string instance_;
    RawSegment own_;
    // of the drive process and its successors: all stay mapped, for the tick may still read the one
    // before
    std::vector<RawSegment> theirs_;
    PolyturnDriveCommands* commands_ = nullptr;
    std::atomic<const PolyturnDriveStatuses*> statuses_{nullptr}, next_{nullptr};
    std::array<Slot, POLYTURN_DRIVE_SLOTS> slots_{};
    PolyturnCommandFrame draft_{};
    PolyturnStatusFrame newest_{};
};

// The machine builder's drive.so; nullptr with the reason when it cannot be used. It stays loaded.
const PolyturnDriveApi* load_drive_library(const std::string& file, std::string& reason);

// A drive that is not there: a fault that no reset takes away.
const PolyturnDriveApi& missing_drive_api();

}  // namespace polyturn::kernel
