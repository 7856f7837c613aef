// Source of the drive of an axis or spindle (PT_DRIVE, PT_SPINDLE_DRIVE): simulated in the kernel,
// the machine's drive.so, or a process behind the drive segment (kernel/drives/drive_segment.h).
#pragma once
#include <cstdint>

namespace polyturn::kernel {

enum class DriveSource : std::uint8_t { Simulated, Library, Process };

}  // namespace polyturn::kernel
