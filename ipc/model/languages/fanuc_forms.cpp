// Forms of the fanuc family: fanuc of systems A, B and C, its series 15 format, nct (fanuc_lathe
// 8.3 to 8.5, nct part 2 17.1).
#include <array>

#include "ipc/model/languages/forms.hpp"

namespace polyturn::forms {
namespace {

using U = Unit;
using M = Mark;
constexpr bool kNeeded = true, kMay = false;
constexpr double kMost = 99999.0;

// Cycles of two blocks.
constexpr Field kG71[] = {
    {"U", 0, U::Length, M::Depth, kMay, 0.001, kMost, "2", "Depth of cut (radius)"},
    {"R", 0, U::Length, M::Retract, kMay, 0, kMost, "0.5", "Retract after each pass"},
    {"P", 1, U::Label, M::Contour, kNeeded, 1, 99999, "100", "First block of the contour"},
    {"Q", 1, U::Label, M::Contour, kNeeded, 1, 99999, "200", "Last block of the contour"},
    {"U", 1, U::Diameter, M::AllowanceX, kMay, -kMost, kMost, "0.4", "Finishing allowance X"},
    {"W", 1, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "0.1", "Finishing allowance Z"},
    {"F", 1, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.25", "Feed of roughing"},
};
constexpr Field kG72[] = {
    {"W", 0, U::Length, M::Depth, kMay, 0.001, kMost, "2", "Depth of cut along Z"},
    {"R", 0, U::Length, M::Retract, kMay, 0, kMost, "0.5", "Retract after each pass"},
    {"P", 1, U::Label, M::Contour, kNeeded, 1, 99999, "100", "First block of the contour"},
    {"Q", 1, U::Label, M::Contour, kNeeded, 1, 99999, "200", "Last block of the contour"},
    {"U", 1, U::Diameter, M::AllowanceX, kMay, -kMost, kMost, "0.4", "Finishing allowance X"},
    {"W", 1, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "0.1", "Finishing allowance Z"},
    {"F", 1, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.25", "Feed of roughing"},
};
constexpr Field kG73[] = {
    {"U", 0, U::Length, M::ReliefX, kMay, -kMost, kMost, "5", "Stock to take off along X (radius)"},
    {"W", 0, U::Length, M::ReliefZ, kMay, -kMost, kMost, "2", "Stock to take off along Z"},
    {"R", 0, U::Count, M::Count, kMay, 1, 9999, "3", "Number of passes"},
    {"P", 1, U::Label, M::Contour, kNeeded, 1, 99999, "100", "First block of the contour"},
    {"Q", 1, U::Label, M::Contour, kNeeded, 1, 99999, "200", "Last block of the contour"},
    {"U", 1, U::Diameter, M::AllowanceX, kMay, -kMost, kMost, "0.4", "Finishing allowance X"},
    {"W", 1, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "0.1", "Finishing allowance Z"},
    {"F", 1, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.25", "Feed of roughing"},
};
constexpr Field kG70[] = {
    {"P", 0, U::Label, M::Contour, kNeeded, 1, 99999, "100", "First block of the contour"},
    {"Q", 0, U::Label, M::Contour, kNeeded, 1, 99999, "200", "Last block of the contour"},
    {"F", 0, U::FeedRate, M::FinishFeed, kMay, 0.0001, kMost, "",
     "Feed of finishing, where the contour says none"},
};
constexpr Field kG74[] = {
    {"R", 0, U::Length, M::Retract, kMay, 0, kMost, "0.5", "Way back after each peck"},
    {"X", 1, U::Diameter, M::EndX, kMay, -kMost, kMost, "", "End point X of the last plunge", "U"},
    {"Z", 1, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "Bottom Z", "W"},
    {"P", 1, U::Fine, M::Step, kMay, 0, kMost, "", "Step along X (radius)"},
    {"Q", 1, U::Fine, M::Peck, kMay, 0, kMost, "5", "Depth of a peck along Z"},
    {"R", 1, U::Length, M::Aside, kMay, -kMost, kMost, "", "Relief at the bottom"},
    {"F", 1, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.1", "Feed"},
};
constexpr Field kG75[] = {
    {"R", 0, U::Length, M::Retract, kMay, 0, kMost, "0.5", "Way back after each peck"},
    {"X", 1, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "20", "Bottom X", "U"},
    {"Z", 1, U::Length, M::EndZ, kMay, -kMost, kMost, "", "End point Z of the last plunge", "W"},
    {"P", 1, U::Fine, M::Peck, kMay, 0, kMost, "2", "Depth of a peck along X (radius)"},
    {"Q", 1, U::Fine, M::Step, kMay, 0, kMost, "", "Step along Z"},
    {"R", 1, U::Length, M::Aside, kMay, -kMost, kMost, "", "Relief at the bottom"},
    {"F", 1, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.1", "Feed"},
};
constexpr Field kG76[] = {
    {"P", 0, U::Count, M::Count, kMay, 1, 99, "2", "Finishing passes", {}, 0, 2},
    {"P", 0, U::Tenths, M::Chamfer, kMay, 0, 99, "10", "Run-out in tenths of the lead", {}, 2, 2},
    {"P", 0, U::Degrees, M::ToolAngle, kMay, 0, 99, "60", "Angle of the tool tip", {}, 4, 2},
    {"Q", 0, U::Fine, M::LeastPass, kMay, 0, kMost, "0.05", "Least depth of a pass"},
    {"R", 0, U::Length, M::AllowanceX, kMay, -kMost, kMost, "0.02", "Finishing allowance"},
    {"X", 1, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "17.55", "Core diameter at the end",
     "U"},
    {"Z", 1, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "End of the thread Z", "W"},
    {"R", 1, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"P", 1, U::Fine, M::ThreadDepth, kNeeded, 0.0001, kMost, "1.227",
     "Height of the thread (radius)"},
    {"Q", 1, U::Fine, M::FirstPass, kNeeded, 0.0001, kMost, "0.3",
     "Depth of the first pass (radius)"},
    {"F", 1, U::Lead, M::Lead, kMay, 0.0001, 500, "2", "Lead"},
};

// The same in one block: series 15.
constexpr Field kG71One[] = {
    {"P", 0, U::Label, M::Contour, kNeeded, 1, 99999, "100", "First block of the contour"},
    {"Q", 0, U::Label, M::Contour, kNeeded, 1, 99999, "200", "Last block of the contour"},
    {"U", 0, U::Diameter, M::AllowanceX, kMay, -kMost, kMost, "0.4", "Finishing allowance X"},
    {"W", 0, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "0.1", "Finishing allowance Z"},
    {"D", 0, U::Fine, M::Depth, kMay, 0.001, kMost, "2", "Depth of cut"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.25", "Feed of roughing"},
};
constexpr Field kG73One[] = {
    {"P", 0, U::Label, M::Contour, kNeeded, 1, 99999, "100", "First block of the contour"},
    {"Q", 0, U::Label, M::Contour, kNeeded, 1, 99999, "200", "Last block of the contour"},
    {"I", 0, U::Length, M::ReliefX, kMay, -kMost, kMost, "5", "Stock to take off along X (radius)"},
    {"K", 0, U::Length, M::ReliefZ, kMay, -kMost, kMost, "2", "Stock to take off along Z"},
    {"D", 0, U::Count, M::Count, kMay, 1, 9999, "3", "Number of passes"},
    {"U", 0, U::Diameter, M::AllowanceX, kMay, -kMost, kMost, "0.4", "Finishing allowance X"},
    {"W", 0, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "0.1", "Finishing allowance Z"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.25", "Feed of roughing"},
};
constexpr Field kG74One[] = {
    {"X", 0, U::Diameter, M::EndX, kMay, -kMost, kMost, "", "End point X of the last plunge", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "Bottom Z", "W"},
    {"I", 0, U::Length, M::Step, kMay, 0, kMost, "", "Step along X (radius)"},
    {"K", 0, U::Length, M::Peck, kMay, 0, kMost, "5", "Depth of a peck along Z"},
    {"D", 0, U::Fine, M::Aside, kMay, -kMost, kMost, "", "Relief at the bottom"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.1", "Feed"},
};
constexpr Field kG75One[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "20", "Bottom X", "U"},
    {"Z", 0, U::Length, M::EndZ, kMay, -kMost, kMost, "", "End point Z of the last plunge", "W"},
    {"I", 0, U::Length, M::Peck, kMay, 0, kMost, "2", "Depth of a peck along X (radius)"},
    {"K", 0, U::Length, M::Step, kMay, 0, kMost, "", "Step along Z"},
    {"D", 0, U::Fine, M::Aside, kMay, -kMost, kMost, "", "Relief at the bottom"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.1", "Feed"},
};
constexpr Field kG76One[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "17.55", "Core diameter at the end",
     "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "End of the thread Z", "W"},
    {"I", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"K", 0, U::Length, M::ThreadDepth, kNeeded, 0.0001, kMost, "1.227",
     "Height of the thread (radius)"},
    {"D", 0, U::Fine, M::FirstPass, kNeeded, 0.0001, kMost, "0.3",
     "Depth of the first pass (radius)"},
    {"A", 0, U::Degrees, M::ToolAngle, kMay, 0, 120, "60", "Angle of the tool tip"},
    {"F", 0, U::Lead, M::Lead, kMay, 0.0001, 500, "2", "Lead"},
};

// Simple cycles.
constexpr Field kTurning[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "36", "Diameter at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-30", "End point Z", "W"},
    {"R", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.2", "Feed"},
};
constexpr Field kFacing[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "10", "Diameter at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-2", "Face Z", "W"},
    {"R", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (Z at the start less that at the end)"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.2", "Feed"},
};
constexpr Field kThread[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "19.4",
     "Diameter of this pass at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "End of the thread Z", "W"},
    {"R", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"F", 0, U::Lead, M::Lead, kNeeded, 0.0001, 500, "1.5", "Lead"},
    {"Q", 0, U::Thousandth, M::StartAngle, kMay, 0, 360, "", "Angle of the spindle at the start"},
};
constexpr Field kThreadNct[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "19.4",
     "Diameter of this pass at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "End of the thread Z", "W"},
    {"R", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"F", 0, U::Lead, M::Lead, kNeeded, 0.0001, 500, "1.5", "Lead"},
    {"Q", 0, U::Degrees, M::StartAngle, kMay, 0, 360, "", "Angle of the spindle at the start"},
};
constexpr Field kTurning15[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "36", "Diameter at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-30", "End point Z", "W"},
    {"I", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.2", "Feed"},
};
constexpr Field kFacing15[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "10", "Diameter at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-2", "Face Z", "W"},
    {"K", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (Z at the start less that at the end)"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.2", "Feed"},
};
constexpr Field kThread15[] = {
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "19.4",
     "Diameter of this pass at the end", "U"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-20", "End of the thread Z", "W"},
    {"I", 0, U::Length, M::Taper, kMay, -kMost, kMost, "",
     "Taper (radius at the start less that at the end)"},
    {"F", 0, U::Lead, M::Lead, kNeeded, 0.0001, 500, "1.5", "Lead"},
};

// Drilling in the face (Z is the depth) and in the side (X is); `repeats`: K of the own format, L
// of series 15 and nct.
#define POLYTURN_FACE_HOLE(repeats, more)                                                           \
    {"X", 0, U::Diameter, M::Place, kMay, -kMost, kMost, "0", "Place of the hole X", "U"},          \
        {"C", 0, U::Rotary, M::Place, kMay, -kMost, kMost, "", "Place of the hole C", "H"},         \
        {"Z", 0, U::Length, M::Bottom, kNeeded, -kMost, kMost, "-15", "Bottom of the hole Z", "W"}, \
        {"R", 0, U::Length, M::RLevel, kMay, -kMost, kMost, "", "From rapid to feed (R level)"},    \
        more{"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.1", "Feed"}, {                   \
        repeats, 0, U::Count, M::Count, kMay, 0, 9999, "", "Number of holes"                        \
    }
#define POLYTURN_SIDE_HOLE(repeats, more)                                                            \
    {"Z", 0, U::Length, M::Place, kMay, -kMost, kMost, "-10", "Place of the hole Z", "W"},           \
        {"C", 0, U::Rotary, M::Place, kMay, -kMost, kMost, "", "Place of the hole C", "H"},          \
        {"X", 0, U::Diameter, M::Bottom, kNeeded, -kMost, kMost, "20", "Bottom of the hole X", "U"}, \
        {"R", 0, U::Length, M::RLevel, kMay, -kMost, kMost, "", "From rapid to feed (R level)"},     \
        more{"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "0.1", "Feed"}, {                    \
        repeats, 0, U::Count, M::Count, kMay, 0, 9999, "", "Number of holes"                         \
    }
#define POLYTURN_DWELL \
    {"P", 0, U::Milliseconds, M::Dwell, kMay, 0, 99999, "", "Dwell at the bottom"},
#define POLYTURN_PECK \
    {"Q", 0, U::Length, M::Peck, kMay, 0.001, kMost, "5", "Depth of a peck"}, POLYTURN_DWELL
#define POLYTURN_PECK_E \
    POLYTURN_PECK{      \
        "E", 0, U::Length, M::Retract, kMay, 0, kMost, "", "Way back or clearance of a peck"},
#define POLYTURN_NO_MORE
constexpr Field kPeckFace[] = {POLYTURN_FACE_HOLE("K", POLYTURN_PECK)};
constexpr Field kHoleFace[] = {POLYTURN_FACE_HOLE("K", POLYTURN_DWELL)};
constexpr Field kPeckSide[] = {POLYTURN_SIDE_HOLE("K", POLYTURN_PECK)};
constexpr Field kHoleSide[] = {POLYTURN_SIDE_HOLE("K", POLYTURN_DWELL)};
constexpr Field kPlain15[] = {POLYTURN_FACE_HOLE("L", POLYTURN_NO_MORE)};
constexpr Field kPeck15[] = {POLYTURN_FACE_HOLE("L", POLYTURN_PECK)};
constexpr Field kPeckNct[] = {POLYTURN_FACE_HOLE("L", POLYTURN_PECK_E)};
constexpr Field kHole15[] = {POLYTURN_FACE_HOLE("L", POLYTURN_DWELL)};

constexpr Form kForms[] = {
    {"G71", kFanucAB | kNct, Picture::Roughing, "Roughing along Z", kG71, "PQ"},
    {"G72", kFanucAB | kNct, Picture::FaceRoughing, "Roughing along X", kG72, "PQ"},
    {"G73", kFanucAB | kNct, Picture::Pattern, "Repeating a contour", kG73, "PQ"},
    {"G71", kSeries15AB, Picture::Roughing, "Roughing along Z", kG71One, {}},
    {"G72", kSeries15AB, Picture::FaceRoughing, "Roughing along X", kG71One, {}},
    {"G73", kSeries15AB, Picture::Pattern, "Repeating a contour", kG73One, {}},
    {"G70", kFanucAB | kNct | kSeries15AB, Picture::Finishing, "Finishing a contour", kG70, {}},
    {"G74", kFanucAB | kNct, Picture::PeckFace, "Pecking and grooving along Z", kG74, "XZUWPQ"},
    {"G75", kFanucAB | kNct, Picture::Groove, "Grooving along X", kG75, "XZUWPQ"},
    {"G76", kFanucAB | kNct, Picture::Thread, "Thread in several passes", kG76, "XZUW"},
    {"G74", kSeries15AB, Picture::PeckFace, "Pecking and grooving along Z", kG74One, {}},
    {"G75", kSeries15AB, Picture::Groove, "Grooving along X", kG75One, {}},
    {"G76", kSeries15AB, Picture::Thread, "Thread in several passes", kG76One, {}},
    {"G90", kFanucA, Picture::Turning, "Turning, one pass", kTurning, {}},
    {"G92", kFanucA, Picture::TurningThread, "Thread, one pass", kThread, {}},
    {"G94", kFanucA, Picture::Facing, "Facing, one pass", kFacing, {}},
    {"G90", kSeries15A, Picture::Turning, "Turning, one pass", kTurning15, {}},
    {"G92", kSeries15A, Picture::TurningThread, "Thread, one pass", kThread15, {}},
    {"G94", kSeries15A, Picture::Facing, "Facing, one pass", kFacing15, {}},
    {"G77", kFanucB | kNct, Picture::Turning, "Turning, one pass", kTurning, {}},
    {"G78", kFanucB, Picture::TurningThread, "Thread, one pass", kThread, {}},
    {"G78", kNct, Picture::TurningThread, "Thread, one pass", kThreadNct, {}},
    {"G79", kFanucB | kNct, Picture::Facing, "Facing, one pass", kFacing, {}},
    {"G77", kSeries15B, Picture::Turning, "Turning, one pass", kTurning15, {}},
    {"G78", kSeries15B, Picture::TurningThread, "Thread, one pass", kThread15, {}},
    {"G79", kSeries15B, Picture::Facing, "Facing, one pass", kFacing15, {}},
    {"G73", kFanucC, Picture::Roughing, "Roughing along Z", kG71, "PQ"},
    {"G74", kFanucC, Picture::FaceRoughing, "Roughing along X", kG72, "PQ"},
    {"G75", kFanucC, Picture::Pattern, "Repeating a contour", kG73, "PQ"},
    {"G73", kSeries15C, Picture::Roughing, "Roughing along Z", kG71One, {}},
    {"G74", kSeries15C, Picture::FaceRoughing, "Roughing along X", kG71One, {}},
    {"G75", kSeries15C, Picture::Pattern, "Repeating a contour", kG73One, {}},
    {"G72", kFanucC | kSeries15C, Picture::Finishing, "Finishing a contour", kG70, {}},
    {"G76", kFanucC, Picture::PeckFace, "Pecking and grooving along Z", kG74, "XZUWPQ"},
    {"G77", kFanucC, Picture::Groove, "Grooving along X", kG75, "XZUWPQ"},
    {"G78", kFanucC, Picture::Thread, "Thread in several passes", kG76, "XZUW"},
    {"G76", kSeries15C, Picture::PeckFace, "Pecking and grooving along Z", kG74One, {}},
    {"G77", kSeries15C, Picture::Groove, "Grooving along X", kG75One, {}},
    {"G78", kSeries15C, Picture::Thread, "Thread in several passes", kG76One, {}},
    {"G20", kFanucC, Picture::Turning, "Turning, one pass", kTurning, {}},
    {"G21", kFanucC, Picture::TurningThread, "Thread, one pass", kThread, {}},
    {"G24", kFanucC, Picture::Facing, "Facing, one pass", kFacing, {}},
    {"G20", kSeries15C, Picture::Turning, "Turning, one pass", kTurning15, {}},
    {"G21", kSeries15C, Picture::TurningThread, "Thread, one pass", kThread15, {}},
    {"G24", kSeries15C, Picture::Facing, "Facing, one pass", kFacing15, {}},
    {"G83", kNative, Picture::DrillFace, "Drilling in the face", kPeckFace, {}},
    {"G84", kNative, Picture::TapFace, "Tapping in the face", kHoleFace, {}},
    {"G85", kNative, Picture::BoreFace, "Boring in the face", kHoleFace, {}},
    {"G87", kNative, Picture::DrillSide, "Drilling in the side", kPeckSide, {}},
    {"G88", kNative, Picture::TapSide, "Tapping in the side", kHoleSide, {}},
    {"G89", kNative, Picture::BoreSide, "Boring in the side", kHoleSide, {}},
    {"G81", kSeries15 | kNct, Picture::DrillFace, "Drilling", kPlain15, {}},
    {"G82", kSeries15 | kNct, Picture::DrillFace, "Drilling with a dwell", kHole15, {}},
    {"G83", kSeries15, Picture::DrillFace, "Drilling with pecks", kPeck15, {}},
    {"G83.1", kSeries15, Picture::DrillFace, "Drilling, breaking chips", kPeck15, {}},
    {"G83", kNct, Picture::DrillFace, "Drilling with pecks", kPeckNct, {}},
    {"G83.1", kNct, Picture::DrillFace, "Drilling, breaking chips", kPeckNct, {}},
    {"G84", kSeries15 | kNct, Picture::TapFace, "Tapping", kHole15, {}},
    {"G84.1", kNct, Picture::TapFace, "Tapping a left-hand thread", kHole15, {}},
    {"G84.2", kSeries15, Picture::TapFace, "Rigid tapping", kHole15, {}},
    {"G84.2", kNct, Picture::TapFace, "Rigid tapping", kPeckNct, {}},
    {"G84.3", kNct, Picture::TapFace, "Rigid tapping of a left-hand thread", kPeckNct, {}},
    {"G85", kSeries15 | kNct, Picture::BoreFace, "Boring", kPlain15, {}},
    {"G86", kNct, Picture::BoreFace, "Boring, back with the spindle stopped", kHole15, {}},
    {"G89", kSeries15 | kNct, Picture::BoreFace, "Boring with a dwell", kHole15, {}},
};

}  // namespace

std::span<const Form> fanuc_forms() { return kForms; }

Dialect dialect_of(std::string_view language, char system, bool series15, bool point_means_nothing,
                   double increment) {
    if (language == "fagor") return {kFagor, false, increment};
    if (language == "sinumerik") return {kSinumerik, false, increment};
    if (language == "nct") return {kNct, !point_means_nothing, increment};
    if (language != "fanuc") return {};
    const Speaks own = system == 'A'   ? kFanucA
                       : system == 'B' ? kFanucB
                                       : kFanucC,
                 of_15 = system == 'A'   ? kSeries15A
                         : system == 'B' ? kSeries15B
                                         : kSeries15C;
    return {series15 ? of_15 : own, !point_means_nothing, increment};
}

}  // namespace polyturn::forms
