// Differences of controls in nose-radius compensation, as values. A language sets them from its
// parameters and codes; the mechanism itself never asks which control it is.
#pragma once
#include <array>
#include <cstdint>
#include <utility>

namespace polyturn::channels::compensation {

// mm: programs give three or four decimals, so that a tangential corner is one only nearly; what
// lies between its two normals then is less than a programmed point can be off.
inline constexpr double kTangentialMm = 5e-4;

// How compensation begins and ends at an outer corner. At an inner one it is always Direct.
enum class Entry : std::uint8_t {
    // straight to (from) the normal at the contour's end: fanuc type A, sinumerik NORM, fagor
    // direct
    Direct,
    Around,  // round the corner first: fanuc type B, fagor indirect
    // where the tool is behind the contour: along the tangent of the circle about the corner:
    // sinumerik KONT
    Tangent,
    // straight moves become a polynomial that is tangential to the contour: sinumerik KONTT
    Smooth,
    Curved,  // and has the curvature of its equidistant: sinumerik KONTC
};

// How the nose goes round an outer corner. Angles are those between the two elements on the
// workpiece's side.
enum class Corner : std::uint8_t {
    // intersection from 90 degrees on, below it both elements are lengthened by the radius: fanuc,
    // nct
    Extended,
    Arc,  // an arc about the corner: sinumerik G450, fagor G136
    // intersection down to `intersection_from_deg`, an arc below: sinumerik G451, fagor G137
    Intersection,
};

enum class Check : std::uint8_t {
    Off,
    // vectors that would turn an element round are left out where others remain, else an alarm
    Correct,
    Alarm,
};

// From the nose centre to the imaginary tip, as a share of the radius: first and second axis (Z, X)
// of the codes 0 to 9.
using TipTable = std::array<std::pair<double, double>, 10>;
inline constexpr TipTable kTips = {
    {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}};
// fagor_8037t part 1, 8.2.1: odd codes touch two sides, even ones one side.
inline constexpr TipTable kTipsAround = {
    {{0, 0}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};

// The block before the one that ends compensation is shorter than the nose needs in an inner
// corner: an element before it ends where it meets ... The beginning is the mirror image.
enum class ShortLast : std::uint8_t {
    None,       // treated as any other element
    TravelOut,  // ... the retract: sinumerik G460
    Circle,     // ... the circle about the last programmed point: sinumerik G461
    Line,       // ... the last element, lengthened: sinumerik G462
};

// Which speed of an arc the feed is: that of the nose's centre, or that of the point where it cuts.
enum class ArcFeed : std::uint8_t {
    Centre,
    Contour,  // sinumerik CFC
    Inner,    // at the contour of inside arcs only: sinumerik CFIN
};

// Inner corners, where more of the nose cuts: the feed is reduced from `before` to `behind` the
// corner (nct part 1 15.4, N1407 to N1410). The angle is the one between both elements on the
// nose's side.
struct CornerFeed {
    double before = 0.0, behind = 0.0;  // mm; both 0: off
    double below_deg = 0.0;             // sharper corners only
    double share = 1.0;                 // of the feed
};

struct Options {
    Entry entry = Entry::Around;
    bool leaves_direct = false;  // ends Direct at outer corners too, however it begins
    Corner corner = Corner::Extended;
    // Corner::Arc: 0 the arc, 1 the intersection, a conic between them: sinumerik DISC
    double overshoot = 0.0;
    bool closed_meets_at_start = false;  // closed_meeting_point(): sinumerik SD42496
    Check check = Check::Correct;
    double intersection_from_deg = 80.0;  // Corner::Intersection
    ShortLast short_last = ShortLast::None;
    bool looks_back = false;  // what is too short for an inner corner is left out
    // so many elements in succession at the most, the beginning and the end aside
    unsigned leaves_out = 1;
    // ShortLast: of all elements before the last one, the first that it meets: sinumerik CDON
    bool farthest_meeting = false;
    bool constant = false;  // the vector stays as it is: sinumerik CUTCONON
    // mm: corner vectors that close on both axes count as one
    double small_vector = 0.0;
    // after G53, G28: straight to the next vector instead of a new beginning (CCN)
    bool resume_at_intersection = false;
    const TipTable* tips = &kTips;
    // Corner::Extended: an arc where the elements are closer than this, tangents of arcs else
    double arc_below_deg = 0.0;
    // begins and ends also at the tool's position, in a block without movement in the plane
    bool in_place = false;
    // a change of side: at the intersection only where both paths pass it, else straight across
    bool sides_meet_on_paths = false;
    // rapid moves are not compensated; the cut before one ends the radius before its end
    bool rapid_suspends = false;
    // how many blocks beyond its neighbours the nose's path is looked for crossings
    unsigned look_back_blocks = 0;
    // behind a barrier the next element is begun at its own normal
    bool straight_after_halt = false;
    // so many blocks without movement end the held one at its normal
    unsigned idle_blocks = 2;
    bool idle_is_fault = false;  // or are an alarm
    ArcFeed arc_feed = ArcFeed::Centre;
    CornerFeed corner_feed;
    // inside arcs: feed in proportion to the radius, not below this share; < 0: as programmed
    double inner_arc_feed_from = -1.0;
};

}  // namespace polyturn::channels::compensation
