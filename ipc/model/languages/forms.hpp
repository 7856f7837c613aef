// The cycles of the languages as forms: fields with meaning, unit and range, and which part of the
// picture each of them dimensions.
//
//   G71 U2. R0.5            block 0: fields with block 0
//   G71 P100 Q200 U0.4 ...  block 1: fields with block 1
//
// A form of one block has fields of block 0 only. Of several forms of a code, the block is that
// one's of which most words stand in it (G33 with K: along Z, with I: in the face). Letters and
// codes are those of the language's own table of G codes; a test keeps them so. The fields of a
// call are its arguments in brackets, in turn: CYCLE82(10, 0, 2, -20, , 0.5).
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace polyturn::forms {

// Which programs a form is for. The fanuc family: code systems A, B and C, each in the own and in
// the series 15 format (F0001#1).
enum Speaks : std::uint16_t {
    kFanucA = 1,
    kFanucB = 2,
    kSeries15A = 4,
    kSeries15B = 8,
    kNct = 16,
    kFagor = 32,
    kFanucC = 64,
    kSeries15C = 128,
    kSinumerik = 256
};
inline constexpr std::uint16_t kFanucAB = kFanucA | kFanucB, kSeries15AB = kSeries15A | kSeries15B;
inline constexpr std::uint16_t kNative = kFanucAB | kFanucC, kSeries15 = kSeries15AB | kSeries15C;

enum class Unit : std::uint8_t {
    Length,    // mm (or inches, as the program counts) along an axis, or of no axis (radius)
    Diameter,  // mm, a coordinate of X: a diameter while the channel counts X so
    // mm; the family writes it as a whole number of least increments: P1500 is 1.5 mm
    Fine,
    Degrees,     // a plain number
    Rotary,      // degrees of an axis
    Thousandth,  // degrees; written in thousandths without a point: Q90000
    Milliseconds,
    Hundredths,
    Seconds,   // Hundredths: of a second
    FeedRate,  // as G94, G95 say
    Lead,      // mm a revolution
    Tenths,    // of the lead
    Speed,     // of the spindle, 1/min
    Count,
    Label,
    Choice,
    Plain,
};

// What of the picture a field dimensions.
enum class Mark : std::uint8_t {
    None,
    StartX,
    StartZ,
    EndX,
    EndZ,
    Depth,
    Retract,
    AllowanceX,
    AllowanceZ,
    ReliefX,
    ReliefZ,
    Count,
    Contour,
    Peck,
    Step,
    Aside,
    Taper,
    Lead,
    Chamfer,
    ToolAngle,
    ThreadDepth,
    FirstPass,
    LeastPass,
    StartAngle,
    RLevel,
    Bottom,
    Dwell,
    Feed,
    FinishFeed,
    Safety,
    CentreX,
    CentreZ,
    Place,
    RunIn,
    ArcRadius,
    FeedBack,
    FirstHole,
};

enum class Picture : std::uint8_t {
    Roughing,
    FaceRoughing,
    Pattern,
    Finishing,
    PeckFace,
    Groove,
    GrooveFace,
    Thread,
    FaceThread,
    Turning,
    Facing,
    TurningThread,
    DrillFace,
    DrillSide,
    TapFace,
    TapSide,
    BoreFace,
    BoreSide,
    SectionTurning,
    SectionFacing,
    ArcTurning,
    ArcFacing,
    BarrelThread,
    DrillPlanes,
    ReamPlanes,
    HoleRow,
    HoleCircle,
};

inline constexpr double kAny = std::numeric_limits<double>::max();

struct Field {
    // of its word: a letter, in sinumerik a name too ("SF"); of an argument: how it is called
    std::string_view address;
    std::uint8_t block;  // 0 or 1
    Unit unit;
    Mark mark;
    bool needed;
    double low, high;
    std::string_view preset;   // what a new form proposes; empty: nothing
    std::string_view meaning;  // English; the HMI's languages have it too
    // address of the same thing as a distance from the tool's position (U beside X)
    std::string_view increment = {};
    // a part of a word: P021060 of G76 is three fields of two digits
    std::uint8_t digit = 0, digits = 0;
    std::string_view unless = {};  // address of what makes it unneeded (DPR beside DP)
    bool whole() const {
        return unit == Unit::Count || unit == Unit::Label || unit == Unit::Choice ||
               unit == Unit::Milliseconds || unit == Unit::Hundredths || digits != 0;
    }
};

struct Form {
    std::string_view code;  // "G71", "CYCLE82", "MCALL CYCLE82"
    std::uint16_t speaks;   // Speaks
    Picture picture;
    std::string_view title;  // English; translated
    std::span<const Field> fields;
    // of two blocks: letters that only the second one has; empty: one block
    std::string_view second;
    bool two_blocks() const { return !second.empty(); }
    bool is_call() const { return code.find_first_of("0123456789") > 1; }  // more than a letter
};

std::span<const Form> fanuc_forms();
std::span<const Form> fagor_forms();
std::span<const Form> sinumerik_forms();

// What a channel's programs are written in: which forms it has and how numbers are written.
struct Dialect {
    std::uint16_t speaks = 0;   // one of Speaks; 0: this language has no cycles
    bool point_needed = false;  // X40 is 40 least increments, X40. is 40 mm
    double increment = 0.001;   // the least one, mm or inches
    // lengths are inches where the cycle is: every number is as it is written
    bool inch = false;
    // one decimal more
    void count_inches() {
        inch = true;
        increment *= 0.1;
    }
};
// system: of the fanuc codes, 'A', 'B' or 'C'.
Dialect dialect_of(std::string_view language, char system, bool series15, bool point_means_nothing,
                   double increment);

// In the order of the table.
template <class Visit>
void each_form(const Dialect& dialect, Visit visit) {
    for (const Form& form : dialect.speaks == kFagor       ? fagor_forms()
                            : dialect.speaks == kSinumerik ? sinumerik_forms()
                                                           : fanuc_forms())
        if (form.speaks & dialect.speaks) visit(form);
}

}  // namespace polyturn::forms
