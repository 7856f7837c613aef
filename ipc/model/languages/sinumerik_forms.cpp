// Forms of the language sinumerik: threads and taps (sinumerik_part2 10.10, 10.11), which are
// words, and the drilling cycles with their patterns, which are calls
// (channels/sinumerik/tools/drilling_cycles.cpp says what their arguments mean). I and K are leads
// of X and Z, and nothing else chooses between a thread along Z and one in the face, between a hole
// in the face and one in the side: two forms of one code each.
#include "ipc/model/languages/forms.hpp"

namespace polyturn::forms {
namespace {

using U = Unit;
using M = Mark;
constexpr bool kNeeded = true, kMay = false;
constexpr double kMost = 99999.0, kMostLead = 2000.0;

// SF, DITS and DITE hold on: what is not written stays as it was (17.1), at first as the setting
// data say.
#define POLYTURN_THREAD_MORE                                                                     \
    {                                                                                            \
        "SF",          0,    U::Degrees,                                                         \
        M::StartAngle, kMay, 0,                                                                  \
        359.999,       "",   "Angle of the spindle at the start"},                               \
        {"DITS",   0,    U::Length,                                                              \
         M::RunIn, kMay, -1,                                                                     \
         kMost,    "",   "Run-in; -1: as the axis accelerates"},                                 \
    {                                                                                            \
        "DITE", 0, U::Length, M::Chamfer, kMay, -1, kMost, "", "Run-out; -1: as the axis brakes" \
    }
#define POLYTURN_THREAD_Z                                                             \
    {"X",     0,    U::Diameter,                                                      \
     M::EndX, kMay, -kMost,                                                           \
     kMost,   "",   "End point X, where the thread is tapered"},                      \
        {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-30", "End point Z"}, { \
        "K", 0, U::Lead, M::Lead, kNeeded, 0.001, kMostLead, "2", "Lead along Z"      \
    }
#define POLYTURN_THREAD_X                                                        \
    {"X", 0, U::Diameter, M::EndX, kNeeded, -kMost, kMost, "20", "End point X"}, \
        {"Z",     0,    U::Length,                                               \
         M::EndZ, kMay, -kMost,                                                  \
         kMost,   "",   "End point Z, where the thread is tapered"},             \
    {                                                                            \
        "I", 0, U::Lead, M::Lead, kNeeded, 0.001, kMostLead, "2", "Lead along X" \
    }
#define POLYTURN_LEAD_CHANGE \
    { "F", 0, U::Length, M::None, kNeeded, 0, kMostLead, "0.01", "Change of the lead a revolution" }

constexpr Field kG33Z[] = {POLYTURN_THREAD_Z, POLYTURN_THREAD_MORE};
constexpr Field kG33X[] = {POLYTURN_THREAD_X, POLYTURN_THREAD_MORE};
constexpr Field kG34Z[] = {POLYTURN_THREAD_Z, POLYTURN_LEAD_CHANGE, POLYTURN_THREAD_MORE};
constexpr Field kG34X[] = {POLYTURN_THREAD_X, POLYTURN_LEAD_CHANGE, POLYTURN_THREAD_MORE};
constexpr Field kG335[] = {
    {"X", 0, U::Diameter, M::EndX, kMay, -kMost, kMost, "", "End point X"},
    {"Z", 0, U::Length, M::EndZ, kNeeded, -kMost, kMost, "-30", "End point Z"},
    {"K", 0, U::Lead, M::Lead, kNeeded, 0.001, kMostLead, "2", "Lead along Z"},
    {"CR", 0, U::Length, M::ArcRadius, kNeeded, 0.001, kMost, "60", "Radius of the arc"},
    POLYTURN_THREAD_MORE,
};
// The speed is in a block without motion, which may change the gear (10.11.1).
#define POLYTURN_TAP_SPEED \
    { "S", 0, U::Speed, M::None, kMay, 0, kMost, "500", "Speed of the spindle" }
constexpr Field kG331Z[] = {
    POLYTURN_TAP_SPEED,
    {"Z", 1, U::Length, M::Bottom, kNeeded, -kMost, kMost, "-15", "Bottom of the hole Z"},
    {"K", 1, U::Lead, M::Lead, kNeeded, -kMostLead, kMostLead, "1.5",
     "Lead; negative: a left-hand thread"},
};
constexpr Field kG331X[] = {
    POLYTURN_TAP_SPEED,
    {"X", 1, U::Diameter, M::Bottom, kNeeded, -kMost, kMost, "20", "Bottom of the hole X"},
    {"I", 1, U::Lead, M::Lead, kNeeded, -kMostLead, kMostLead, "1.5",
     "Lead; negative: a left-hand thread"},
};
constexpr Field kG332Z[] = {
    {"Z", 0, U::Length, M::RLevel, kNeeded, -kMost, kMost, "5", "End of the way back Z"},
    {"K", 0, U::Lead, M::Lead, kNeeded, -kMostLead, kMostLead, "1.5", "Lead as on the way in"},
};
constexpr Field kG332X[] = {
    {"X", 0, U::Diameter, M::RLevel, kNeeded, -kMost, kMost, "50", "End of the way back X"},
    {"I", 0, U::Lead, M::Lead, kNeeded, -kMostLead, kMostLead, "1.5", "Lead as on the way in"},
};
constexpr Field kG63Z[] = {
    {"Z", 0, U::Length, M::Bottom, kNeeded, -kMost, kMost, "-15",
     "Bottom of the hole Z, or the end of the way back"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "", "Feed: lead times speed"},
};
constexpr Field kG63X[] = {
    {"X", 0, U::Diameter, M::Bottom, kNeeded, -kMost, kMost, "20",
     "Bottom of the hole X, or the end of the way back"},
    {"F", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "", "Feed: lead times speed"},
};

// Lengths lie along the axis that is perpendicular to the working plane: in G17, the face of a
// lathe, along Z. DPR goes before DP.
#define POLYTURN_PLANES                                                              \
    {"RTP", 0, U::Length, M::RLevel, kNeeded, -kMost, kMost, "10", "Retract plane"}, \
        {"RFP",     0,       U::Length,                                              \
         M::StartZ, kNeeded, -kMost,                                                 \
         kMost,     "0",     "Reference plane: the surface"},                        \
        {"SDIS",    0,    U::Length,                                                 \
         M::Safety, kMay, 0,                                                         \
         kMost,     "2",  "Safety distance before the surface"},                     \
        {"DP",      0,       U::Length,                                              \
         M::Bottom, kNeeded, -kMost,                                                 \
         kMost,     "-15",   "Bottom of the hole, where no depth is told",           \
         {},        0,       0,                                                      \
         "DPR"},                                                                     \
    {                                                                                \
        "DPR", 0, U::Length, M::Depth, kMay, 0.001, kMost, "",                       \
            "Depth below the surface, instead of the bottom"                         \
    }
#define POLYTURN_DWELL(preset)                                       \
    {                                                                \
        "DTB", 0, U::Seconds, M::Dwell, kMay, -kMost, kMost, preset, \
            "Dwell at the bottom; negative: revolutions"             \
    }
constexpr Field kCycle81[] = {POLYTURN_PLANES};
constexpr Field kCycle82[] = {POLYTURN_PLANES, POLYTURN_DWELL("0.5")};
constexpr Field kCycle85[] = {
    POLYTURN_PLANES,
    POLYTURN_DWELL(""),
    {"FFR", 0, U::FeedRate, M::Feed, kMay, 0.0001, kMost, "", "Feed on the way in"},
    {"RFF", 0, U::FeedRate, M::FeedBack, kMay, 0.0001, kMost, "", "Feed on the way out"},
};
// The axes of the plane: X and Y in G17, Z and X in G18, Y and Z in G19.
constexpr Field kHoles1[] = {
    {"SPCA", 0, U::Length, M::StartX, kMay, -kMost, kMost, "0",
     "Start of the line, 1st axis (X: radius)"},
    {"SPCO", 0, U::Length, M::StartZ, kMay, -kMost, kMost, "0",
     "Start of the line, 2nd axis (X: radius)"},
    {"STA1", 0, U::Degrees, M::StartAngle, kMay, -360, 360, "0",
     "Angle of the line to the 1st axis"},
    {"FDIS", 0, U::Length, M::FirstHole, kMay, -kMost, kMost, "10",
     "From the start to the first hole"},
    {"DBH", 0, U::Length, M::Step, kMay, -kMost, kMost, "8", "From hole to hole"},
    {"NUM", 0, U::Count, M::Count, kNeeded, 1, 10000, "3", "Number of holes"},
};
constexpr Field kHoles2[] = {
    {"CPA", 0, U::Length, M::CentreX, kMay, -kMost, kMost, "0",
     "Centre of the circle, 1st axis (X: radius)"},
    {"CPO", 0, U::Length, M::CentreZ, kMay, -kMost, kMost, "0",
     "Centre of the circle, 2nd axis (X: radius)"},
    {"RAD", 0, U::Length, M::ArcRadius, kNeeded, 0, kMost, "20", "Radius of the circle of holes"},
    {"STA1", 0, U::Degrees, M::StartAngle, kMay, -360, 360, "0",
     "Angle of the first hole to the 1st axis"},
    {"INDA", 0, U::Degrees, M::Step, kMay, -360, 360, "0",
     "Angle between two holes; 0: evenly spread"},
    {"NUM", 0, U::Count, M::Count, kNeeded, 1, 10000, "6", "Number of holes"},
};

constexpr Form kForms[] = {
    {"G33", kSinumerik, Picture::TurningThread, "Thread along Z, one pass", kG33Z, {}},
    {"G33", kSinumerik, Picture::FaceThread, "Thread in the face, one pass", kG33X, {}},
    {"G34", kSinumerik, Picture::TurningThread, "Thread along Z, the lead grows", kG34Z, {}},
    {"G34", kSinumerik, Picture::FaceThread, "Thread in the face, the lead grows", kG34X, {}},
    {"G35", kSinumerik, Picture::TurningThread, "Thread along Z, the lead shrinks", kG34Z, {}},
    {"G35", kSinumerik, Picture::FaceThread, "Thread in the face, the lead shrinks", kG34X, {}},
    {"G335", kSinumerik, Picture::BarrelThread, "Barrel thread on an arc, clockwise", kG335, {}},
    {"G336",
     kSinumerik,
     Picture::BarrelThread,
     "Barrel thread on an arc, counter-clockwise",
     kG335,
     {}},
    {"G331", kSinumerik, Picture::TapFace, "Rigid tapping in the face", kG331Z, "XYZIJK"},
    {"G331", kSinumerik, Picture::TapSide, "Rigid tapping in the side", kG331X, "XYZIJK"},
    {"G332", kSinumerik, Picture::TapFace, "Rigid tapping in the face, the way back", kG332Z, {}},
    {"G332", kSinumerik, Picture::TapSide, "Rigid tapping in the side, the way back", kG332X, {}},
    {"G63",
     kSinumerik,
     Picture::TapFace,
     "Tapping in the face with a compensating chuck",
     kG63Z,
     {}},
    {"G63",
     kSinumerik,
     Picture::TapSide,
     "Tapping in the side with a compensating chuck",
     kG63X,
     {}},
    {"CYCLE81",
     kSinumerik,
     Picture::DrillPlanes,
     "Drilling, centring (in G17 along Z)",
     kCycle81,
     {}},
    {"CYCLE82",
     kSinumerik,
     Picture::DrillPlanes,
     "Drilling, counterboring (in G17 along Z)",
     kCycle82,
     {}},
    {"CYCLE85", kSinumerik, Picture::ReamPlanes, "Reaming (in G17 along Z)", kCycle85, {}},
    {"MCALL CYCLE81",
     kSinumerik,
     Picture::DrillPlanes,
     "Drilling, centring behind each block that moves",
     kCycle81,
     {}},
    {"MCALL CYCLE82",
     kSinumerik,
     Picture::DrillPlanes,
     "Drilling, counterboring behind each block that moves",
     kCycle82,
     {}},
    {"MCALL CYCLE85",
     kSinumerik,
     Picture::ReamPlanes,
     "Reaming behind each block that moves",
     kCycle85,
     {}},
    {"HOLES1", kSinumerik, Picture::HoleRow, "Places of holes along a line", kHoles1, {}},
    {"HOLES2", kSinumerik, Picture::HoleCircle, "Places of holes on a circle", kHoles2, {}},
};

}  // namespace

std::span<const Form> sinumerik_forms() { return kForms; }

}  // namespace polyturn::forms
