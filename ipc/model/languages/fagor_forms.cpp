// Forms of the canned cycles of the language fagor (fagor_8037t part 2, 9.1 to 9.12). Points are
// absolute, other lengths are radius values.
#include "ipc/model/languages/forms.hpp"

namespace polyturn::forms {
namespace {

using U = Unit;
using M = Mark;
constexpr bool kNeeded = true, kMay = false;
constexpr double kMost = 99999.0;

#define POLYTURN_START                                                                 \
    {"X", 0, U::Diameter, M::StartX, kNeeded, -kMost, kMost, "20", "Start point X"}, { \
        "Z", 0, U::Length, M::StartZ, kNeeded, -kMost, kMost, "0", "Start point Z"     \
    }
#define POLYTURN_END(z)                                                            \
    {"Q", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "40", "End point X"}, { \
        "R", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, z, "End point Z"       \
    }
#define POLYTURN_PASSES                                                                      \
    {"C", 0, U::Length, M::Depth, kNeeded, 0.0001, kMost, "2", "Depth of cut"}, {            \
        "D", 0, U::Length, M::Safety, kMay, 0, kMost, "1", "Safety distance of the way back" \
    }
#define POLYTURN_FEEDS                                                                      \
    {"F", 0, U::FeedRate, M::Feed, kMay, 0, kMost, "", "Feed of the last roughing pass"}, { \
        "H", 0, U::FeedRate, M::FinishFeed, kMay, 0, kMost, "", "Feed of finishing"         \
    }
#define POLYTURN_PROFILE                                                                        \
    {"S", 0, U::Label, M::Contour, kNeeded, 0, 9999, "100", "First block of the contour"},      \
        {"E", 0, U::Label, M::Contour, kNeeded, 0, 9999, "200", "Last block of the contour"}, { \
        "Q", 0, U::Label, M::Contour, kMay, 0, 999999, "", "Program with the contour"           \
    }
#define POLYTURN_SECTION(z)                                                              \
    POLYTURN_START, POLYTURN_END(z), POLYTURN_PASSES,                                    \
        {"L", 0, U::Length, M::AllowanceX, kMay, 0, kMost, "", "Finishing allowance X"}, \
        {"M", 0, U::Length, M::AllowanceZ, kMay, 0, kMost, "", "Finishing allowance Z"}, \
        POLYTURN_FEEDS

constexpr Field kG66[] = {
    POLYTURN_START,
    {"I", 0, U::Length, M::ReliefX, kNeeded, 0, kMost, "6", "Stock to take off"},
    {"C", 0, U::Length, M::Depth, kNeeded, 0.0001, kMost, "2", "Depth of cut"},
    {"A", 0, U::Choice, M::None, kMay, 0, 1, "", "Main axis: 0 Z, 1 X"},
    {"L", 0, U::Length, M::AllowanceX, kMay, -kMost, kMost, "", "Finishing allowance X"},
    {"M", 0, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "", "Finishing allowance Z"},
    {"H", 0, U::FeedRate, M::FinishFeed, kMay, 0, kMost, "", "Feed of finishing"},
    POLYTURN_PROFILE,
};
constexpr Field kG68[] = {
    POLYTURN_START,
    POLYTURN_PASSES,
    {"L", 0, U::Length, M::AllowanceX, kMay, -kMost, kMost, "", "Finishing allowance X"},
    {"M", 0, U::Length, M::AllowanceZ, kMay, -kMost, kMost, "", "Finishing allowance Z"},
    {"K", 0, U::FeedRate, M::Feed, kMay, 0, kMost, "", "Feed into hollows"},
    POLYTURN_FEEDS,
    POLYTURN_PROFILE,
};
constexpr Field kG81[] = {POLYTURN_SECTION("-30")};
constexpr Field kG84[] = {
    POLYTURN_SECTION("-10"),
    {"I", 0, U::Length, M::CentreX, kMay, -kMost, kMost, "0",
     "Centre from the start point X (radius)"},
    {"K", 0, U::Length, M::CentreZ, kMay, -kMost, kMost, "-10", "Centre from the start point Z"},
};
constexpr Field kG83[] = {
    {"X", 0, U::Diameter, M::Place, kNeeded, -kMost, kMost, "0", "Place of the hole X"},
    {"Z", 0, U::Length, M::StartZ, kNeeded, -kMost, kMost, "0", "Surface Z"},
    {"I", 0, U::Length, M::Bottom, kNeeded, -kMost, kMost, "20", "Depth of the hole"},
    {"B", 0, U::Length, M::Peck, kNeeded, 0, kMost, "5", "Depth of a peck; 0: tapping"},
    {"D", 0, U::Length, M::Safety, kMay, 0, kMost, "2", "Safety distance"},
    {"K", 0, U::Hundredths, M::Dwell, kMay, 0, 99999, "", "Dwell at the bottom"},
    {"H", 0, U::Length, M::Retract, kMay, 0, kMost, "", "Way back after each peck"},
    {"C", 0, U::Length, M::RLevel, kMay, 0, kMost, "", "Clearance before the next peck"},
    {"L", 0, U::Length, M::LeastPass, kMay, 0, kMost, "", "Least depth of a peck"},
    {"R", 0, U::Plain, M::None, kMay, 0, kMost, "", "Factor of the pecks; tapping: kind 0, 1, 2"},
};
#define POLYTURN_THREAD(x, z)                                                                    \
    {"X", 0, U::Diameter, M::StartX, kNeeded, -kMost, kMost, x, "Start point X"},                \
        {"Z", 0, U::Length, M::StartZ, kNeeded, -kMost, kMost, "0", "Start point Z"},            \
        {"Q", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "20", "End point X"},             \
        {"R", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, z, "End point Z"},                  \
        {"K",     0,    U::Length,                                                               \
         M::None, kMay, -kMost,                                                                  \
         kMost,   "",   "Repair: where the thread was measured"},                                \
        {"I",                                                                                    \
         0,                                                                                      \
         U::Length,                                                                              \
         M::ThreadDepth,                                                                         \
         kNeeded,                                                                                \
         -kMost,                                                                                 \
         kMost,                                                                                  \
         "1.227",                                                                                \
         "Height of the thread (radius)"},                                                       \
        {"B",          0,       U::Length,                                                       \
         M::FirstPass, kNeeded, -kMost,                                                          \
         kMost,        "0.3",   "Depth of the first pass (radius)"},                             \
        {"E", 0, U::Length, M::LeastPass, kMay, -kMost, kMost, "0.05", "Least depth of a pass"}, \
        {"D", 0, U::Length, M::Safety, kMay, -kMost, kMost, "1", "Safety distance"},             \
        {"L", 0, U::Length, M::AllowanceX, kMay, -kMost, kMost, "", "Finishing allowance"},      \
        {"C", 0, U::Lead, M::Lead, kNeeded, -500, 500, "2", "Lead"},                             \
        {"J", 0, U::Length, M::Chamfer, kMay, -kMost, kMost, "", "Length of the run-out"},       \
        {"A", 0, U::Degrees, M::ToolAngle, kMay, -90, 90, "30", "Angle of the infeed"},          \
        {"W",           0,    U::Degrees,                                                        \
         M::StartAngle, kMay, -360,                                                              \
         360,           "",   "Angle of the spindle at the start"},                              \
        {"V", 0, U::Count, M::Count, kMay, 0, 99, "", "Number of starts"},                       \
        {"M", 0, U::Length, M::None, kMay, -500, 500, "", "Change of the lead a revolution"},    \
        {"H", 0, U::Choice, M::None, kMay, 0, 9, "", "Kind of infeed"}, {                        \
        "U", 0, U::Choice, M::None, kMay, 0, 1, "", "Runs in and out within the thread: 1"       \
    }
constexpr Field kG86[] = {POLYTURN_THREAD("20", "-30")};
constexpr Field kG87[] = {POLYTURN_THREAD("40", "0")};
#define POLYTURN_GROOVE(z, end)                                                             \
    {"X", 0, U::Diameter, M::StartX, kNeeded, -kMost, kMost, "40", "Start point X"},        \
        {"Z", 0, U::Length, M::StartZ, kNeeded, -kMost, kMost, z, "Start point Z"},         \
        {"Q", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "30", "End point X"},        \
        {"R", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, end, "End point Z"},           \
        {"C", 0, U::Length, M::Step, kMay, 0.0001, kMost, "2", "Step between two plunges"}, \
        {"D", 0, U::Length, M::Safety, kMay, 0, kMost, "1", "Safety distance"}, {           \
        "K", 0, U::Hundredths, M::Dwell, kMay, 0, 99999, "", "Dwell at the bottom"          \
    }
constexpr Field kG88[] = {POLYTURN_GROOVE("-10", "-20")};
constexpr Field kG89[] = {POLYTURN_GROOVE("0", "-8")};

constexpr Form kForms[] = {
    {"G66", kFagor, Picture::Pattern, "Repeating a contour", kG66, {}},
    {"G68", kFagor, Picture::Roughing, "Roughing along Z", kG68, {}},
    {"G69", kFagor, Picture::FaceRoughing, "Roughing along X", kG68, {}},
    {"G81", kFagor, Picture::SectionTurning, "Turning a straight section", kG81, {}},
    {"G82", kFagor, Picture::SectionFacing, "Facing a straight section", kG81, {}},
    {"G83", kFagor, Picture::DrillFace, "Drilling and tapping", kG83, {}},
    {"G84", kFagor, Picture::ArcTurning, "Turning an arc", kG84, {}},
    {"G85", kFagor, Picture::ArcFacing, "Facing an arc", kG84, {}},
    {"G86", kFagor, Picture::Thread, "Thread in several passes", kG86, {}},
    {"G87", kFagor, Picture::FaceThread, "Thread in the face", kG87, {}},
    {"G88", kFagor, Picture::Groove, "Grooving along X", kG88, {}},
    {"G89", kFagor, Picture::GrooveFace, "Grooving along Z", kG89, {}},
};

}  // namespace

std::span<const Form> fagor_forms() { return kForms; }

}  // namespace polyturn::forms
