#include "channels/fagor/motion/corners.hpp"

#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {
namespace {

// G51 A: percent of the axes' own acceleration, until another corner function (7.4). A may be up to
// 255; the path gets no more than the machine's own value all the same: what lies beyond N0400 its
// drives do not follow. E: how far the path may leave a corner; B: a corner whose angle between its
// blocks is smaller is a square one.
void look_ahead(Execution& x, double percent, double error_mm, double square_deg) {
    if (percent != x.modal.acceleration)
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            x.core.signal("ACC" + std::to_string(i), std::fmin(1.0, percent / 100.0));
    if (error_mm != x.modal.look_ahead_error) x.core.signal("PATHTOL", error_mm);
    if (square_deg != x.modal.square_angle)
        x.core.signal("SQUARE", square_deg < 0 ? -1.0 : 180.0 - square_deg);
    x.modal.acceleration = percent;
    x.modal.look_ahead_error = error_mm;
    x.modal.square_angle = square_deg;
}

}  // namespace

bool g_corner(Execution& x, const GCode& row) {
    x.modal.corner = row.number;
    x.core.path.exact_stop_mode = row.number == 7;
    look_ahead(x, 100.0, -1.0, -1.0);
    return true;
}

bool g_look_ahead(Execution& x, const GCode& row) {
    if (x.words.m_count || x.words.has_axes_beside("AB") || (x.words.letters & letter_set("FSTD")))
        return x.fail(Alarm::FagorAlone, 'G', "G51");
    if (!x.words.has('E')) return x.fail(Alarm::FagorMotionWord, 'G', "E", 51);
    if (x.words.number('A') < 0 || x.words.number('A') > 255)
        return x.fail(Alarm::FagorValueRange, 'A', "A", x.words.number('A'));
    if (x.words.number('E') < 0)
        return x.fail(Alarm::FagorValueRange, 'E', "E", x.words.number('E'));
    if (x.words.number('B') < 0 || x.words.number('B') > 180)
        return x.fail(Alarm::FagorValueRange, 'B', "B", x.words.number('B'));
    // The advanced algorithm (bit 15) excludes the doubled interpolation period (7.4).
    if ((x.settings.look_ahead_kind & 0x8000) != 0 && x.settings.interpolation_period == 1)
        return x.fail(Alarm::FagorIncompatible, 'G', "FG.LOOKATYP FG.IPOTIME");
    if (x.modal.feed_code == 95 || x.modal.motion >= 33)
        return x.fail(Alarm::FagorIncompatible, 'G',
                      x.modal.feed_code == 95 ? "G51 G95" : "G51 and a thread");
    x.modal.corner = row.number;
    look_ahead(x, x.words.number('A') > 0 ? x.words.number('A') : 100.0, distance(x, 'E'),
               x.words.has('B') ? x.words.number('B') : -1.0);
    x.core.path.exact_stop_mode = false;
    return true;
}

bool element_at_end(Execution& x, bool straight_block) {
    const GCode* row = x.words.code(GGroup::Element);
    if (!row) return true;
    const std::string name = "G" + std::to_string(row->number);
    if (!x.words.element || x.words.element->value <= 0)
        return x.fail(Alarm::FagorElementRadius, 'G', name);
    if (row->number == 37 && !straight_block) return x.fail(Alarm::FagorTangential, 'G', name);
    if (row->number == 39 && !straight_block) return x.fail(Alarm::FagorTangential, 'G', name);
    static constexpr corners::Shape kShapes[] = {corners::Shape::Rounding, corners::Shape::Entry,
                                                 corners::Shape::Exit, corners::Shape::ChamferLeg};
    corners::Call call;
    call.shape = kShapes[row->number - 36];
    // what is only read stays as it is programmed
    call.size = x.words.element->value * x.modal.unit() *
                (x.ahead.reads_profile || x.ahead.scans_loops ? 1.0 : x.modal.scale);
    call.required = row->number == 37 || row->number == 38;
    call.straight = row->number == 39;
    call.letter = 'R';
    call.idle_blocks = 48;
    return x.core.corner(call);
}

}  // namespace polyturn::channels::fagor
