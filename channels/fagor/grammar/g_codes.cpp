#include "channels/fagor/grammar/g_codes.hpp"

#include <array>

#include "channels/fagor/cycles/fixed_cycles.hpp"
#include "channels/fagor/cycles/profile_cycles.hpp"
#include "channels/fagor/frames/inclined.hpp"
#include "channels/fagor/frames/mirror_scale.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/frames/zeros.hpp"
#include "channels/fagor/frames/zones.hpp"
#include "channels/fagor/motion/arcs.hpp"
#include "channels/fagor/motion/compensation.hpp"
#include "channels/fagor/motion/corners.hpp"
#include "channels/fagor/motion/dwell.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/homing.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/motion/lines.hpp"
#include "channels/fagor/motion/probe.hpp"
#include "channels/fagor/motion/threads.hpp"
#include "channels/fagor/tools/spindle.hpp"

namespace polyturn::channels::fagor {
namespace {

using G = GGroup;
constexpr bool kAlone = true, kModal = true;

constexpr auto kGRows = std::to_array<GCode>({
    {0, G::Motion, g_linear, "xRQ", 0, !kAlone, kModal, "Rapid traverse"},
    {1, G::Motion, g_linear, "xRQ", 0, !kAlone, kModal, "Line at feed"},
    {2, G::Motion, g_arc, "xRQIJK", 0, !kAlone, kModal, "Arc, clockwise"},
    {3, G::Motion, g_arc, "xRQIJK", 0, !kAlone, kModal, "Arc, anticlockwise"},
    {4, G::OneShot, g_dwell, "", 'K', !kAlone, !kModal, "Dwell; stop of block preparation"},
    {5, G::Corner, g_corner, "", 0, !kAlone, kModal, "Round corners"},
    {6, G::Modifier, nullptr, "", 0, !kAlone, !kModal, "Arc centre from part zero"},
    {7, G::Corner, g_corner, "", 0, !kAlone, kModal, "Square corners"},
    {8, G::Modifier, g_arc, "xRQ", 0, !kAlone, !kModal, "Arc tangent to the path before"},
    {9, G::Modifier, g_arc, "xRQIJK", 0, !kAlone, !kModal, "Arc through three points"},
    {10, G::Mirror, g_mirror, "", 0, !kAlone, kModal, "Mirror off"},
    {11, G::Mirror, g_mirror, "", 0, !kAlone, kModal, "Mirror X"},
    {12, G::Mirror, g_mirror, "", 0, !kAlone, kModal, "Mirror Y"},
    {13, G::Mirror, g_mirror, "", 0, !kAlone, kModal, "Mirror Z"},
    {14, G::OneShot, g_mirror_axes, "x", 0, kAlone, kModal, "Mirror of the named axes"},
    {16, G::Plane, g_plane_of_axes, "x", 0, kAlone, kModal, "Plane of two axes"},
    {17, G::Plane, g_plane, "", 0, !kAlone, kModal, "Plane X Y"},
    {18, G::Plane, g_plane, "", 0, !kAlone, kModal, "Plane Z X"},
    {19, G::Plane, g_plane, "", 0, !kAlone, kModal, "Plane Y Z"},
    {20, G::OneShot, g_zone_limit, "xK", 0, kAlone, !kModal, "Lower limits of a work zone"},
    {21, G::OneShot, g_zone_limit, "xK", 0, kAlone, !kModal, "Upper limits of a work zone"},
    {22, G::OneShot, g_zone, "KS", 0, kAlone, !kModal, "Work zone on and off"},
    {32, G::Feed, g_feed_mode, "", 0, !kAlone, kModal, "Feed as inverse time"},
    {33, G::Motion, g_thread, "xLQ", 0, !kAlone, kModal, "Thread"},
    {34, G::Motion, g_thread, "xLQK", 0, !kAlone, kModal, "Thread of changing pitch"},
    {36, G::Element, nullptr, "", 'R', !kAlone, !kModal, "Rounded corner"},
    {37, G::Element, nullptr, "", 'R', !kAlone, !kModal, "Tangential entry"},
    {38, G::Element, nullptr, "", 'R', !kAlone, !kModal, "Tangential exit"},
    {39, G::Element, nullptr, "", 'R', !kAlone, !kModal, "Chamfer"},
    {40, G::Comp, g_comp, "", 0, !kAlone, kModal, "Radius compensation off"},
    {41, G::Comp, g_comp, "", 'N', !kAlone, kModal, "Radius compensation, left of the path"},
    {42, G::Comp, g_comp, "", 'N', !kAlone, kModal, "Radius compensation, right of the path"},
    {46, G::OneShot, g_inclined, "S", 0, kAlone, kModal, "Inclined axis"},
    {50, G::Corner, g_corner, "", 0, !kAlone, kModal, "Controlled round corners"},
    {51, G::Corner, g_look_ahead, "AEB", 0, kAlone, kModal, "Look-ahead"},
    {52, G::OneShot, g_hard_stop, "x", 0, !kAlone, !kModal, "Move to a hard stop"},
    {53, G::Machine, nullptr, "", 0, !kAlone, !kModal, "Coordinates from machine zero"},
    {54, G::OneShot, g_zero, "", 0, kAlone, kModal, "Zero offset 1"},
    {55, G::OneShot, g_zero, "", 0, kAlone, kModal, "Zero offset 2"},
    {56, G::OneShot, g_zero, "", 0, kAlone, kModal, "Zero offset 3"},
    {57, G::OneShot, g_zero, "", 0, kAlone, kModal, "Zero offset 4"},
    {58, G::OneShot, g_zero, "", 0, kAlone, kModal, "Additive zero offset 1"},
    {59, G::OneShot, g_zero, "", 0, kAlone, kModal, "Additive zero offset 2"},
    {66, G::Cycle, g_profile, "XZICALMHSEQ", 0, !kAlone, !kModal, "Pattern repeat"},
    {68, G::Cycle, g_profile, "XZCDLMKFHSEQ", 0, !kAlone, !kModal, "Stock removal along X"},
    {69, G::Cycle, g_profile, "XZCDLMKFHSEQ", 0, !kAlone, !kModal, "Stock removal along Z"},
    {70, G::Units, g_units, "", 0, !kAlone, kModal, "Inches"},
    {71, G::Units, g_units, "", 0, !kAlone, kModal, "Millimetres"},
    {72, G::OneShot, g_scale, "xS", 0, kAlone, kModal, "Scale"},
    {74, G::OneShot, g_home, "x", 0, kAlone, !kModal, "Home search"},
    {75, G::OneShot, g_probe, "xF", 0, !kAlone, !kModal, "Move until the probe touches"},
    {76, G::OneShot, g_probe, "xF", 0, !kAlone, !kModal, "Move while the probe touches"},
    {81, G::Cycle, g_section, "XZQRCDLMFH", 0, !kAlone, !kModal, "Turning of a straight section"},
    {82, G::Cycle, g_section, "XZQRCDLMFH", 0, !kAlone, !kModal, "Facing of a straight section"},
    {83, G::Cycle, g_drilling, "XZIBDKHCLR", 0, !kAlone, !kModal, "Axial drilling and tapping"},
    {84, G::Cycle, g_section, "XZQRCDLMFHIK", 0, !kAlone, !kModal, "Turning of an arc section"},
    {85, G::Cycle, g_section, "XZQRCDLMFHIK", 0, !kAlone, !kModal, "Facing of an arc section"},
    {86, G::Cycle, g_threading, "XZQRKIBEDLCJAWVMHU", 0, !kAlone, !kModal,
     "Longitudinal threading"},
    {87, G::Cycle, g_threading, "XZQRKIBEDLCJAWVMHU", 0, !kAlone, !kModal, "Face threading"},
    {88, G::Cycle, g_grooving, "XZQRCDK", 0, !kAlone, !kModal, "Grooving along X"},
    {89, G::Cycle, g_grooving, "XZQRCDK", 0, !kAlone, !kModal, "Grooving along Z"},
    {90, G::Distance, g_distance, "", 0, !kAlone, kModal, "Absolute dimensions"},
    {91, G::Distance, g_distance, "", 0, !kAlone, kModal, "Incremental dimensions"},
    {92, G::OneShot, g_preset, "xS", 0, kAlone, !kModal, "Coordinate preset; speed limit"},
    {93, G::OneShot, g_polar_origin, "IJ", 0, kAlone, !kModal, "Polar origin"},
    {94, G::Feed, g_feed_mode, "", 0, !kAlone, kModal, "Feed per minute"},
    {95, G::Feed, g_feed_mode, "", 0, !kAlone, kModal, "Feed per revolution"},
    {96, G::Spindle, g_spindle_mode, "", 0, !kAlone, kModal, "Constant surface speed"},
    {97, G::Spindle, g_spindle_mode, "", 0, !kAlone, kModal, "Spindle speed"},
    {151, G::XFormat, g_x_format, "", 0, !kAlone, kModal, "X in diameters"},
    {152, G::XFormat, g_x_format, "", 0, !kAlone, kModal, "X in radii"},
    {159, G::OneShot, g_zero_table, "", 'N', kAlone, kModal, "Zero offset by its number"},
    {233, G::OneShot, g_withdrawal, "x", 0, kAlone, kModal,
     "Withdrawal from an interrupted thread"},
});

constexpr bool ascending(const auto& rows) {
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i].number <= rows[i - 1].number) return false;
    return true;
}
static_assert(ascending(kGRows), "each code once, in order");

}  // namespace

std::span<const GCode> g_codes() { return kGRows; }

const GCode* find_g_code(unsigned number) {
    for (const GCode& row : kGRows)
        if (row.number == number) return &row;
    return nullptr;
}

}  // namespace polyturn::channels::fagor
