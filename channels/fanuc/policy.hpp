// Where the languages of the fanuc family differ by themselves, whatever a machine's parameters say:
// one field a difference. The defaults are fanuc's; nct/settings.cpp and mefi/settings.cpp set what
// is otherwise there. No handler asks which language it is.
#pragma once
#include <cstdint>

namespace polyturn::channels::fanuc {

struct WordPolicy {                 // what words and their numbers mean
    bool increment_letters = true;  // U V W H are increments of X Y Z C
    bool comma_words = true;        // ,C ,R ,A
    bool once = false;              // an address, and a code of a group, stands once in a block
    // a code that another system of F3401 has is told with the bits that choose it
    bool systems_by_bits = true;
    bool g183_is_g83_1 = false;  // and G184, G186
    // what is computed for G, M, S and T is rounded to a whole number (fanuc_lathe 6.1)
    bool rounds_codes = true;
    bool rounds_to_increment = true;  // ROUND within an address (fanuc_lathe 6.4)
    // without a point they count ones; otherwise thousandths
    bool whole_factors = false, whole_rotation = false, whole_dwell = false,
         whole_start_angle = false;
    bool dwell_with_point = false;  // P of G4 may have one
};

struct MacroPolicy {
    bool statements = true, expressions = true, program_names = true;  // <NAME>
    bool variable_names = true;                                        // SETVN, [#NAME]
    bool short_constants = true;        // eight digits (fanuc_lathe 6.4)
    bool pattern_data = true;           // G65 H90 to H94
    bool codes_lead_calls = true;       // M codes that call macros are the first word
    bool arguments_anywhere = false;    // of a G code that calls: before it too
    bool letters_keep_theirs = false;   // #191 to #199 are written by calls of letters alone
    bool alarms_to_200 = true;          // #3000
    bool alarm_of_macro_depth = false;  // of G65 and codes too, not of G66 alone
    bool groups_of_nct = false;         // #4001 to #4022 as nct part 1 14.2 counts them
    std::int64_t last_output = 1115, last_wide_output = 1133;
    // a statement reads inputs and clocks while a block before it is held (fanuc_lathe 6.13)
    bool inputs_ahead = true;
};

struct ProgramPolicy {              // beginning, end, interruption
    bool starts_with_zero = false;  // Settings::priority_zero_row
    bool recalls = true;            // B programs and names of variables outlast power-off
    // the tool offset is in use behind an end that no code has made; a reset cancels it
    bool offset_outlasts_end = true, offset_ends = true;
    bool keeps_groups = false;     // N1301 CLR
    bool starts_away = false;      // Language::starts_away
    bool interrupts_ahead = true;  // macro statements act while the block is still driven
    bool interrupted_by_mint = false;
    bool counts_before_number = true;  // M98 P: the count precedes the four digits
    bool b_axis = true;                // G110, and M codes that start its programs
    bool life_groups = true;           // G10 L3
};

struct MotionPolicy {
    bool angle_lines = true;              // A, ,A
    bool rotary_feed = true;              // F in the plane of millimetres and degrees
    bool lathe_corners = true;            // I K C R
    bool corners_at_right_angles = true;  // with compensation (fanuc_lathe 3.16)
    bool loose_arcs = true;               // an end beside the arc under compensation
    bool arc_radius_of_any_sign = false;
    bool side_at_begin = true;     // the block behind G41, G42 keeps it (fanuc_lathe 3.9)
    bool polar_not_in_yz = false;  // G12.1 refuses G19
    // P of G30 counts the further reference positions, and is 1 where it is missing
    bool g30_counts_further = false;
    bool diameter_by_axis = false;  // G10.9 where N0106 MGD allows it
};

struct MeasuringPolicy {        // G31, G36, G37
    bool torque_by_q = false;   // Q98 R, and not P98, P99 Q
    bool decimal_codes = true;  // F3405#3: G37.1, G37.2
    bool along_y = false;
    bool input_by_number = false;  // N3002
    bool distances_of_mills = false;
    bool nose_centre = true;  // tip 0 or 9: the nose touches one radius ahead (fanuc_lathe 5.2)
};

struct CyclePolicy {  // G70 to G79, G90 to G94
    // what the first block says is for the cycle that follows alone
    bool first_block_once = false;
    bool goes_on_with_contour = false;  // behind G71 to G73, unless N1611 SKP says otherwise
    bool taper_by_centre = false;       // I, K of G90 to G94 outside of series 15
    bool first_pocket_by_n1611 = false;
    bool divisions_with_point = true;  // R0.003 of G73 are three
    bool divides_by_passes = false;
};

struct DrillingPolicy {
    bool along_plane = false;    // the axis across the plane, or the face
    bool every_cycle = false;    // whatever the program's format
    bool own_words = false;      // L, E, and I, J, K where they lead from the wall
    bool retract_word = false;   // I: percent of the feed of the retract
    bool bores_back = false;     // G87 in a milling channel
    bool r_by_distance = false;  // R is absolute as G90 says
    bool repeats_by_l = false;   // also outside of series 15
    bool pecks_by_code = false;  // G83 leaves the hole, G83.1 breaks chips
    bool rigid_by_code = false;  // G84.2, G84.3, and not M29
    bool dwells_at_r = true;
};

struct SpindlePolicy {
    bool polygon_holds_axis = true;               // F7610: it is not programmed meanwhile
    bool polygon_alone = true;                    // G50.2, G51.2 have a block of their own
    bool surface_axis_of_machine = false;         // P of G96 counts the machine's axes
    char watch_limit = 'I', foreign_limit = 'D';  // of G26
    bool watch_seconds = false;                   // P of G26
};

struct ToolPolicy {                // T, offsets, G10
    bool zero_keeps_tool = false;  // offset 0: geometry of the tool itself, unless ZCG
    bool nose_needs_offset = true;
    bool radius_by_c = true;        // C of G10 is the increment of the nose radius
    bool offsets_of_mills = false;  // G10 L10 to L13
    bool zeros_until_power_off = false;
    bool offsets_by_digits = true;  // their range; otherwise N1415
    // G10 L50
    char parameters = 'F';
    std::int64_t last_cell = 11'023;  // fanuc_lathe 7
    bool parameter_with_point = false;
    bool parameters_in_increments = true;
    bool stroke_by_n1000 = false;  // N1000 to N1009 are ends of the stroke
    bool rollover_by_f1008 = true;
};

struct Policy {
    WordPolicy words;
    MacroPolicy macro;
    ProgramPolicy program;
    MotionPolicy motion;
    MeasuringPolicy measuring;
    CyclePolicy cycles;
    DrillingPolicy drilling;
    SpindlePolicy spindles;
    ToolPolicy tools;
};

}  // namespace polyturn::channels::fanuc
