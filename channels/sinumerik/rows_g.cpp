// Rows of the G commands that set modes: sinumerik_part3 6.3. A null handler: known, not built. g_nothing: the mode is kept and
// can be read; it has nothing to act on here (orientation axes, transformations, tool carriers that turn, the machine builder's
// own groups 31 and 32) or leaves the path where it is (compressors).
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr GCode kGRows[] = {
    // name, group, number, modal, delivery state, handler, addresses it reads
    // group 4: FIFO (preprocessing buffer)
    {"STARTFIFO", 4, 1, true, true, &Interpreter::g_nothing},
    {"STOPFIFO", 4, 2, true, false, &Interpreter::g_nothing},
    {"FIFOCTRL", 4, 3, true, false, &Interpreter::g_nothing},
    // group 6: Plane selection
    {"G17", 6, 1, true, true, &Interpreter::g_plane},
    {"G18", 6, 2, true, false, &Interpreter::g_plane},
    {"G19", 6, 3, true, false, &Interpreter::g_plane},
    // group 8: Settable zero offset
    {"G500", 8, 1, true, true, &Interpreter::g_zero},
    {"G54", 8, 2, true, false, &Interpreter::g_zero},
    {"G55", 8, 3, true, false, &Interpreter::g_zero},
    {"G56", 8, 4, true, false, &Interpreter::g_zero},
    {"G57", 8, 5, true, false, &Interpreter::g_zero},
    {"G505", 8, 6, true, false, &Interpreter::g_zero},
    // group 10: Exact stop - continuous-path mode
    {"G60", 10, 1, true, true, &Interpreter::g_exact_stop},
    {"G64", 10, 2, true, false, &Interpreter::g_exact_stop},
    {"G641", 10, 3, true, false, &Interpreter::g_exact_stop},
    {"G642", 10, 4, true, false, &Interpreter::g_exact_stop},
    {"G643", 10, 5, true, false, &Interpreter::g_exact_stop},
    {"G644", 10, 6, true, false, &Interpreter::g_exact_stop},
    {"G645", 10, 7, true, false, &Interpreter::g_exact_stop},
    // group 11: Exact stop, block-wise
    {"G9", 11, 1, false, false, &Interpreter::g_exact_once},
    // group 12: Block change criterion at exact stop (G60/G9)
    {"G601", 12, 1, true, true, &Interpreter::g_nothing},
    {"G602", 12, 2, true, false, &Interpreter::g_nothing},
    {"G603", 12, 3, true, false, &Interpreter::g_nothing},
    // group 13: Workpiece dimensioning inch/metric
    {"G70", 13, 1, true, false, &Interpreter::g_units},
    {"G71", 13, 2, true, true, &Interpreter::g_units},
    {"G700", 13, 3, true, false, &Interpreter::g_units},
    {"G710", 13, 4, true, false, &Interpreter::g_units},
    // group 14: Workpiece dimensioning absolute/incremental
    {"G90", 14, 1, true, true, &Interpreter::g_distance},
    {"G91", 14, 2, true, false, &Interpreter::g_distance},
    // group 15: Feed type
    {"G93", 15, 1, true, false, &Interpreter::g_feed_type},
    {"G94", 15, 2, true, true, &Interpreter::g_feed_type},
    {"G95", 15, 3, true, false, &Interpreter::g_feed_type},
    {"G96", 15, 4, true, false, &Interpreter::g_feed_type},
    {"G97", 15, 5, true, false, &Interpreter::g_feed_type},
    {"G931", 15, 6, true, false, &Interpreter::g_feed_type},
    {"G961", 15, 7, true, false, &Interpreter::g_feed_type},
    {"G971", 15, 8, true, false, &Interpreter::g_feed_type},
    {"G942", 15, 9, true, false, &Interpreter::g_feed_type},
    {"G952", 15, 10, true, false, &Interpreter::g_feed_type},
    {"G962", 15, 11, true, false, &Interpreter::g_feed_type},
    {"G972", 15, 12, true, false, &Interpreter::g_feed_type},
    {"G973", 15, 13, true, false, &Interpreter::g_feed_type},
    // group 19: Curve transition at spline start
    {"BNAT", 19, 1, true, true, &Interpreter::g_nothing},
    {"BTAN", 19, 2, true, false, &Interpreter::g_nothing},
    {"BAUTO", 19, 3, true, false, &Interpreter::g_nothing},
    // group 20: Curve transition at spline end
    {"ENAT", 20, 1, true, true, &Interpreter::g_nothing},
    {"ETAN", 20, 2, true, false, &Interpreter::g_nothing},
    {"EAUTO", 20, 3, true, false, &Interpreter::g_nothing},
    // group 21: Acceleration profile
    {"BRISK", 21, 1, true, true, &Interpreter::g_nothing},
    {"SOFT", 21, 2, true, false, &Interpreter::g_nothing},
    {"DRIVE", 21, 3, true, false, &Interpreter::g_nothing},
    // group 24: Feedforward control
    {"FFWOF", 24, 1, true, true, &Interpreter::g_nothing},
    {"FFWON", 24, 2, true, false, &Interpreter::g_nothing},
    // group 25: Tool orientation reference
    {"ORIWKS", 25, 1, true, true, &Interpreter::g_nothing},
    {"ORIMKS", 25, 2, true, false, &Interpreter::g_nothing},
    // group 26: Repositioning mode for REPOS (modal)
    {"RMB", 26, 1, true, false, &Interpreter::g_nothing},
    {"RMI", 26, 2, true, true, &Interpreter::g_nothing},
    {"RME", 26, 3, true, false, &Interpreter::g_nothing},
    {"RMN", 26, 4, true, false, &Interpreter::g_nothing},
    // group 27: Tool offset with orientation change at outer corners
    {"ORIC", 27, 1, true, true, &Interpreter::g_nothing},
    {"ORID", 27, 2, true, false, &Interpreter::g_nothing},
    // group 28: Working-area limitation (BCS)
    {"WALIMON", 28, 1, true, true, &Interpreter::g_nothing},
    {"WALIMOF", 28, 2, true, false, &Interpreter::g_nothing},
    // group 29: Radius/diameter programming
    {"DIAMOF", 29, 1, true, true, &Interpreter::g_diameter},
    {"DIAMON", 29, 2, true, false, &Interpreter::g_diameter},
    {"DIAM90", 29, 3, true, false, &Interpreter::g_diameter},
    {"DIAMCYCOF", 29, 4, true, false, &Interpreter::g_diameter},
    // group 30: NC block compression
    {"COMPOF", 30, 1, true, true, &Interpreter::g_nothing},
    {"COMPON", 30, 2, true, false, &Interpreter::g_nothing},
    {"COMPCURV", 30, 3, true, false, &Interpreter::g_nothing},
    {"COMPCAD", 30, 4, true, false, &Interpreter::g_nothing},
    {"COMPSURF", 30, 5, true, false, &Interpreter::g_nothing},
    // group 31: OEM G codes
    {"G810", 31, 1, true, false, &Interpreter::g_nothing},
    {"G811", 31, 2, true, false, &Interpreter::g_nothing},
    {"G812", 31, 3, true, false, &Interpreter::g_nothing},
    {"G813", 31, 4, true, false, &Interpreter::g_nothing},
    {"G814", 31, 5, true, false, &Interpreter::g_nothing},
    {"G815", 31, 6, true, false, &Interpreter::g_nothing},
    {"G816", 31, 7, true, false, &Interpreter::g_nothing},
    {"G817", 31, 8, true, false, &Interpreter::g_nothing},
    {"G818", 31, 9, true, false, &Interpreter::g_nothing},
    {"G819", 31, 10, true, false, &Interpreter::g_nothing},
    // group 32: OEM G codes
    {"G820", 32, 1, true, false, &Interpreter::g_nothing},
    {"G821", 32, 2, true, false, &Interpreter::g_nothing},
    {"G822", 32, 3, true, false, &Interpreter::g_nothing},
    {"G823", 32, 4, true, false, &Interpreter::g_nothing},
    {"G824", 32, 5, true, false, &Interpreter::g_nothing},
    {"G825", 32, 6, true, false, &Interpreter::g_nothing},
    {"G826", 32, 7, true, false, &Interpreter::g_nothing},
    {"G827", 32, 8, true, false, &Interpreter::g_nothing},
    {"G828", 32, 9, true, false, &Interpreter::g_nothing},
    {"G829", 32, 10, true, false, &Interpreter::g_nothing},
    // group 33: Settable tool fine offset
    {"FTOCOF", 33, 1, true, true, &Interpreter::g_nothing},
    {"FTOCON", 33, 2, true, false, &Interpreter::g_nothing},
    // group 34: Tool orientation smoothing
    {"OSOF", 34, 1, true, true, &Interpreter::g_nothing},
    {"OSC", 34, 2, true, false, &Interpreter::g_nothing},
    {"OSS", 34, 3, true, false, &Interpreter::g_nothing},
    {"OSSE", 34, 4, true, false, &Interpreter::g_nothing},
    {"OSD", 34, 5, true, false, &Interpreter::g_nothing},
    {"OST", 34, 6, true, false, &Interpreter::g_nothing},
    // group 35: Punching and nibbling
    {"SPOF", 35, 1, true, true, &Interpreter::g_nothing},
    {"SON", 35, 2, true, false, nullptr},
    {"PON", 35, 3, true, false, nullptr},
    {"SONS", 35, 4, true, false, nullptr},
    {"PONS", 35, 5, true, false, nullptr},
    // group 36: Punching with delay
    {"PDELAYON", 36, 1, true, true, &Interpreter::g_nothing},
    {"PDELAYOF", 36, 2, true, false, &Interpreter::g_nothing},
    // group 37: Feed profile
    {"FNORM", 37, 1, true, true, &Interpreter::g_nothing},
    {"FLIN", 37, 2, true, false, &Interpreter::g_nothing},
    {"FCUB", 37, 3, true, false, &Interpreter::g_nothing},
    // group 38: Assignment of fast inputs/outputs for punching/nibbling
    {"SPIF1", 38, 1, true, true, &Interpreter::g_nothing},
    {"SPIF2", 38, 2, true, false, &Interpreter::g_nothing},
    // group 39: Programmable contour accuracy
    {"CPRECOF", 39, 1, true, true, &Interpreter::g_nothing},
    {"CPRECON", 39, 2, true, false, &Interpreter::g_nothing},
    // group 41: Interrupt of thread cutting
    {"LFOF", 41, 1, true, true, &Interpreter::g_nothing},
    {"LFON", 41, 2, true, false, &Interpreter::g_nothing},
    // group 42: Toolholder
    {"TCOABS", 42, 1, true, true, &Interpreter::g_nothing},
    {"TCOFR", 42, 2, true, false, &Interpreter::g_nothing},
    {"TCOFRZ", 42, 3, true, false, &Interpreter::g_nothing},
    {"TCOFRY", 42, 4, true, false, &Interpreter::g_nothing},
    {"TCOFRX", 42, 5, true, false, &Interpreter::g_nothing},
    // group 45: Path reference of FGROUP axes
    {"SPATH", 45, 1, true, true, &Interpreter::g_nothing},
    {"UPATH", 45, 2, true, false, &Interpreter::g_nothing},
    // group 46: Plane selection for fast retraction
    {"LFTXT", 46, 1, true, true, &Interpreter::g_nothing},
    {"LFWP", 46, 2, true, false, &Interpreter::g_nothing},
    {"LFPOS", 46, 3, true, false, &Interpreter::g_nothing},
    // group 47: Mode switchover for external NC code
    {"G290", 47, 1, true, true, &Interpreter::g_nothing},
    {"G291", 47, 2, true, false, nullptr},
    // group 49: Point-to-point motion
    {"CP", 49, 1, true, true, &Interpreter::g_nothing},
    {"PTP", 49, 2, true, false, &Interpreter::g_nothing},
    {"PTPG0", 49, 3, true, false, &Interpreter::g_nothing},
    {"PTPWOC", 49, 4, true, false, &Interpreter::g_nothing},
    // group 50: Orientation programming
    {"ORIEULER", 50, 1, true, true, &Interpreter::g_nothing},
    {"ORIRPY", 50, 2, true, false, &Interpreter::g_nothing},
    {"ORIVIRT1", 50, 3, true, false, &Interpreter::g_nothing},
    {"ORIVIRT2", 50, 4, true, false, &Interpreter::g_nothing},
    {"ORIAXPOS", 50, 5, true, false, &Interpreter::g_nothing},
    {"ORIRPY2", 50, 6, true, false, &Interpreter::g_nothing},
    // group 51: Orientation interpolation type
    {"ORIVECT", 51, 1, true, true, &Interpreter::g_nothing},
    {"ORIAXES", 51, 2, true, false, &Interpreter::g_nothing},
    {"ORIPATH", 51, 3, true, false, &Interpreter::g_nothing},
    {"ORIPLANE", 51, 4, true, false, &Interpreter::g_nothing},
    {"ORICONCW", 51, 5, true, false, &Interpreter::g_nothing},
    {"ORICONCCW", 51, 6, true, false, &Interpreter::g_nothing},
    {"ORICONIO", 51, 7, true, false, &Interpreter::g_nothing},
    {"ORICONTO", 51, 8, true, false, &Interpreter::g_nothing},
    {"ORICURVE", 51, 9, true, false, &Interpreter::g_nothing},
    {"ORIPATHS", 51, 10, true, false, &Interpreter::g_nothing},
    // group 52: Workpiece-related frame rotation
    {"PAROTOF", 52, 1, true, true, &Interpreter::g_nothing},
    {"PAROT", 52, 2, true, false, &Interpreter::g_nothing},
    // group 53: Tool-related frame rotation
    {"TOROTOF", 53, 1, true, true, &Interpreter::g_tool_frame},
    {"TOROT", 53, 2, true, false, &Interpreter::g_tool_frame},
    {"TOROTZ", 53, 3, true, false, &Interpreter::g_tool_frame},
    {"TOROTY", 53, 4, true, false, &Interpreter::g_tool_frame},
    {"TOROTX", 53, 5, true, false, &Interpreter::g_tool_frame},
    {"TOFRAME", 53, 6, true, false, &Interpreter::g_tool_frame},
    {"TOFRAMEZ", 53, 7, true, false, &Interpreter::g_tool_frame},
    {"TOFRAMEY", 53, 8, true, false, &Interpreter::g_tool_frame},
    {"TOFRAMEX", 53, 9, true, false, &Interpreter::g_tool_frame},
    // group 54: Vector rotation in polynomial programming
    {"ORIROTA", 54, 1, true, true, &Interpreter::g_nothing},
    {"ORIROTR", 54, 2, true, false, &Interpreter::g_nothing},
    {"ORIROTT", 54, 3, true, false, &Interpreter::g_nothing},
    {"ORIROTC", 54, 4, true, false, &Interpreter::g_nothing},
    // group 55: Rapid traverse with/without linear interpolation
    {"RTLION", 55, 1, true, true, &Interpreter::g_nothing},
    {"RTLIOF", 55, 2, true, false, &Interpreter::g_nothing},
    // group 56: Inclusion of tool wear
    {"TOWSTD", 56, 1, true, true, &Interpreter::g_nothing},
    {"TOWMCS", 56, 2, true, false, &Interpreter::g_nothing},
    {"TOWWCS", 56, 3, true, false, &Interpreter::g_nothing},
    {"TOWBCS", 56, 4, true, false, &Interpreter::g_nothing},
    {"TOWTCS", 56, 5, true, false, &Interpreter::g_nothing},
    {"TOWKCS", 56, 6, true, false, &Interpreter::g_nothing},
    // group 57: Corner deceleration
    {"FENDNORM", 57, 1, true, true, &Interpreter::g_nothing},
    {"G62", 57, 2, true, false, &Interpreter::g_nothing},
    {"G621", 57, 3, true, false, &Interpreter::g_nothing},
    // group 59: Dynamic mode for path interpolation
    {"DYNNORM", 59, 1, true, true, &Interpreter::g_nothing},
    {"DYNPOS", 59, 2, true, false, &Interpreter::g_nothing},
    {"DYNROUGH", 59, 3, true, false, &Interpreter::g_nothing},
    {"DYNSEMIFIN", 59, 4, true, false, &Interpreter::g_nothing},
    {"DYNFINISH", 59, 5, true, false, &Interpreter::g_nothing},
    // group 61: Tool orientation smoothing (ORISON)
    {"ORISOF", 61, 1, true, true, &Interpreter::g_nothing},
    {"ORISON", 61, 2, true, false, &Interpreter::g_nothing},
    // group 62: Repositioning mode for REPOS (block-wise)
    {"RMBBL", 62, 1, false, false, &Interpreter::g_nothing},
    {"RMIBL", 62, 2, false, true, &Interpreter::g_nothing},
    {"RMEBL", 62, 3, false, false, &Interpreter::g_nothing},
    {"RMNBL", 62, 4, false, false, &Interpreter::g_nothing},
    {"GFRAME0", 64, 1, true, true, &Interpreter::g_grinding},
};

}  // namespace

std::span<const GCode> program_g_codes() { return kGRows; }

}  // namespace polyturn::channels::sinumerik
