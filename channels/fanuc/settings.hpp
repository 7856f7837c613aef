// Where the controls of the fanuc family differ, as values: made from the F parameters
// (fanuc/settings.cpp) or from the N parameters (nct/settings.cpp). What parameters do not say is in
// its policy. Handlers ask these, never which control it is.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "channels/compensation/options.hpp"
#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/policy.hpp"
#include "channels/machine_view.hpp"
#include "channels/state/zero_rows.hpp"
#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::fanuc {

// How a T word names tool and offsets, and how offsets act (fanuc_lathe 1, nct part 1 15.5).
struct ToolCode {
    unsigned offset_digits = 2;          // last digits of T that are the offset number
    bool geometry_by_tool = false;       // LGN, GTN
    bool tip_from_wear = false;          // WNP; nct QGW = 0
    bool geometry_travels = false;       // LGT: geometry is travelled like wear
    bool wear_travels = true;            // fanuc; nct shifts both
    bool zero_cancels_geometry = false;  // LGC; nct ZCG
    bool with_next_move = false;         // LWM: T alone does not move
};

// G, M codes and addresses that call programs.
struct CodeCall {
    std::int32_t code = 0;  // G and M: number (G in tenths)
    std::int32_t program = 0;
    bool macro = false;      // with arguments and local variables of its own
    std::uint8_t modal = 0;  // 0 no, 1 like G66, 2 like G66.1
};

struct Settings {
    GSystem system = kA;
    Dialect dialect = Dialect::Fanuc;
    Policy policy;
    // zero that is in force at the start of a program
    std::int32_t priority_zero_row = kZeroG54Row;
    bool point_means_nothing = false;  // F3401#0: numbers without a point are whole millimetres
    bool needs_end_code = false;       // F3404#6 = 0: % is no end of a program
    bool series15 = false;             // F0001#1: program format of series 10/11/15
    ToolCode tool;
    compensation::Options compensation;
    bool centre_absolute = false;  // nct CCA
    // G4 P and X: seconds with feed per minute, revolutions with feed per revolution
    bool dwell_by_feed_mode = false;
    bool dwell_p_milliseconds = true;  // fanuc; nct: seconds
    bool power_on_g1 = false, power_on_incremental = false, power_on_inch = false,
         power_on_per_revolution = true;
    std::uint8_t power_on_plane = 1;                          // 0 G17, 1 G18, 2 G19
    double feed_per_minute = 0.0, feed_per_revolution = 0.0;  // until F; 0: F must be programmed
    double arc_tolerance = 0.02;
    unsigned sub_levels = 4, macro_levels = 4;
    std::int64_t goto_max = 99999;
    bool angle_positive = true;  // F6004#0 NAT = 0: ASIN, ATAN from 0 to 360
    bool t_calls = false;        // F6001#5: T calls O9000 with its number in #149
    // N1702, N1703: variables that programs must not write
    std::int64_t protected_first = 0, protected_last = -1;
    std::vector<CodeCall> g_calls, m_calls;
    struct LetterCall {
        char letter;
        std::int32_t program;
        std::int32_t variable;
    };
    std::vector<LetterCall> letter_calls;
    bool nested_calls = false;     // nct ENC
    struct Interrupt {             // F6003, F6033, F6034; N1758 to N1760
        double on = 96, off = 97;  // M codes; negative: none
        bool at_block_end = false, by_level = false, own_locals = true;
    } interrupt;
    // F6000#5, N1755#2 SBM: single block stops at macro statements too
    bool stops_at_macros = false;
    // N1756: single block does not stop in bit 0 O8000 to O8999, bit 1 O9000 to O9999
    unsigned hidden_programs = 0;
    bool positions_programmed = false;   // N1755#5 PCS: #5041, #5061 in the programming system
    bool positions_with_length = false;  // N1755#6 TLC = 0: with the tool's lengths
    bool managed_tools = false;          // N2900 TMU
    // N2923: this offset number is that of the tool that works; 0 none
    std::int64_t managed_offset_code = 0;
    std::int64_t place_code = 0;  // N2924: the M code with which T names a place; 0 none
    // T with an offset of nines calls a tool life group, with eights cancels the offset
    bool group_calls = false;
    bool offsets_by_g = false;     // nct N1414#0, milling channels: T is the tool alone
    bool second_geometry = false;  // nct N1414#4
    bool milling_drills = false;   // G73 G74 G76 are drilling cycles
    struct Tapping {               // N1503 to N1507
        bool orients = false, leaves_hole = false, feedforward = false,
             own_acceleration_out = false;
        double code = 0, chip_break = 0, clearance = 0, out_factor = 1, return_factor = 1;
        bool word_i = false;  // I is the extraction override
    } tapping;
    bool keeps_common = false, keeps_locals = false;  // F6001#6, #7: over a reset
    // F5003#6, N1414#5: the tool offset outlasts reset and end of program
    bool keeps_offset = false;
    // N1414#7: a rotation of the workpiece system turns the tool's lengths too
    bool offsets_turn = false;
    std::int64_t shared_100 = 0, shared_500 = 0;  // F6036, F6037; N1700, N1701
    // F6001#1 PRT, N1757#0: DPRNT without plus signs and leading blanks
    bool print_compact = false;
    bool print_parity = false;  // nct: even parity in bit 7 of what is printed
    std::string print_line_end = "\n";
    // F3104#6 DAL, #7 DAC: what absolute positions contain (Core::shows)
    bool shows_tool_vector = false, shows_nose = true;
    // ranges of M codes behind which nothing is read ahead
    std::vector<std::pair<double, double>> draining_m;
    bool drill_axis_by_plane = false;  // F5101#0
    bool peck_full = false;            // F5101#2 RTR: G83 leaves the hole between pecks
    bool r_absolute = false;           // F5102#6: R level of series 15 programs
    bool r_in_diameter = false;        // F5102#7
    double chip_break_return = 0, peck_clearance = 0;  // mm
    double bore_out_factor = 1;                        // feed of the retract of G85, G89
    bool measure_by_decimal = false;  // F3405#3: G37.1, G37.2 measure, not G36, G37
    double skip_feed = 0;             // G31: mm/min; 0: the modal feed
    double measure_feed = 0;          // likewise
    // X Y Z: mm before and around the target
    std::array<double, 3> measure_rapid{}, measure_range{};
    int measure_input = 0;  // nct: N3002
    bool measure_to_wear = false, measure_added = true;
    struct Indexing {
        unsigned spindle = 0;
        // N0820 to N0822; the angle with the sign of N0607 IDS
        double first = 0, count = 0, angle = 0;
    };
    std::vector<Indexing> indexing;           // spindles that M codes turn by angles
    double surface_speed = 0;                 // N0686: G96 until S; 0: S must be programmed
    double parts_made = 0, parts_wanted = 0;  // N2307, N2308: #3901, #3902
    double part_code = 0;                     // N2305: M code that counts a part; 0: M2 and M30
    bool s_drains = false, t_drains = false;
    bool skip_sign_drains = false;      // N1337 CBB 0: a block skip sign stops preparation
    std::uint16_t power_on_length = 0;  // N1300 G43, G44: 430 or 440; H alone is then its offset
    // N1337 REL 1: a start away from the path shifts what is incremental
    bool shifts_when_away = false;
    bool helix_in_plane = false;       // N1337 HEF 0: F of a helix counts in the plane of its arc
    std::array<bool, 3> aux_drains{};  // N1336 AU1 to AU3
    std::vector<std::pair<double, double>> m_groups;  // contradictory M codes
    std::array<char, 3> aux_letters{};                // second auxiliary functions
    // N0817 to N0819: the spindle is positioned under this address while its loop is closed
    struct SpindleAddress {
        std::string name;
        unsigned spindle = 0;
    };
    std::vector<SpindleAddress> spindle_addresses;
    std::vector<SpindleAddress> spindle_names;  // N0605, N0606: S2=3200
    unsigned locals = 33, common_first = 100, common_last = 199;
};

// Reads them from the parameters of a channel.
using MakeSettings = Settings (*)(const params::Table&, unsigned channel);

void common_settings(Settings& settings, const params::Table& table, unsigned channel);
void fanuc_axes(MachineView& view);
void fanuc_rollover(MachineView& view);
Settings fanuc_settings(const params::Table& table, unsigned channel);

}  // namespace polyturn::channels::fanuc
