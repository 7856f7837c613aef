#include "channels/records/picture_out.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace polyturn::channels {
namespace {

// A frame that only moves the zero is a part of the shift.
bool only_moves(const Frame& frame) {
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            if (frame.linear[row][column] != (row == column ? 1.0 : 0.0)) return false;
    return std::all_of(frame.scale.begin(), frame.scale.end(),
                       [](double one) { return one == 1.0; });
}

template <std::size_t kSize>
void put(std::array<char, kSize>& to, std::string_view text) {
    to.fill(0);
    text = text.substr(0, std::min(text.size(), kSize - 1));
    std::memcpy(to.data(), text.data(), text.size());
}

}  // namespace

void describe(const Core& core, BlockPicture& picture) {
    const PathState& path = core.path;
    picture.serial = core.at.serial;
    picture.tool = path.tool.ref.number;
    picture.offset = path.tool.ref.offset;
    picture.edge = path.tool.ref.edge;
    picture.geometry = path.tool.geometry;
    picture.wear = path.tool.wear;
    picture.zero_row = path.zero_row;
    picture.flags = core.at.comp == CompSide::Left    ? kPictureCompLeft
                    : core.at.comp == CompSide::Right ? kPictureCompRight
                                                      : 0u;
    if (path.transformation.active() || (path.framed && !only_moves(path.frame)))
        picture.flags |= kPictureNoShift;
    if (!core.shows.nose) picture.flags |= kPictureNoNose;
    picture.feed_mode = static_cast<std::uint32_t>(path.feed_mode);
    picture.feed = path.feed;
    picture.spindle = path.spindle.spindle;
    picture.spindle_mode = static_cast<std::uint32_t>(path.spindle.mode);
    picture.speed = path.spindle.mode == SpindleModeCode::SurfaceSpeed ? path.spindle.surface_m_min
                    : path.spindle.mode == SpindleModeCode::Position   ? path.spindle.angle_deg
                                                                       : path.spindle.rpm;
    picture.speed_limit = path.spindle.limit_rpm;
    picture.tip = path.tool.tip;
    picture.nose_radius = path.tool.nose_radius;
    for (std::size_t i = 0; i < kChannelAxes; ++i) {
        picture.shift[i] = path.machine[i] - path.programmed[i];
        picture.tool_shift[i] = path.shift[i] + path.vector[i];
        picture.tool_shown[i] = core.shows.tool_vector ? path.vector[i] : 0.0;
    }
    put(picture.tool_name, path.tool.ref.name);
}

void PictureOut::begin() {
    // P4: own head. P1: no picture before it holds any more
    own_->picture_first.store(own_->pictures.head.load(std::memory_order_relaxed),
                              std::memory_order_release);
    any_ = false;
}

void PictureOut::look(const Core& core, const std::string& codes) {
    BlockPicture now{};
    describe(core, now);
    put(now.codes, codes);
    // Sums of positions differ in their last bits from block to block.
    for (std::size_t i = 0; any_ && i < kChannelAxes; ++i)
        if (std::abs(now.shift[i] - last_.shift[i]) < 1e-7) now.shift[i] = last_.shift[i];
    const std::uint64_t serial = std::exchange(now.serial, last_.serial);
    if (any_ && serial >= last_.serial && std::memcmp(&now, &last_, sizeof now) == 0) return;
    now.serial = serial;
    last_ = now;
    any_ = true;
    push_picture(*own_, now);
}

void PictureOut::offset_lost(std::uint64_t serial) {
    BlockPicture now{};
    if (!find_picture(*own_, serial, now)) return;
    now.serial = serial;
    tell(now, true);
}

void PictureOut::reset(std::uint64_t newest, std::uint64_t not_begun, bool offset_lost) {
    const bool ahead = not_begun != 0 && not_begun <= newest;
    if (!ahead && !offset_lost) return;
    BlockPicture now{};
    if (find_picture(*own_, ahead ? not_begun - 1 : newest, now)) return tell(now, offset_lost);
    // nothing of the program has acted, and the state before it is not known any more
    if (ahead) begin();
}

// As the newest of those that may be meant; the initial state of the next program is output anew.
void PictureOut::tell(BlockPicture now, bool offset_lost) {
    if (offset_lost) {
        for (std::size_t i = 0; i < kChannelAxes; ++i) now.shift[i] -= now.tool_shift[i];
        now.tool_shift.fill(0.0);
        now.tool_shown.fill(0.0);
        now.offset = now.geometry = now.wear = 0;
        now.tip = 0;
        now.nose_radius = 0.0;
        now.flags &= ~(kPictureCompLeft | kPictureCompRight);
    }
    any_ = false;
    push_picture(*own_, now);
}

}  // namespace polyturn::channels
