// Rows of the addresses that are no geometry: feeds, spindles, tools, auxiliary functions
// (sinumerik_part3 5). Of what becomes of a word the handler tells, as in rows_g.cpp:
// a_without_effect warns (a_rounding: unless 0 is asked for), a_as_machine asks for what this
// machine does anyway, a_elsewhere acts with the motion of its block; TCARR and CUTMOD take 0 only.
#include "channels/sinumerik/axes/feeds.hpp"
#include "channels/sinumerik/axes/fixed_stop.hpp"
#include "channels/sinumerik/axes/positioning.hpp"
#include "channels/sinumerik/geometry/g_settings.hpp"
#include "channels/sinumerik/geometry/lifting.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/spindles/cutting_speeds.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/tools/tools.hpp"

namespace polyturn::channels::sinumerik {
namespace {

using Index = Address::Index;
using Use = Address::Use;

constexpr Address kAddressRows[] = {
    // name, index, use, handler, signed, repeats, without value
    {"M", Index::Spindle, Use::Block, nullptr, false, true},
    {"H", Index::Number, Use::Block, nullptr, true, true},
    {"S", Index::Spindle, Use::Block, nullptr, false, true},
    {"T", Index::Spindle, Use::Block, nullptr, false},
    {"D", Index::None, Use::Block, nullptr, false},
    {"DL", Index::None, Use::Setting, a_sum_offset, false},
    {"L", Index::None, Use::Block, nullptr, false},
    {"P", Index::None, Use::Block, nullptr, false},
    {"F", Index::Number, Use::Block, nullptr, false, true},
    {"FB", Index::None, Use::Setting, a_feed, false},
    {"FZ", Index::None, Use::Setting, a_feed_tooth, false},
    {"OVR", Index::None, Use::Setting, a_override, false},
    {"OVRRAP", Index::None, Use::Setting, a_override, false},
    {"FGREF", Index::Axis, Use::Setting, a_feed_radius, false, true},
    {"FL", Index::Axis, Use::Setting, a_feed_limit, false, true},
    {"FA", Index::Spindle, Use::Setting, a_axis_feed, false, true},
    {"AX", Index::Axis, Use::Block, nullptr, true, true},  // an axis word by a variable
    {"IP", Index::Axis, Use::Block, nullptr, true, true},  // I J K by a variable
    // driven asynchronously: start_positioning()
    {"POS", Index::Axis, Use::Setting, a_elsewhere, true, true},
    {"POSA", Index::Axis, Use::Setting, a_elsewhere, true, true},
    {"POSP", Index::Axis, Use::Setting, a_elsewhere, true, true},
    {"FD", Index::None, Use::Setting, a_handwheel_feed, false},
    {"FDA", Index::Axis, Use::Setting, a_handwheel_feed, false, true},
    {"FXST", Index::Axis, Use::Setting, a_stop_torque, false, true},
    {"FXSW", Index::Axis, Use::Setting, a_stop_window, false, true},
    {"FXS", Index::Axis, Use::Setting, a_fixed_stop, false, true},
    {"OVRA", Index::Spindle, Use::Setting, a_axis_share, false, true},
    {"ACC", Index::Spindle, Use::Setting, a_axis_share, false, true},
    {"VELOLIM", Index::Spindle, Use::Setting, a_axis_share, false, true},
    {"JERKLIM", Index::Axis, Use::Setting, a_axis_share, false, true},
    // of axes that follow: they keep the machine's limits
    {"VELOLIMA", Index::Spindle, Use::Setting, a_without_effect, false, true},
    {"ACCLIMA", Index::Spindle, Use::Setting, a_without_effect, false, true},
    {"JERKLIMA", Index::Spindle, Use::Setting, a_without_effect, false, true},
    // PT_PATH_TOL holds
    {"CTOL", Index::None, Use::Setting, a_without_effect, true},
    {"OTOL", Index::None, Use::Setting, a_without_effect, true},
    {"STOLF", Index::None, Use::Setting, a_without_effect, true},
    // no transformation here has several joints
    {"STAT", Index::None, Use::Setting, a_without_effect, false},
    {"TU", Index::None, Use::Setting, a_without_effect, false},
    {"SCPARA", Index::Axis, Use::Setting, a_without_effect, false, true},
    {"TCARR", Index::None, Use::Setting, a_no_holder},
    {"CUTMOD", Index::None, Use::Setting, a_no_holder},
    {"ATOL", Index::Axis, Use::Setting, a_without_effect, true, true},
    // no input changes the feed of a block here
    {"ST", Index::None, Use::Setting, a_without_effect, false},
    {"SR", Index::None, Use::Setting, a_without_effect, false},
    // FMA[2, axis]
    {"FMA", Index::Axis, Use::Setting, a_without_effect, false, true},
    {"STA", Index::Axis, Use::Setting, a_without_effect, false, true},
    {"SRA", Index::Axis, Use::Setting, a_without_effect, false, true},
    // positioning axes end exactly
    {"FINEA", Index::Spindle, Use::Setting, a_as_machine, true, true, true},
    {"COARSEA", Index::Spindle, Use::Setting, a_without_effect, true, true, true},
    {"IPOENDA", Index::Spindle, Use::Setting, a_without_effect, true, true, true},
    {"POLF", Index::Axis, Use::Setting, a_lift_position, true, true},
    {"DIAMONA", Index::Axis, Use::Setting, a_axis_diameter, true, true, true},
    {"DIAM90A", Index::Axis, Use::Setting, a_axis_diameter, true, true, true},
    {"DIAMOFA", Index::Axis, Use::Setting, a_axis_diameter, true, true, true},
    {"DIACYCOFA", Index::Axis, Use::Setting, a_axis_diameter, true, true, true},
    {"DIAMCHANA", Index::Axis, Use::Setting, a_axis_diameter, true, true, true},
    // corners are rounded within PT_PATH_TOL
    {"ADIS", Index::None, Use::Setting, a_rounding, false},
    {"ADISPOS", Index::None, Use::Setting, a_rounding, false},
    {"LIMS", Index::Spindle, Use::Setting, a_limit, false, true},
    {"SVC", Index::Spindle, Use::Setting, a_cutting_speed, false, true},
    {"SCC", Index::Axis, Use::Setting, a_surface_axis, true, false, true},
    {"SPOS", Index::Spindle, Use::Setting, a_spindle_position, true, true},
    {"SPOSA", Index::Spindle, Use::Setting, a_spindle_position, true, true},
    {"TOFFL", Index::Number, Use::Setting, a_tool_length_offset, true, true},
    {"TOFF", Index::Axis, Use::Setting, a_tool_axis_offset, true, true},
    {"TOFFR", Index::None, Use::Setting, a_tool_radius_offset},
};

}  // namespace

std::span<const Address> program_addresses() { return kAddressRows; }

}  // namespace polyturn::channels::sinumerik
