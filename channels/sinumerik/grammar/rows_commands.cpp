// Functions and procedures that are no geometry (sinumerik_part3 7 and 9).
#include "channels/sinumerik/actions/overlays.hpp"
#include "channels/sinumerik/actions/polynomials.hpp"
#include "channels/sinumerik/actions/synchronized.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_procedures.hpp"
#include "channels/sinumerik/axes/feeds.hpp"
#include "channels/sinumerik/axes/positioning.hpp"
#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/coordination/program_start.hpp"
#include "channels/sinumerik/coordination/text_files.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/coupling/couplings.hpp"
#include "channels/sinumerik/coupling/electronic_gear.hpp"
#include "channels/sinumerik/coupling/tangential_axis.hpp"
#include "channels/sinumerik/curve_tables/curve_table_commands.hpp"
#include "channels/sinumerik/flow/interrupts.hpp"
#include "channels/sinumerik/geometry/g_settings.hpp"
#include "channels/sinumerik/geometry/geo_transform.hpp"
#include "channels/sinumerik/geometry/lifting.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/spindles/cutting_speeds.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/tools/drilling_cycles.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/tools/tool_environments.hpp"
#include "channels/sinumerik/tools/tool_functions.hpp"
#include "channels/sinumerik/tools/tools.hpp"
#include "channels/sinumerik/variables/functions.hpp"
#include "channels/sinumerik/variables/variable_facts.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr Command kCommandRows[] = {
    // name, function, least, most arguments, their types, handler, own block
    // arithmetic
    {"ABS", true, 1, 1, "r", f_abs},
    {"SIN", true, 1, 1, "r", f_sin},
    {"COS", true, 1, 1, "r", f_cos},
    {"TAN", true, 1, 1, "r", f_tan},
    {"ASIN", true, 1, 1, "r", f_asin},
    {"ACOS", true, 1, 1, "r", f_acos},
    {"ATAN2", true, 2, 2, "r", f_atan2},
    {"SQRT", true, 1, 1, "r", f_sqrt},
    {"POT", true, 1, 1, "r", f_pot},
    {"TRUNC", true, 1, 1, "r", f_trunc},
    {"ROUND", true, 1, 1, "r", f_round},
    {"ROUNDUP", true, 1, 1, "r", f_roundup},
    {"LN", true, 1, 1, "r", f_ln},
    {"EXP", true, 1, 1, "r", f_exp},
    {"MINVAL", true, 2, 2, "r", f_minval},
    {"MAXVAL", true, 2, 2, "r", f_maxval},
    {"BOUND", true, 3, 3, "r", f_bound},
    {"CALCDAT", true, 3, 3, "vrv", f_calcdat},
    {"CALCPOSI", true, 4, 6, "vvvvrr", f_calcposi},
    // texts
    {"ISNUMBER", true, 1, 1, "s", f_isnumber},
    {"NUMBER", true, 1, 1, "s", f_number},
    {"TOUPPER", true, 1, 1, "s", f_toupper},
    {"TOLOWER", true, 1, 1, "s", f_tolower},
    {"STRLEN", true, 1, 1, "s", f_strlen},
    {"INDEX", true, 2, 2, "sc", f_index},
    {"RINDEX", true, 2, 2, "sc", f_rindex},
    {"MINDEX", true, 2, 2, "s", f_mindex},
    {"MATCH", true, 2, 2, "s", f_match},
    {"SUBSTR", true, 2, 3, "srr", f_substr},
    {"SPRINT", true, 1, 10, "s*", f_sprint},
    // axes and names
    {"AXNAME", true, 1, 1, "s", f_axname},
    {"AXSTRING", true, 1, 1, "a", f_axstring},
    {"ISAXIS", true, 1, 1, "r", f_isaxis},
    {"SPI", true, 1, 1, "r", f_spi},
    {"AXTOSPI", true, 1, 1, "a", f_axtospi},
    {"MODAXVAL", true, 2, 2, "ar", f_modaxval},
    {"POSRANGE", true, 3, 4, "arrr", f_posrange},
    {"ISVAR", true, 1, 1, "s", f_isvar},
    {"GETVARTYP", true, 1, 1, "s", f_getvartyp},
    {"GETVARLIM", true, 3, 3, "scv", f_getvarlim},
    {"GETVARDFT", true, 2, 5, "svr", f_getvardft},
    {"GETVARPHU", true, 1, 1, "s", f_getvarphu},
    {"GETVARAP", true, 2, 2, "s", f_getvarap},
    {"STRINGIS", true, 1, 1, "s", f_stringis},
    {"ISFILE", true, 1, 1, "s", f_isfile},
    // tools
    {"GETT", true, 1, 2, "sr", f_gett},
    {"LENTOAX", true, 2, 3, "vvs", f_lentoax},
    {"NEWT", true, 1, 2, "sr", f_newt},
    {"GETDNO", true, 2, 2, "r", f_getdno},
    {"DELT", false, 1, 2, "sr", p_delt, true},
    {"SETDNO", true, 3, 3, "r", f_setdno},
    {"DZERO", false, 0, 0, "", p_dzero, true},
    {"CHKDNO", true, 0, 3, "r", f_chkdno},
    {"CHKDM", true, 1, 2, "r", f_chkdm},
    {"GETACTT", true, 2, 2, "vs", f_getactt},
    {"GETACTTD", true, 2, 2, "vr", f_getacttd},
    {"TOOLGNT", true, 1, 1, "s", f_toolgnt},
    {"TOOLGT", true, 2, 2, "sr", f_toolgt},
    {"DELDL", true, 1, 2, "r", f_deldl},
    {"TCA", false, 1, 3, "srr", p_tca, true},
    {"_TCA", false, 1, 3, "srr", p_tca, true},
    {"TML", false, 1, 1, "r", p_tml, true},
    {"TOOLENV", true, 1, 1, "s", f_toolenv},
    {"GETTENV", true, 2, 2, "sv", f_gettenv},
    {"DELTOOLENV", true, 0, 1, "s", f_deltoolenv},
    {"SETPIECE", false, 1, 2, "r", p_reset_monitoring, true},
    {"RESETMON", false, 2, 4, "vrrr", p_reset_monitoring, true},
    // curve tables
    {"CTABDEF", false, 4, 5, "aarrs", p_ctabdef, true},
    {"CTABEND", false, 0, 4, "*", p_ctabend, true},
    {"CTABDEL", false, 0, 3, "rrs", p_ctab_each, true},
    {"CTABLOCK", false, 0, 3, "rrs", p_ctab_each, true},
    {"CTABUNLOCK", false, 0, 3, "rrs", p_ctab_each, true},
    {"LEADON", false, 3, 3, "aar", p_trail, true},
    {"LEADOF", false, 1, 2, "a", p_trail, true},
    {"CTAB", true, 3, 5, "rrvaa", f_ctab},
    {"CTABINV", true, 4, 6, "rrrvaa", f_ctabinv},
    {"CTABSSV", true, 3, 5, "rrvaa", f_ctabssv},
    {"CTABSEV", true, 3, 5, "rrvaa", f_ctabsev},
    {"CTABTSV", true, 2, 3, "rva", f_ctabtsv},
    {"CTABTEV", true, 2, 3, "rva", f_ctabtev},
    {"CTABTSP", true, 2, 3, "rva", f_ctabtsp},
    {"CTABTEP", true, 2, 3, "rva", f_ctabtep},
    {"CTABTMIN", true, 1, 5, "rrraa", f_ctabtmin},
    {"CTABTMAX", true, 1, 5, "rrraa", f_ctabtmax},
    {"CTABEXISTS", true, 1, 1, "r", f_ctabexists},
    {"CTABISLOCK", true, 1, 1, "r", f_ctabislock},
    {"CTABMEMTYP", true, 1, 1, "r", f_ctabmemtyp},
    {"CTABPERIOD", true, 1, 1, "r", f_ctabperiod},
    {"CTABSEGID", true, 1, 2, "rs", f_ctabsegid},
    {"CTABPOLID", true, 1, 1, "r", f_ctabpolid},
    {"CTABID", true, 1, 2, "rs", f_ctabid},
    {"CTABNO", true, 0, 0, "", f_ctabno},
    {"CTABNOMEM", true, 0, 1, "s", f_ctabnomem},
    {"CTABFNO", true, 0, 1, "s", f_ctabfno},
    {"CTABSEG", true, 0, 2, "s", f_ctabseg},
    {"CTABFSEG", true, 0, 2, "s", f_ctabfseg},
    {"CTABMSEG", true, 0, 2, "s", f_ctabmseg},
    {"CTABPOL", true, 0, 1, "s", f_ctabpol},
    {"CTABFPOL", true, 0, 1, "s", f_ctabfpol},
    {"CTABMPOL", true, 0, 1, "s", f_ctabmpol},
    // text files
    {"WRITE", false, 3, 4, "vs*", p_write, true},
    {"READ", false, 5, 5, "vsrrv", p_read, true},
    {"DELETE", false, 2, 2, "vs", p_delete, true},
    {"FILESIZE", false, 3, 3, "vsv", p_file_size, true},
    {"FILEDATE", false, 3, 3, "vsv", p_file_facts, true},
    {"FILETIME", false, 3, 3, "vsv", p_file_facts, true},
    {"FILESTAT", false, 3, 3, "vsv", p_file_facts, true},
    {"FILEINFO", false, 3, 3, "vsv", p_file_facts, true},
    // operator and channel
    {"MSG", false, 0, 2, "*r", p_msg},
    {"WRTPR", false, 1, 2, "*r", p_wrtpr},
    {"SETAL", false, 1, 2, "rs", p_setal},
    {"STOPRE", false, 0, 0, "", p_stopre, true},
    {"DRFOF", false, 0, 0, "", p_overlay_off, true},
    {"CORROF", false, 2, 32, "as+", p_overlay_off, true},
    {"PRESETON", false, 2, 16, "ar+", p_preset, true},
    {"PRESETONS", false, 2, 16, "ar+", p_preset, true},
    {"GEOAX", false, 0, 6, "ra+", p_geometry_axes, true},
    {"BRISKA", false, 1, 8, "a", p_profile_without_effect},
    {"SOFTA", false, 1, 8, "a", p_soft_axes},
    {"DRIVEA", false, 1, 8, "a", p_profile_without_effect},
    {"JERKA", false, 1, 8, "a", p_soft_axes},
    {"IPOBRKA", false, 1, 2, "ar", p_without_effect, true},  // positioning axes end exactly
    {"NEWCONF", false, 0, 0, "", p_stopre, true},            // parameters act at barriers
    {"IPTRLOCK", false, 0, 0, "", p_without_effect},         // a block search begins at any block
    {"IPTRUNLOCK", false, 0, 0, "", p_as_machine},
    {"FPR", false, 0, 1, "a", p_feed_per_revolution},
    {"FPRAON", false, 1, 2, "a", p_axis_per_revolution},
    {"FPRAOF", false, 1, 8, "a", p_axis_per_revolution},
    {"RELEASE", false, 1, 8, "a", p_axis_exchange, true},
    {"GET", false, 1, 8, "a", p_axis_exchange, true},
    {"GETD", false, 1, 8, "a", p_axis_exchange, true},
    {"AXTOCHAN", false, 2, 16, "a*+", p_axis_to_channel, true},
    {"POLFMASK", false, 0, 8, "a", p_lift_axes},
    {"POLFMLIN", false, 0, 8, "a", p_lift_axes},
    {"ENABLE", false, 1, 1, "r", p_interrupts, true},
    {"DISABLE", false, 1, 1, "r", p_interrupts, true},
    {"CLRINT", false, 1, 1, "r", p_interrupts, true},
    {"CANCEL", false, 1, 16, "r", p_cancel},
    {"FCTDEF", false, 7, 7, "r", p_fctdef},
    {"LOCK", false, 1, 16, "r", p_lock},  // these in synchronized actions only
    {"UNLOCK", false, 1, 16, "r", p_unlock},
    {"RESET", false, 1, 16, "r", p_action_reset},
    {"STOPREOF", false, 0, 0, "", p_stop_reading_of},
    {"ICYCON", false, 0, 0, "", p_cycle_steps},
    {"ICYCOF", false, 0, 0, "", p_cycle_steps},
    {"SYNFCT", false, 3, 3, "rwr", p_synfct},
    {"RDISABLE", false, 0, 0, "", p_read_disable},
    {"DELDTG", false, 0, 1, "a", p_delete_travel},
    {"DELAYFSTON", false, 0, 0, "", p_without_effect},
    {"DELAYFSTOF", false, 0, 0, "", p_without_effect},
    {"CYCLE81", false, 4, 5, "r", p_cycle81, true},
    {"CYCLE82", false, 4, 6, "r", p_cycle82, true},
    {"CYCLE85", false, 4, 8, "r", p_cycle85, true},
    {"HOLES1", false, 6, 6, "r", p_holes, true},
    {"HOLES2", false, 6, 6, "r", p_holes, true},
    {"CYCLE800", false, 0, 18, "*", p_swivel, true},
    {"MMC", false, 1, 2, "sc", p_without_effect},
    {"TMON", false, 0, 1, "r", p_without_effect},
    {"GWPSON", false, 0, 1, "r", p_wheel_speed},
    {"GWPSOF", false, 0, 1, "r", p_wheel_speed},
    {"TMOF", false, 0, 1, "r", p_without_effect},
    {"ACTBLOCNO", false, 0, 0, "", p_as_machine},  // an alarm names its block always
    // axes are referenced before a cycle start
    {"WAITENC", false, 0, 0, "", p_as_machine},
    {"TRAILON", false, 2, 3, "aar", p_trail, true},
    {"TRAILOF", false, 1, 2, "aa", p_trail, true},
    {"EGDEF", false, 3, 11, "*", p_gear_define, true},
    {"EGON", false, 5, 17, "*", p_gear_on, true},
    {"EGONSYN", false, 7, 23, "*", p_gear_on, true},
    {"EGONSYNE", false, 8, 24, "*", p_gear_on, true},
    {"EGOFS", false, 1, 6, "a", p_gear_off, true},
    {"EGOFC", false, 1, 1, "a", p_gear_off, true},
    {"EGDEL", false, 1, 1, "a", p_gear_off, true},
    {"TANG", false, 3, 8, "*", p_tangential, true},
    {"TANGON", false, 1, 4, "ar", p_tangential, true},
    {"TANGOF", false, 1, 1, "a", p_tangential, true},
    {"TANGDEL", false, 1, 1, "a", p_tangential, true},
    {"TLIFT", false, 1, 1, "a", p_tangential, true},
    {"GETSELT", false, 1, 2, "vr", p_tool_of_spindle},
    {"GETEXET", false, 1, 2, "vr", p_tool_of_spindle},
    {"SBLOF", false, 0, 0, "", p_single_block},
    {"SBLON", false, 0, 0, "", p_single_block},
    {"SETMS", false, 0, 1, "r", p_setms, true},
    {"SETMTH", false, 0, 1, "r", p_master_holder, true},
    {"SPCON", false, 0, 8, "r", p_spindle_control},
    {"SPCOF", false, 0, 8, "r", p_spindle_speed},
    {"WAITM", false, 1, 17, "r*", p_wait_marker, true},
    {"WAITMC", false, 1, 17, "r*", p_wait_marker, true},
    {"WAITE", false, 1, 16, "*", p_wait_end, true},
    {"SETM", false, 1, 16, "r", p_set_marker, true},
    {"CLEARM", false, 0, 16, "r", p_set_marker, true},
    {"INIT", false, 2, 3, "*ss", p_init, true},
    {"START", false, 1, 16, "*", p_start, true},
    {"TRANSMIT", false, 0, 1, "r", p_transmit, true},
    {"TRACYL", false, 1, 2, "r", p_tracyl, true},
    {"TRAANG", false, 0, 2, "r", p_traang, true},
    {"TRACON", false, 0, 10, "r", nullptr, true},
    {"TRAORI", false, 0, 2, "r", p_trafoof, true},
    {"TRAFOOF", false, 0, 0, "", p_trafoof, true},
    {"FGROUP", false, 0, 8, "a", p_fgroup, true},
    {"DIAMCHAN", false, 0, 0, "", p_diamchan},
    {"COUPDEF", false, 2, 6, "aarrss", p_coupling, true},
    {"COUPDEL", false, 2, 2, "a", p_coupling, true},
    {"COUPRES", false, 2, 2, "a", p_coupling, true},
    {"COUPON", false, 2, 3, "aar", p_coupling, true},
    {"COUPONC", false, 2, 2, "a", p_coupling, true},
    {"COUPOF", false, 2, 4, "aarr", p_coupling, true},
    {"COUPOFS", false, 2, 3, "aar", p_coupling, true},
    {"WAITC", false, 1, 4, "asas", p_coupling, true},
    {"WAITP", false, 1, 8, "a", p_wait_axis, true},
    {"WAITS", false, 0, 8, "r", p_wait_spindle, true},
};

}  // namespace

std::span<const Command> program_commands() { return kCommandRows; }

}  // namespace polyturn::channels::sinumerik
