// Rows of the geometry: moves, frames, compensation, corner elements. A null handler: known, not
// built. geo_not_built: the mode can be chosen and read, its first move is refused; CUT3D is
// refused where compensation begins or ends.
#include "channels/sinumerik/frames/frame_functions.hpp"
#include "channels/sinumerik/frames/geo_frames.hpp"
#include "channels/sinumerik/frames/geo_measured_frame.hpp"
#include "channels/sinumerik/geometry/geo_approach.hpp"
#include "channels/sinumerik/geometry/geo_arcs.hpp"
#include "channels/sinumerik/geometry/geo_compensation.hpp"
#include "channels/sinumerik/geometry/geo_curves.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/geo_positions.hpp"
#include "channels/sinumerik/geometry/geo_threads.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr GCode kCodes[] = {
    // name, group, number, modal, delivery state, handler, addresses it reads
    // group 1: Modal motion commands
    {"G0", 1, 1, true, false, geo_motion, "axes AP RP RND CHF CHR FRC ANG"},
    {"G1", 1, 2, true, true, geo_motion, "axes AP RP RND CHF CHR FRC ANG MEAS MEASA MEAW MEAWA"},
    {"G2", 1, 3, true, false, geo_arc, "axes I J K CR AR TURN AP RP RND CHF CHR FRC"},
    {"G3", 1, 4, true, false, geo_arc, "axes I J K CR AR TURN AP RP RND CHF CHR FRC"},
    {"CIP", 1, 5, true, false, geo_cip, "axes I1 J1 K1 TURN RND CHF CHR FRC"},
    {"ASPLINE", 1, 6, true, false, geo_not_built, "axes"},
    {"BSPLINE", 1, 7, true, false, geo_not_built, "axes"},
    {"CSPLINE", 1, 8, true, false, geo_not_built, "axes"},
    {"POLY", 1, 9, true, false, geo_not_built, "axes"},
    {"G33", 1, 10, true, false, geo_thread, "axes I J K AP RP"},
    {"G331", 1, 11, true, false, geo_tap, "axes I J K"},
    {"G332", 1, 12, true, false, geo_tap, "axes I J K"},
    {"OEMIPO1", 1, 13, true, false, geo_not_built, "axes"},
    {"OEMIPO2", 1, 14, true, false, geo_not_built, "axes"},
    {"CT", 1, 15, true, false, geo_ct, "axes AP RP TURN RND CHF CHR FRC"},
    {"G34", 1, 16, true, false, geo_thread, "axes I J K F AP RP"},
    {"G35", 1, 17, true, false, geo_thread, "axes I J K F AP RP"},
    {"INVCW", 1, 18, true, false, geo_involute, "axes I J K CR AR"},
    {"INVCCW", 1, 19, true, false, geo_involute, "axes I J K CR AR"},
    {"G335", 1, 20, true, false, geo_barrel, "axes I J K IR JR KR CR AR I1 J1 K1"},
    {"G336", 1, 21, true, false, geo_barrel, "axes I J K IR JR KR CR AR I1 J1 K1"},
    // group 2: Block-wise motions and dwell
    {"G4", 2, 1, false, false, geo_dwell, "F S"},
    {"G63", 2, 2, false, false, geo_tap_chuck, "axes"},
    {"G74", 2, 3, false, false, geo_reference, "axes"},
    {"G75", 2, 4, false, false, geo_fixed_point, "axes FP"},
    {"REPOSL", 2, 5, false, false, nullptr},
    {"REPOSQ", 2, 6, false, false, nullptr},
    {"REPOSH", 2, 7, false, false, nullptr},
    {"REPOSA", 2, 8, false, false, nullptr},
    {"REPOSQA", 2, 9, false, false, nullptr},
    {"REPOSHA", 2, 10, false, false, nullptr},
    {"G147", 2, 11, false, false, geo_approach, "axes DISR DISCL DISRP FAD"},
    {"G247", 2, 12, false, false, geo_approach, "axes DISR DISCL DISRP FAD"},
    {"G347", 2, 13, false, false, geo_approach, "axes DISR DISCL DISRP FAD"},
    {"G148", 2, 14, false, false, geo_retract, "axes DISR DISCL DISRP FAD"},
    {"G248", 2, 15, false, false, geo_retract, "axes DISR DISCL DISRP FAD"},
    {"G348", 2, 16, false, false, geo_retract, "axes DISR DISCL DISRP FAD"},
    {"G5", 2, 17, false, false, nullptr},
    {"G7", 2, 18, false, false, nullptr},
    // group 3: Programmable frames, working-area limits and pole programming
    {"TRANS", 3, 1, false, false, geo_frame, "axes"},
    {"ROT", 3, 2, false, false, geo_frame, "axes RPL"},
    {"SCALE", 3, 3, false, false, geo_frame, "axes"},
    {"MIRROR", 3, 4, false, false, geo_frame, "axes"},
    {"ATRANS", 3, 5, false, false, geo_frame, "axes"},
    {"AROT", 3, 6, false, false, geo_frame, "axes RPL"},
    {"ASCALE", 3, 7, false, false, geo_frame, "axes"},
    {"AMIRROR", 3, 8, false, false, geo_frame, "axes"},
    {"G25", 3, 10, false, false, geo_limits, "axes S"},
    {"G26", 3, 11, false, false, geo_limits, "axes S"},
    {"G110", 3, 12, false, false, geo_pole, "axes AP RP"},
    {"G111", 3, 13, false, false, geo_pole, "axes AP RP"},
    {"G112", 3, 14, false, false, geo_pole, "axes AP RP"},
    {"G58", 3, 15, false, false, geo_partial_shift, "axes"},
    {"G59", 3, 16, false, false, geo_partial_shift, "axes"},
    {"ROTS", 3, 17, false, false, geo_frame, "axes"},
    {"AROTS", 3, 18, false, false, geo_frame, "axes"},
    // group 7: Tool radius compensation
    {"G40", 7, 1, true, true, geo_compensation},
    {"G41", 7, 2, true, false, geo_compensation},
    {"G42", 7, 3, true, false, geo_compensation},
    // group 9: Frame suppression
    {"G53", 9, 1, false, false, g_mode},
    {"SUPA", 9, 2, false, false, g_mode},
    {"G153", 9, 3, false, false, g_mode},
    // group 16: Feed correction at inner and outer curvature
    {"CFC", 16, 1, true, true, geo_comp_option},
    {"CFTCP", 16, 2, true, false, geo_comp_option},
    {"CFIN", 16, 3, true, false, geo_comp_option},
    // group 17: Approach/retract response with tool radius compensation
    {"NORM", 17, 1, true, true, geo_comp_option},
    {"KONT", 17, 2, true, false, geo_comp_option},
    {"KONTT", 17, 3, true, false, geo_comp_option},
    {"KONTC", 17, 4, true, false, geo_comp_option},
    // group 18: Corner behaviour of tool offset
    {"G450", 18, 1, true, true, geo_comp_option},
    {"G451", 18, 2, true, false, geo_comp_option},
    // group 22: Tool offset type
    {"CUT2D", 22, 1, true, true, geo_comp_kind},
    {"CUT2DF", 22, 2, true, false, geo_comp_kind},
    {"CUT3DC", 22, 3, true, false, geo_not_built},
    {"CUT3DF", 22, 4, true, false, geo_not_built},
    {"CUT3DFS", 22, 5, true, false, geo_not_built},
    {"CUT3DFF", 22, 6, true, false, geo_not_built},
    {"CUT3DCC", 22, 7, true, false, geo_not_built},
    {"CUT3DCCD", 22, 8, true, false, geo_not_built},
    {"CUT2DD", 22, 9, true, false, geo_comp_kind},
    {"CUT2DFD", 22, 10, true, false, geo_comp_kind},
    {"CUT3DCD", 22, 11, true, false, geo_not_built},
    // group 23: Collision monitoring on inner contours
    {"CDOF", 23, 1, true, true, geo_comp_option},
    {"CDON", 23, 2, true, false, geo_comp_option},
    {"CDOF2", 23, 3, true, false, geo_comp_option},
    // group 40: Constant tool radius compensation
    {"CUTCONOF", 40, 1, true, true, geo_comp_option},
    {"CUTCONON", 40, 2, true, false, geo_comp_option},
    // group 43: Soft approach/retract (SAR/WAB) direction
    {"G140", 43, 1, true, true, g_mode},
    {"G141", 43, 2, true, false, g_mode},
    {"G142", 43, 3, true, false, g_mode},
    {"G143", 43, 4, true, false, g_mode},
    // group 44: Soft approach/retract (SAR/WAB) path segmentation
    {"G340", 44, 1, true, true, g_mode},
    {"G341", 44, 2, true, false, g_mode},
    // group 48: Approach/retract response with tool radius compensation
    {"G460", 48, 1, true, true, geo_comp_option},
    {"G461", 48, 2, true, false, geo_comp_option},
    {"G462", 48, 3, true, false, geo_comp_option},
    // group 60: Working-area limitation (WCS)
    {"WALCS0", 60, 1, true, true, g_mode},
    {"WALCS1", 60, 2, true, false, g_mode},
    {"WALCS2", 60, 3, true, false, g_mode},
    {"WALCS3", 60, 4, true, false, g_mode},
    {"WALCS4", 60, 5, true, false, g_mode},
    {"WALCS5", 60, 6, true, false, g_mode},
    {"WALCS6", 60, 7, true, false, g_mode},
    {"WALCS7", 60, 8, true, false, g_mode},
    {"WALCS8", 60, 9, true, false, g_mode},
    {"WALCS9", 60, 10, true, false, g_mode},
    {"WALCS10", 60, 11, true, false, g_mode},
};

using Index = Address::Index;
using Use = Address::Use;
constexpr Address kAddresses[] = {
    // name, index, use, handler
    {"I", Index::None, Use::Block},
    {"J", Index::None, Use::Block},
    {"K", Index::None, Use::Block},
    {"I1", Index::None, Use::Block},
    {"J1", Index::None, Use::Block},
    {"K1", Index::None, Use::Block},
    {"CR", Index::None, Use::Block},
    {"AR", Index::None, Use::Block},
    {"TURN", Index::None, Use::Block},
    {"AP", Index::None, Use::Block},
    {"RP", Index::None, Use::Block},
    {"RPL", Index::None, Use::Block},
    {"ANG", Index::None, Use::Block},
    {"ANG1", Index::None, Use::Block},
    {"ANG2", Index::None, Use::Block},
    {"RND", Index::None, Use::Block},
    {"RNDM", Index::None, Use::Setting, a_geometry},
    {"CHF", Index::None, Use::Block},
    {"CHR", Index::None, Use::Block},
    {"FRC", Index::None, Use::Block},
    {"FRCM", Index::None, Use::Setting, a_geometry},
    {"SF", Index::None, Use::Setting, a_geometry},
    {"DITS", Index::None, Use::Setting, a_thread_ramp},
    {"DITE", Index::None, Use::Setting, a_thread_ramp},
    {"IR", Index::None, Use::Block},
    {"JR", Index::None, Use::Block},
    {"KR", Index::None, Use::Block},
    {"DISR", Index::None, Use::Block},
    {"DISCL", Index::None, Use::Block},
    {"DISRP", Index::None, Use::Block},
    {"FAD", Index::None, Use::Block},
    {"DISC", Index::None, Use::Setting, a_geometry},
    {"OFFN", Index::None, Use::Setting, a_geometry},
    {"FP", Index::None, Use::Block},
    {"MEAS", Index::None, Use::Block},
    {"MEAW", Index::None, Use::Block},
    {"MEASA", Index::Axis, Use::Block, nullptr, true, true},
    {"MEAWA", Index::Axis, Use::Block, nullptr, true, true},
    {"DILF", Index::None, Use::Setting, a_geometry},
    {"ALF", Index::None, Use::Setting, a_geometry, false},
};

constexpr Command kCommands[] = {
    // name, function, least, most arguments, their types, handler
    {"CTRANS", true, 0, 16, "ar+", f_ctrans},  {"CFINE", true, 0, 16, "ar+", f_cfine},
    {"CSCALE", true, 0, 16, "ar+", f_cscale},  {"CROT", true, 0, 6, "ar+", f_crot},
    {"CROTS", true, 0, 4, "ar+", f_crots},     {"CMIRROR", true, 0, 8, "a", f_cmirror},
    {"CRPL", true, 2, 2, "r", f_crpl},         {"ADDFRAME", true, 2, 2, "fs", f_addframe},
    {"INVFRAME", true, 1, 1, "f", f_invframe}, {"MEAFRAME", true, 3, 3, "v", f_meaframe},
};

}  // namespace

std::span<const GCode> geometry_g_codes() { return kCodes; }
std::span<const Address> geometry_addresses() { return kAddresses; }
std::span<const Command> geometry_commands() { return kCommands; }

}  // namespace polyturn::channels::sinumerik
