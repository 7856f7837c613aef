// Functions and procedures that are no geometry (sinumerik_part3 7 and 9).
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

using I = Interpreter;
constexpr Command kRows[] = {
    // name, function, least, most arguments, their types, handler, own block
    // arithmetic
    {"ABS", true, 1, 1, "r", &I::f_abs},
    {"SIN", true, 1, 1, "r", &I::f_sin},
    {"COS", true, 1, 1, "r", &I::f_cos},
    {"TAN", true, 1, 1, "r", &I::f_tan},
    {"ASIN", true, 1, 1, "r", &I::f_asin},
    {"ACOS", true, 1, 1, "r", &I::f_acos},
    {"ATAN2", true, 2, 2, "r", &I::f_atan2},
    {"SQRT", true, 1, 1, "r", &I::f_sqrt},
    {"POT", true, 1, 1, "r", &I::f_pot},
    {"TRUNC", true, 1, 1, "r", &I::f_trunc},
    {"ROUND", true, 1, 1, "r", &I::f_round},
    {"ROUNDUP", true, 1, 1, "r", &I::f_roundup},
    {"LN", true, 1, 1, "r", &I::f_ln},
    {"EXP", true, 1, 1, "r", &I::f_exp},
    {"MINVAL", true, 2, 2, "r", &I::f_minval},
    {"MAXVAL", true, 2, 2, "r", &I::f_maxval},
    {"BOUND", true, 3, 3, "r", &I::f_bound},
    {"CALCDAT", true, 3, 3, "vrv", &I::f_calcdat},
    // texts
    {"ISNUMBER", true, 1, 1, "s", &I::f_isnumber},
    {"NUMBER", true, 1, 1, "s", &I::f_number},
    {"TOUPPER", true, 1, 1, "s", &I::f_toupper},
    {"TOLOWER", true, 1, 1, "s", &I::f_tolower},
    {"STRLEN", true, 1, 1, "s", &I::f_strlen},
    {"INDEX", true, 2, 2, "sc", &I::f_index},
    {"RINDEX", true, 2, 2, "sc", &I::f_rindex},
    {"MINDEX", true, 2, 2, "s", &I::f_mindex},
    {"MATCH", true, 2, 2, "s", &I::f_match},
    {"SUBSTR", true, 2, 3, "srr", &I::f_substr},
    {"SPRINT", true, 1, 10, "s*", &I::f_sprint},
    // axes and names
    {"AXNAME", true, 1, 1, "s", &I::f_axname},
    {"AXSTRING", true, 1, 1, "a", &I::f_axstring},
    {"ISAXIS", true, 1, 1, "r", &I::f_isaxis},
    {"SPI", true, 1, 1, "r", &I::f_spi},
    {"AXTOSPI", true, 1, 1, "a", &I::f_axtospi},
    {"MODAXVAL", true, 2, 2, "ar", &I::f_modaxval},
    {"ISVAR", true, 1, 1, "s", &I::f_isvar},
    {"GETVARTYP", true, 1, 1, "s", &I::f_getvartyp},
    {"STRINGIS", true, 1, 1, "s", &I::f_stringis},
    {"ISFILE", true, 1, 1, "s", &I::f_isfile},
    // tools
    {"GETT", true, 1, 2, "sr", &I::f_gett},
    {"NEWT", true, 1, 2, "sr", &I::f_newt},
    {"GETDNO", true, 2, 2, "r", &I::f_getdno},
    {"DELT", false, 1, 2, "sr", &I::p_delt, true},
    // text files
    {"WRITE", false, 3, 4, "vs*", &I::p_write, true},
    {"READ", false, 5, 5, "vsrrv", &I::p_read, true},
    {"DELETE", false, 2, 2, "vs", &I::p_delete, true},
    {"FILESIZE", false, 3, 3, "vsv", &I::p_file_size, true},
    // operator and channel
    {"MSG", false, 0, 2, "*r", &I::p_msg},
    {"WRTPR", false, 1, 2, "*r", &I::p_wrtpr},
    {"SETAL", false, 1, 2, "rs", &I::p_setal},
    {"STOPRE", false, 0, 0, "", &I::p_stopre, true},
    {"DRFOF", false, 0, 0, "", &I::p_overlay_off, true},
    {"CORROF", false, 2, 32, "as+", &I::p_overlay_off, true},
    {"PRESETON", false, 2, 16, "ar+", &I::p_preset, true},
    {"PRESETONS", false, 2, 16, "ar+", &I::p_preset, true},
    {"GEOAX", false, 0, 6, "ra+", &I::p_geometry_axes, true},
    {"BRISKA", false, 1, 8, "a", &I::p_axis_profile},
    {"SOFTA", false, 1, 8, "a", &I::p_axis_profile},
    {"DRIVEA", false, 1, 8, "a", &I::p_axis_profile},
    {"JERKA", false, 1, 8, "a", &I::p_axis_profile},
    {"IPOBRKA", false, 1, 2, "ar", &I::p_nothing, true},   // positioning axes end exactly
    {"NEWCONF", false, 0, 0, "", &I::p_stopre, true},      // parameters act at barriers
    {"IPTRLOCK", false, 0, 0, "", &I::p_nothing},          // a block search begins at any block
    {"IPTRUNLOCK", false, 0, 0, "", &I::p_nothing},
    {"FPR", false, 0, 1, "a", &I::p_feed_per_revolution},
    {"FPRAON", false, 1, 2, "a", &I::p_axis_per_revolution},
    {"FPRAOF", false, 1, 8, "a", &I::p_axis_per_revolution},
    {"RELEASE", false, 1, 8, "a", &I::p_axis_exchange, true},
    {"GET", false, 1, 8, "a", &I::p_axis_exchange, true},
    {"GETD", false, 1, 8, "a", &I::p_axis_exchange, true},
    {"POLFMASK", false, 0, 8, "a", &I::p_lift_axes},
    {"POLFMLIN", false, 0, 8, "a", &I::p_lift_axes},
    {"ENABLE", false, 1, 1, "r", &I::p_interrupts, true},
    {"DISABLE", false, 1, 1, "r", &I::p_interrupts, true},
    {"CLRINT", false, 1, 1, "r", &I::p_interrupts, true},
    {"CANCEL", false, 1, 16, "r", &I::p_cancel},
    {"LOCK", false, 1, 16, "r", &I::p_lock},               // these in synchronized actions only
    {"UNLOCK", false, 1, 16, "r", &I::p_unlock},
    {"RESET", false, 1, 16, "r", &I::p_action_reset},
    {"STOPREOF", false, 0, 0, "", &I::p_stop_reading_of},
    {"RDISABLE", false, 0, 0, "", nullptr},
    {"DELDTG", false, 0, 1, "a", nullptr},
    {"DELAYFSTON", false, 0, 0, "", &I::p_without_effect},
    {"DELAYFSTOF", false, 0, 0, "", &I::p_without_effect},
    {"MMC", false, 1, 2, "sc", &I::p_without_effect},
    {"TMON", false, 0, 1, "r", &I::p_without_effect},
    {"GWPSON", false, 0, 1, "r", &I::p_wheel_speed},
    {"GWPSOF", false, 0, 1, "r", &I::p_wheel_speed},
    {"TMOF", false, 0, 1, "r", &I::p_without_effect},
    {"ACTBLOCNO", false, 0, 0, "", &I::p_nothing},
    {"WAITENC", false, 0, 0, "", &I::p_nothing},           // axes are referenced before a cycle start
    {"TRAILON", false, 2, 3, "aar", &I::p_trail, true},
    {"TRAILOF", false, 1, 2, "aa", &I::p_trail, true},
    {"GETSELT", false, 1, 2, "vr", &I::p_tool_of_spindle},
    {"GETEXET", false, 1, 2, "vr", &I::p_tool_of_spindle},
    {"SBLOF", false, 0, 0, "", &I::p_nothing},
    {"SBLON", false, 0, 0, "", &I::p_nothing},
    {"SETMS", false, 0, 1, "r", &I::p_setms, true},
    {"SPCON", false, 0, 8, "r", &I::p_spindle_control},
    {"SPCOF", false, 0, 8, "r", &I::p_spindle_control},
    {"WAITM", false, 1, 17, "r*", &I::p_wait_marker, true},
    {"WAITMC", false, 1, 17, "r*", &I::p_wait_marker, true},
    {"WAITE", false, 1, 16, "*", &I::p_wait_end, true},
    {"SETM", false, 1, 16, "r", &I::p_set_marker, true},
    {"CLEARM", false, 0, 16, "r", &I::p_set_marker, true},
    {"INIT", false, 2, 3, "*ss", &I::p_init, true},
    {"START", false, 1, 16, "*", &I::p_start, true},
    {"TRANSMIT", false, 0, 1, "r", &I::p_transmit, true},
    {"TRACYL", false, 1, 2, "r", &I::p_tracyl, true},
    {"TRAANG", false, 0, 2, "r", &I::p_traang, true},
    {"TRACON", false, 0, 10, "r", nullptr, true},
    {"TRAORI", false, 0, 2, "r", &I::p_trafoof, true},
    {"TRAFOOF", false, 0, 0, "", &I::p_trafoof, true},
    {"FGROUP", false, 0, 8, "a", &I::p_fgroup, true},
    {"DIAMCHAN", false, 0, 0, "", &I::p_diamchan},
    {"WAITP", false, 1, 8, "a", &I::p_wait_axis, true},
    {"WAITS", false, 0, 8, "r", &I::p_wait_spindle, true},
};

}  // namespace

std::span<const Command> program_commands() { return kRows; }

}  // namespace polyturn::channels::sinumerik
