#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {

bool stops_path(const PathRecord& r) noexcept {
    switch (row_of(r).when) {
        case When::Motion:
            return (r.flags & kThread) != 0;
        case When::Standing:
            return true;
        case When::Instant:
            return false;
        case When::ByContents:
            break;
    }
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Flag:
            return r.code == kFlagControl &&
                   (static_cast<std::uint32_t>(r.value) & kControlGroupEnds) != 0;
        case RecordKind::SpindleMode: {
            const auto mode = static_cast<SpindleModeCode>(r.code);
            if (mode == SpindleModeCode::Position && (r.flags & kPositioning)) return false;
            return mode == SpindleModeCode::Position || mode == SpindleModeCode::Couple ||
                   mode == SpindleModeCode::Uncouple;
        }
        default: {  // a positioning axis: it may be one too many, or have to wait for room
            const auto step = static_cast<PositioningStep>(r.code);
            return step == PositioningStep::Begin || step == PositioningStep::Room;
        }
    }
}

}  // namespace polyturn::kernel
