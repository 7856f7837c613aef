// Rows of the G commands that set modes: sinumerik_part3 6.3. The handler says what becomes of a
// command, and the reference page and the test of all words go by it:
//   nullptr           known, refused by its name
//   g_mode            kept; read where it acts (limits of the working area, ways of retraction,
//                     soft approach)
//   g_as_machine      asks for what this machine does anyway
//   g_as_continuous   cuts as G64; the rounding that it asks for beyond that is not made, and the
//                     program is warned
//   g_without_effect  kept and readable; changes neither path nor feed nor limits, and the program
//   is warned
//   any other         acts
// As the machine does anyway: what the control is delivered with, but for BRISK (the jerk of every
// axis is limited here always); SOFT for that reason; FIFOCTRL (blocks are prepared ahead by
// themselves); G601 (an exact stop waits until all axes are in position); G290.
#include "channels/sinumerik/axes/feeds.hpp"
#include "channels/sinumerik/frames/geo_frames.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/g_settings.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr GCode kGRows[] = {
    // name, group, number, modal, delivery state, handler, addresses it reads
    // group 4: FIFO (preprocessing buffer)
    {"STARTFIFO", 4, 1, true, true, g_as_machine},
    {"STOPFIFO", 4, 2, true, false, g_without_effect},
    {"FIFOCTRL", 4, 3, true, false, g_as_machine},
    // group 6: Plane selection
    {"G17", 6, 1, true, true, g_plane},
    {"G18", 6, 2, true, false, g_plane},
    {"G19", 6, 3, true, false, g_plane},
    // group 8: Settable zero offset
    {"G500", 8, 1, true, true, g_zero},
    {"G54", 8, 2, true, false, g_zero},
    {"G55", 8, 3, true, false, g_zero},
    {"G56", 8, 4, true, false, g_zero},
    {"G57", 8, 5, true, false, g_zero},
    {"G505", 8, 6, true, false, g_zero},
    // group 10: Exact stop - continuous-path mode
    {"G60", 10, 1, true, true, g_exact_stop},
    {"G64", 10, 2, true, false, g_exact_stop},
    {"G641", 10, 3, true, false, g_as_continuous},
    {"G642", 10, 4, true, false, g_as_continuous},
    {"G643", 10, 5, true, false, g_as_continuous},
    {"G644", 10, 6, true, false, g_as_continuous},
    {"G645", 10, 7, true, false, g_as_continuous},
    // group 11: Exact stop, block-wise
    {"G9", 11, 1, false, false, g_exact_once},
    // group 12: Block change criterion at exact stop (G60/G9)
    {"G601", 12, 1, true, true, g_as_machine},
    {"G602", 12, 2, true, false, g_without_effect},
    {"G603", 12, 3, true, false, g_without_effect},
    // group 13: Workpiece dimensioning inch/metric
    {"G70", 13, 1, true, false, g_units},
    {"G71", 13, 2, true, true, g_units},
    {"G700", 13, 3, true, false, g_units},
    {"G710", 13, 4, true, false, g_units},
    // group 14: Workpiece dimensioning absolute/incremental
    {"G90", 14, 1, true, true, g_distance},
    {"G91", 14, 2, true, false, g_distance},
    // group 15: Feed type
    {"G93", 15, 1, true, false, g_feed_type},
    {"G94", 15, 2, true, true, g_feed_type},
    {"G95", 15, 3, true, false, g_feed_type},
    {"G96", 15, 4, true, false, g_feed_type},
    {"G97", 15, 5, true, false, g_feed_type},
    {"G931", 15, 6, true, false, g_feed_type},
    {"G961", 15, 7, true, false, g_feed_type},
    {"G971", 15, 8, true, false, g_feed_type},
    {"G942", 15, 9, true, false, g_feed_type},
    {"G952", 15, 10, true, false, g_feed_type},
    {"G962", 15, 11, true, false, g_feed_type},
    {"G972", 15, 12, true, false, g_feed_type},
    {"G973", 15, 13, true, false, g_feed_type},
    // group 19: Curve transition at spline start
    {"BNAT", 19, 1, true, true, g_as_machine},
    {"BTAN", 19, 2, true, false, g_without_effect},
    {"BAUTO", 19, 3, true, false, g_without_effect},
    // group 20: Curve transition at spline end
    {"ENAT", 20, 1, true, true, g_as_machine},
    {"ETAN", 20, 2, true, false, g_without_effect},
    {"EAUTO", 20, 3, true, false, g_without_effect},
    // group 21: Acceleration profile
    {"BRISK", 21, 1, true, true, g_without_effect},
    {"SOFT", 21, 2, true, false, g_as_machine},
    {"DRIVE", 21, 3, true, false, g_without_effect},
    // group 24: Feedforward control
    {"FFWOF", 24, 1, true, true, g_as_machine},
    {"FFWON", 24, 2, true, false, g_without_effect},
    // group 25: Tool orientation reference
    {"ORIWKS", 25, 1, true, true, g_as_machine},
    {"ORIMKS", 25, 2, true, false, g_without_effect},
    // group 26: Repositioning mode for REPOS (modal)
    {"RMB", 26, 1, true, false, g_without_effect},
    {"RMI", 26, 2, true, true, g_as_machine},
    {"RME", 26, 3, true, false, g_without_effect},
    {"RMN", 26, 4, true, false, g_without_effect},
    // group 27: Tool offset with orientation change at outer corners
    {"ORIC", 27, 1, true, true, g_as_machine},
    {"ORID", 27, 2, true, false, g_without_effect},
    // group 28: Working-area limitation (BCS)
    {"WALIMON", 28, 1, true, true, g_mode},
    {"WALIMOF", 28, 2, true, false, g_mode},
    // group 29: Radius/diameter programming
    {"DIAMOF", 29, 1, true, true, g_diameter},
    {"DIAMON", 29, 2, true, false, g_diameter},
    {"DIAM90", 29, 3, true, false, g_diameter},
    {"DIAMCYCOF", 29, 4, true, false, g_diameter},
    // group 30: NC block compression
    {"COMPOF", 30, 1, true, true, g_as_machine},
    {"COMPON", 30, 2, true, false, g_without_effect},
    {"COMPCURV", 30, 3, true, false, g_without_effect},
    {"COMPCAD", 30, 4, true, false, g_without_effect},
    {"COMPSURF", 30, 5, true, false, g_without_effect},
    // group 31: OEM G codes
    {"G810", 31, 1, true, false, g_without_effect},
    {"G811", 31, 2, true, false, g_without_effect},
    {"G812", 31, 3, true, false, g_without_effect},
    {"G813", 31, 4, true, false, g_without_effect},
    {"G814", 31, 5, true, false, g_without_effect},
    {"G815", 31, 6, true, false, g_without_effect},
    {"G816", 31, 7, true, false, g_without_effect},
    {"G817", 31, 8, true, false, g_without_effect},
    {"G818", 31, 9, true, false, g_without_effect},
    {"G819", 31, 10, true, false, g_without_effect},
    // group 32: OEM G codes
    {"G820", 32, 1, true, false, g_without_effect},
    {"G821", 32, 2, true, false, g_without_effect},
    {"G822", 32, 3, true, false, g_without_effect},
    {"G823", 32, 4, true, false, g_without_effect},
    {"G824", 32, 5, true, false, g_without_effect},
    {"G825", 32, 6, true, false, g_without_effect},
    {"G826", 32, 7, true, false, g_without_effect},
    {"G827", 32, 8, true, false, g_without_effect},
    {"G828", 32, 9, true, false, g_without_effect},
    {"G829", 32, 10, true, false, g_without_effect},
    // group 33: Settable tool fine offset
    {"FTOCOF", 33, 1, true, true, g_as_machine},
    {"FTOCON", 33, 2, true, false, g_without_effect},
    // group 34: Tool orientation smoothing
    {"OSOF", 34, 1, true, true, g_as_machine},
    {"OSC", 34, 2, true, false, g_without_effect},
    {"OSS", 34, 3, true, false, g_without_effect},
    {"OSSE", 34, 4, true, false, g_without_effect},
    {"OSD", 34, 5, true, false, g_without_effect},
    {"OST", 34, 6, true, false, g_without_effect},
    // group 35: Punching and nibbling
    {"SPOF", 35, 1, true, true, g_as_machine},
    {"SON", 35, 2, true, false, nullptr},
    {"PON", 35, 3, true, false, nullptr},
    {"SONS", 35, 4, true, false, nullptr},
    {"PONS", 35, 5, true, false, nullptr},
    // group 36: Punching with delay
    {"PDELAYON", 36, 1, true, true, g_as_machine},
    {"PDELAYOF", 36, 2, true, false, g_without_effect},
    // group 37: Feed profile
    {"FNORM", 37, 1, true, true, g_as_machine},
    {"FLIN", 37, 2, true, false, g_without_effect},
    {"FCUB", 37, 3, true, false, g_without_effect},
    // group 38: Assignment of fast inputs/outputs for punching/nibbling
    {"SPIF1", 38, 1, true, true, g_as_machine},
    {"SPIF2", 38, 2, true, false, g_without_effect},
    // group 39: Programmable contour accuracy
    {"CPRECOF", 39, 1, true, true, g_as_machine},
    {"CPRECON", 39, 2, true, false, g_without_effect},
    // group 41: Interrupt of thread cutting
    {"LFOF", 41, 1, true, true, g_mode},
    {"LFON", 41, 2, true, false, g_mode},
    // group 42: Toolholder
    {"TCOABS", 42, 1, true, true, g_as_machine},
    {"TCOFR", 42, 2, true, false, g_without_effect},
    {"TCOFRZ", 42, 3, true, false, g_without_effect},
    {"TCOFRY", 42, 4, true, false, g_without_effect},
    {"TCOFRX", 42, 5, true, false, g_without_effect},
    // group 45: Path reference of FGROUP axes
    {"SPATH", 45, 1, true, true, g_as_machine},
    {"UPATH", 45, 2, true, false, g_without_effect},
    // group 46: Plane selection for fast retraction
    {"LFTXT", 46, 1, true, true, g_mode},
    {"LFWP", 46, 2, true, false, g_mode},
    {"LFPOS", 46, 3, true, false, g_mode},
    // group 47: Mode switchover for external NC code
    {"G290", 47, 1, true, true, g_as_machine},
    {"G291", 47, 2, true, false, nullptr},
    // group 49: Point-to-point motion
    {"CP", 49, 1, true, true, g_as_machine},
    {"PTP", 49, 2, true, false, g_without_effect},
    {"PTPG0", 49, 3, true, false, g_without_effect},
    {"PTPWOC", 49, 4, true, false, g_without_effect},
    // group 50: Orientation programming
    {"ORIEULER", 50, 1, true, true, g_as_machine},
    {"ORIRPY", 50, 2, true, false, g_without_effect},
    {"ORIVIRT1", 50, 3, true, false, g_without_effect},
    {"ORIVIRT2", 50, 4, true, false, g_without_effect},
    {"ORIAXPOS", 50, 5, true, false, g_without_effect},
    {"ORIRPY2", 50, 6, true, false, g_without_effect},
    // group 51: Orientation interpolation type
    {"ORIVECT", 51, 1, true, true, g_as_machine},
    {"ORIAXES", 51, 2, true, false, g_without_effect},
    {"ORIPATH", 51, 3, true, false, g_without_effect},
    {"ORIPLANE", 51, 4, true, false, g_without_effect},
    {"ORICONCW", 51, 5, true, false, g_without_effect},
    {"ORICONCCW", 51, 6, true, false, g_without_effect},
    {"ORICONIO", 51, 7, true, false, g_without_effect},
    {"ORICONTO", 51, 8, true, false, g_without_effect},
    {"ORICURVE", 51, 9, true, false, g_without_effect},
    {"ORIPATHS", 51, 10, true, false, g_without_effect},
    // group 52: Workpiece-related frame rotation
    {"PAROTOF", 52, 1, true, true, g_as_machine},
    {"PAROT", 52, 2, true, false, g_without_effect},
    // group 53: Tool-related frame rotation
    {"TOROTOF", 53, 1, true, true, g_tool_frame},
    {"TOROT", 53, 2, true, false, g_tool_frame},
    {"TOROTZ", 53, 3, true, false, g_tool_frame},
    {"TOROTY", 53, 4, true, false, g_tool_frame},
    {"TOROTX", 53, 5, true, false, g_tool_frame},
    {"TOFRAME", 53, 6, true, false, g_tool_frame},
    {"TOFRAMEZ", 53, 7, true, false, g_tool_frame},
    {"TOFRAMEY", 53, 8, true, false, g_tool_frame},
    {"TOFRAMEX", 53, 9, true, false, g_tool_frame},
    // group 54: Vector rotation in polynomial programming
    {"ORIROTA", 54, 1, true, true, g_as_machine},
    {"ORIROTR", 54, 2, true, false, g_without_effect},
    {"ORIROTT", 54, 3, true, false, g_without_effect},
    {"ORIROTC", 54, 4, true, false, g_without_effect},
    // group 55: Rapid traverse with/without linear interpolation
    {"RTLION", 55, 1, true, true, g_as_machine},
    {"RTLIOF", 55, 2, true, false, g_without_effect},
    // group 56: Inclusion of tool wear
    {"TOWSTD", 56, 1, true, true, g_as_machine},
    {"TOWMCS", 56, 2, true, false, g_without_effect},
    {"TOWWCS", 56, 3, true, false, g_without_effect},
    {"TOWBCS", 56, 4, true, false, g_without_effect},
    {"TOWTCS", 56, 5, true, false, g_without_effect},
    {"TOWKCS", 56, 6, true, false, g_without_effect},
    // group 57: Corner deceleration
    {"FENDNORM", 57, 1, true, true, g_as_machine},
    {"G62", 57, 2, true, false, g_without_effect},
    {"G621", 57, 3, true, false, g_without_effect},
    // group 59: Dynamic mode for path interpolation
    {"DYNNORM", 59, 1, true, true, g_as_machine},
    {"DYNPOS", 59, 2, true, false, g_without_effect},
    {"DYNROUGH", 59, 3, true, false, g_without_effect},
    {"DYNSEMIFIN", 59, 4, true, false, g_without_effect},
    {"DYNFINISH", 59, 5, true, false, g_without_effect},
    // group 61: Tool orientation smoothing (ORISON)
    {"ORISOF", 61, 1, true, true, g_as_machine},
    {"ORISON", 61, 2, true, false, g_without_effect},
    // group 62: Repositioning mode for REPOS (block-wise)
    {"RMBBL", 62, 1, false, false, g_without_effect},
    {"RMIBL", 62, 2, false, true, g_as_machine},
    {"RMEBL", 62, 3, false, false, g_without_effect},
    {"RMNBL", 62, 4, false, false, g_without_effect},
    {"GFRAME0", 64, 1, true, true, g_grinding},
};

}  // namespace

std::span<const GCode> program_g_codes() { return kGRows; }

}  // namespace polyturn::channels::sinumerik
