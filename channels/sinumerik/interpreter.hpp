// The language sinumerik: blocks of words and high-level statements.
//
// One step() reads one block (a line):
//   skip level, block number, labels -> statement (IF, GOTOF, DEF, CALL ...), or
//   words: every value is computed, every assignment made -> check: one G command a group, every word has a reader
//   -> act, in the order of act(): settings -> T D -> F -> S M3 M4 M5 -> M H -> procedures -> motion -> M that end -> calls
// Nothing has happened before the check. A block that needs a live value puts its assignments back and is read again behind
// the barrier (architecture 5.5).
#pragma once
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/language.hpp"
#include "channels/sinumerik/cursor.hpp"
#include "channels/sinumerik/geo_state.hpp"
#include "channels/sinumerik/settings.hpp"
#include "channels/sinumerik/tables.hpp"
#include "channels/sinumerik/text_index.hpp"
#include "channels/sinumerik/tool_table.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::channels::sinumerik {

// How a value counts: X=IC(5).
enum class Mode : std::uint8_t { Plain, AC, IC, DC, ACP, ACN, CAC, CIC, CDC, CACP, CACN, DAC, DIC, RAC, RIC, QU, PM, PR, GP };

struct Word {
    const Address* address = nullptr;
    int axis = -1;                    // place in the channel: of an axis word, or in NAME[axis]
    std::int32_t index = -1;          // numeric extension or index; -1 none
    bool spindle = false;             // the index names a spindle: S2, SPI(2)
    bool has_value = false;
    Mode mode = Mode::Plain;
    Value value;
    std::vector<Value> further;       // POSP[X]=(a, b, c)
    std::uint16_t column = 0, length = 0;   // bytes, column from 1
    double number() const { return value.number; }
};

// What a block says, gathered before anything acts.
struct Block {
    std::vector<Word> words;
    std::vector<const GCode*> codes;                       // in the order of the text
    std::array<const GCode*, kGroups> coded{};             // by group
    std::vector<std::pair<const Command*, Call>> procedures;
    struct ProgramCall {
        std::string name;
        std::vector<Argument> arguments;
        bool wanted = false;
    } program;
    bool assigns = false;             // it has assignments
    void clear() { words.clear(), codes.clear(), coded.fill(nullptr), procedures.clear(), program = {}, assigns = false; }
    const GCode* group(unsigned number) const { return coded[number]; }
};

// MCALL: called behind each block that moves.
struct ModalCall {
    std::string name;
    std::vector<Argument> arguments;
};

// Everything that holds from block to block beside positions, calls and variables: part of a resume state.
struct Modal {
    std::optional<double> inclined_deg;       // TRAANG: the angle programmed last
    std::array<std::uint8_t, kGroups> active{};   // number of the active G command of each group
    std::uint8_t motion_before = 0;
    double feed = 0.0;                // F as it holds, mm/min, mm/rev or 1/min
    double feed_per_tooth = 0.0;      // FZ; 0: F is in use
    double teeth = 0.0;               // $TC_DPNT of the active edge
    bool feed_revolution = false;     // what group 15 makes of F
    double rpm_before_surface = 0.0;  // S before G96
    std::array<std::uint8_t, kChannelAxes> axis_diameter{};   // DIAMONA and the like: as the numbers of group 29; 0: the channel's
    double path_override = 100;       // OVR, percent
    bool feed_group_set = false;      // FGROUP: F counts these axes
    AxisSet feed_group = 0;
    AxisValues feed_radius{};         // FGREF, mm; 0 as delivered
    AxisValues feed_limit{};          // FL, mm/min or deg/min; 0 none
    AxisValues axis_feed{};           // FA, mm/min or deg/min; 0 none
    std::int64_t tool_selected = -1;  // T that waits for M6; -1 none
    std::int64_t tool = 0;            // active tool
    int edge = 0;                     // active D
    std::shared_ptr<const Edge> edge_data;   // its values when it was selected
    ToolLengths toff{};               // TOFFL, TOFF, TOFFR
    bool toff_by_axis = false;
    std::array<double, 3> length_mm{};          // of the active edge, L1 to L3
    AxisValues pending_zero{}, pending_tool{};  // how far changes of zero and tool have shifted the programmed number
    std::uint16_t master_spindle = 0;
    std::map<std::uint16_t, SpindleState> spindles;   // of spindles that are not the master now
    std::optional<ModalCall> call;
    std::int64_t last_number = 0;
    GeoModal geo;
};

// A program level: main program, subprogram, or a section that REPEAT runs.
struct Level {
    FileId file = 0;
    TextPosition begin;               // first block
    std::uint64_t end = ~std::uint64_t{0};   // sections: byte behind their last line
    TextPosition call, resume;        // block of the caller, and where it goes on
    std::int64_t repeats = 0;         // runs still to come after this one
    bool section = false, block_only = false;   // REPEAT, REPEATB
    bool modal_call = false;          // called by MCALL
    bool save = false;                // PROC ... SAVE: modal state comes back
    std::string name;
    std::shared_ptr<Scope> scope;
    std::shared_ptr<const Modal> saved;
};

class Interpreter final : public Language {
public:
    Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files);
    ~Interpreter() override;

    Result<void> start(FileId main) override;
    Step step() override;
    void barrier_done() override;
    bool preset_variable(std::string_view name, double value) override;
    bool preset_text(std::string_view name, std::string_view value) override;
    bool preset_tool(int number, std::string_view name) override;
    bool preset_edge(int tool, int edge, std::string_view parameter, double value) override;
    Core& core() override { return core_; }
    void keep_resume_states(bool on) override;
    void executed(std::uint64_t serial) override;
    bool resume_at(std::uint64_t serial) override;
    bool may_resume_at(std::uint64_t serial) const override;
    bool offsets_changed() override;

    // --- what handlers need
    const Block& block() const { return block_; }
    const Word* word(std::string_view name) const;            // the last one with this name; nullptr none
    bool has(std::string_view name) const { return word(name) != nullptr; }
    const Settings& settings() const { return settings_; }
    Modal& modal() { return modal_; }
    unsigned active(unsigned group) const { return modal_.active[group]; }
    void activate(unsigned group, unsigned number);
    bool fail(Alarm alarm, std::string detail = {}, double v0 = 0.0, double v1 = 0.0) { return core_.fail(alarm, 0, std::move(detail), v0, v1); }
    bool fail_word(Alarm alarm, const Word& word, std::string detail = {}, double v0 = 0.0, double v1 = 0.0);
    bool metric_lengths() const { return active(13) == 2 || active(13) == 4; }
    double unit() const { return metric_lengths() ? 1.0 : 25.4; }             // mm in a programmed length
    double feed_unit() const { return active(13) == 3 ? 25.4 : 1.0; }         // G700
    bool absolute() const { return active(14) == 1; }
    // Is the axis counted in diameters by an absolute word (incremental: by an incremental one)?
    bool counts_diameter(unsigned place, bool incremental) const;
    // Absolute or incremental, what G90 G91 or the word's own modifier say.
    bool is_incremental(const Word& word) const;
    double length_mm(const Word& word, int place, bool incremental) const;    // true mm or degrees: unit and diameter undone
    bool axis_target(const Word& word, AxisValues& target);                   // where the axis word wants its axis
    bool read_axis_words(AxisValues& target, AxisSet& named);                 // from path.programmed
    AxisSet axis_words() const;                                               // axes with a word in this block
    int find_axis(std::string_view name) const;                               // place, kSpindleAxis + n, or -1
    std::string axis_name(int place) const;
    void zeros_change(const std::function<void()>& change);                   // keeps what SD42440 may have to travel
    void stop_reading() { wants_barrier_ = true; }                            // AtBarrier behind this block
    void report_variable(const std::string& name, const Value& value);
    bool update_feed();                                                       // Core's feed from F, FZ, FB and group 15

    // --- G commands (g_settings.cpp)
    bool g_nothing(const GCode&);
    bool g_units(const GCode&);
    bool g_plane(const GCode&);
    bool g_distance(const GCode&);
    bool g_feed_type(const GCode&);
    bool g_diameter(const GCode&);
    bool g_exact_stop(const GCode&);
    bool g_exact_once(const GCode&);
    bool g_zero(const GCode&);

    // --- geometry (geo_*.cpp)
    bool geo_motion(const GCode&);
    bool geo_arc(const GCode&);
    bool geo_cip(const GCode&);
    bool geo_ct(const GCode&);
    bool geo_thread(const GCode&);
    bool geo_barrel(const GCode&);
    bool geo_tap(const GCode&);
    bool geo_tap_chuck(const GCode&);
    bool geo_dwell(const GCode&);
    bool geo_reference(const GCode&);
    bool geo_fixed_point(const GCode&);
    bool geo_frame(const GCode&);
    bool geo_partial_shift(const GCode&);
    bool geo_limits(const GCode&);
    bool geo_pole(const GCode&);
    bool geo_compensation(const GCode&);
    bool geo_comp_option(const GCode&);
    bool geo_comp_kind(const GCode&);
    bool geo_approach(const GCode&);
    bool geo_retract(const GCode&);
    bool a_geometry(const Word&);
    bool a_without_effect(const Word&);
    bool f_ctrans(Call&);
    bool f_cfine(Call&);
    bool f_cscale(Call&);
    bool f_crot(Call&);
    bool f_cmirror(Call&);
    bool f_crpl(Call&);
    bool f_invframe(Call&);

    // --- addresses (settings_words.cpp, tools.cpp, spindles.cpp)
    bool a_feed(const Word&);
    bool a_feed_tooth(const Word&);
    bool a_override(const Word&);
    bool a_feed_radius(const Word&);
    bool a_feed_limit(const Word&);
    bool a_axis_feed(const Word&);
    bool a_axis_diameter(const Word&);
    bool a_nothing(const Word&);
    bool a_cutting_speed(const Word&);
    bool a_surface_axis(const Word&);
    bool a_limit(const Word&);
    bool a_spindle_position(const Word&);
    bool a_tool_length_offset(const Word&);
    bool a_tool_axis_offset(const Word&);
    bool a_tool_radius_offset(const Word&);

    // --- statements (statements.cpp, control.cpp, calls.cpp)
    bool st_if();
    bool st_else();
    bool st_end_marker();
    bool st_while();
    bool st_end_while();
    bool st_for();
    bool st_end_for();
    bool st_loop();
    bool st_end_loop();
    bool st_repeat();
    bool st_until();
    bool st_case();
    bool st_goto();
    bool st_def();
    bool st_redef();
    bool st_define();
    bool st_proc();
    bool st_extern();
    bool st_call();
    bool st_pcall();
    bool st_extcall();
    bool st_mcall();
    bool st_return();

    // --- commands (functions.cpp, strings.cpp, procedures.cpp, coordination.cpp)
    bool f_abs(Call&);
    bool f_sin(Call&);
    bool f_cos(Call&);
    bool f_tan(Call&);
    bool f_asin(Call&);
    bool f_acos(Call&);
    bool f_atan2(Call&);
    bool f_sqrt(Call&);
    bool f_pot(Call&);
    bool f_trunc(Call&);
    bool f_round(Call&);
    bool f_roundup(Call&);
    bool f_ln(Call&);
    bool f_exp(Call&);
    bool f_minval(Call&);
    bool f_maxval(Call&);
    bool f_bound(Call&);
    bool f_isnumber(Call&);
    bool f_number(Call&);
    bool f_toupper(Call&);
    bool f_tolower(Call&);
    bool f_strlen(Call&);
    bool f_index(Call&);
    bool f_rindex(Call&);
    bool f_mindex(Call&);
    bool f_match(Call&);
    bool f_substr(Call&);
    bool f_sprint(Call&);
    bool f_axname(Call&);
    bool f_axstring(Call&);
    bool f_isaxis(Call&);
    bool f_spi(Call&);
    bool f_axtospi(Call&);
    bool f_modaxval(Call&);
    bool f_isvar(Call&);
    bool f_getvartyp(Call&);
    bool f_stringis(Call&);
    bool f_isfile(Call&);
    bool f_gett(Call&);
    bool f_newt(Call&);
    bool f_getdno(Call&);
    bool f_calcdat(Call&);
    bool p_msg(Call&);
    bool p_setal(Call&);
    bool p_stopre(Call&);
    bool p_setms(Call&);
    bool p_wait_marker(Call&);
    bool p_wait_end(Call&);
    bool p_set_marker(Call&);
    bool p_init(Call&);
    bool p_start(Call&);
    bool p_nothing(Call&);
    bool p_fgroup(Call&);
    bool p_diamchan(Call&);
    bool p_spindle_control(Call&);
    bool p_transmit(Call&), p_tracyl(Call&), p_traang(Call&), p_tracon(Call&), p_traori(Call&), p_trafoof(Call&);   // geo_transform.cpp
    bool transformation_data(std::int64_t kind, const Call& c, std::size_t number_at, std::array<int, 3>& axes);
    bool switch_transformation(const Transformation& wanted);
    bool p_wait_axis(Call&);
    bool p_wait_spindle(Call&);
    bool p_delt(Call&);
    bool p_wrtpr(Call&);

private:
    // reading and flow (interpreter.cpp)
    Step read_block();
    Step after_block(bool ok);
    bool run_statement();
    void expand_macros();
    Step fault(Fault fault);
    Step end_of_text();
    void finish(StopReason reason);
    void reset_modal();
    bool next_line(bool& section_done);
    void live_value_barrier();
    bool need_fresh();
    bool parse_head(bool& skipped);
    bool syntax(const char* at, std::string detail = {});
    bool fail_at(Alarm alarm, const char* from, std::size_t length, std::string detail = {}, double v0 = 0.0, double v1 = 0.0);
    bool rest_must_be_empty();

    // words of a block (words.cpp, block.cpp)
    bool parse_words();
    bool parse_word();
    bool parse_letter_word(const char* begin);
    bool parse_named_word(const char* begin, std::string_view name, const Symbol& symbol);
    bool parse_system_assignment();
    bool add_g(const GCode* code, const char* begin);
    bool read_value(Word& word);
    bool read_index(Word& word, const Address& address);
    bool add_word(Word word, const char* begin);
    bool read_arguments(const Command& command, Call& call);
    bool read_program_arguments(const std::string& name, std::vector<Argument>& arguments);
    bool check_block();
    bool act();
    bool settings_and_tools();
    void motion_changes(const GCode& to);
    bool feed_word(const Word& word);
    AxisSet display_swapped() const;
    bool functions_before();
    bool motion();
    bool functions_after();
    bool positioning_axes();
    void tell_feed_path();
    const GCode* motion_code() const;
    bool takes(const GCode& code, const Address& address) const;

    // M S T D H (functions_ms.cpp, tools.cpp, spindles.cpp)
    bool m_number(const Word& word, std::int64_t& number, std::uint16_t& spindle);
    void m_to_plc(const Word& word, std::int64_t m);
    double m19_position(std::uint16_t spindle) const;
    bool tool_words();
    bool changes_tool() const;
    bool select_tool(const Word& word);
    bool change_tool();
    bool select_edge(int edge);
    void apply_tool();
    bool spindle_words();
    bool with_spindle(std::uint16_t spindle, const std::function<bool()>& act);

    // geometry (geo_*.cpp)
    std::array<std::size_t, 2> plane_places();
    bool needs_plane();
    bool driven(const std::function<bool()>& drive);
    bool corner_words(bool contour);
    bool go_line(const AxisValues& target, bool rapid);
    bool go_arc(const AxisValues& target, const ArcCall& call);
    void note_tangent(const AxisValues& from, const AxisValues& to);
    bool polar_ahead() const;
    bool polar_target(AxisValues& target);
    void complete_plane(AxisValues& target);
    bool angle_line(AxisValues target, AxisSet named, bool rapid);
    bool open_line(const Word& angle, bool rapid);
    bool second_line(const AxisValues& target, const Word& angle);
    bool full_turns(ArcCall& call);
    bool centre_words(ArcCall& call, bool& any);
    bool fit_centre(const AxisValues& target, ArcCall& call);
    bool centre_by_radius(const AxisValues& target, double radius, ArcCall& call);
    Plane arc_plane() const;
    bool arc_by_words(bool clockwise, AxisValues target, AxisSet named);
    bool arc_through(const Point3& a, const Point3& b, const Point3& c, const AxisValues& target);
    bool pitch_word(double& pitch, unsigned& axis, const Word*& said);
    double thread_start() const;
    bool barrel_arc(AxisValues& target, ArcCall& arc);
    bool within_areas(const AxisValues& target);
    bool limit_speed(const Word& word, bool high);
    Frame frame_of(const FrameValue& value) const;
    FrameValue components_of(const Frame& frame, const FrameValue& like) const;
    void use_frame();
    bool set_programmable_frame(const FrameValue& value);
    bool frame_words(const GCode& code, FrameValue& value, std::optional<Frame>& about);
    bool solid_angles(Frame& frame);
    bool f_frame(Call& call, std::string_view name);
    bool geometry_value(const std::string& name, const std::vector<Value>& indices, Value& value, bool& known);
    bool write_geometry(const std::string& name, const std::vector<Value>& indices, const Value& value, bool& known);
    static double& frame_part(FrameValue& frame, std::size_t place, const std::string& part, bool& known);
    bool update_compensation();
    bool approach_words(const GCode& code, SoftApproach& soft);
    int approach_side(const SoftApproach& soft, double tp, double tq, double op, double oq) const;
    bool approach_line(const AxisValues& to, bool rapid, double feed, std::uint8_t mode);
    bool approach_curve(const SoftApproach& soft, const AxisValues& to, int side, const std::array<double, 2>& centre, double feed, std::uint8_t mode);
    bool finish_approach(const AxisValues& target, const ArcCall* arc, bool& taken);

    // expressions (expression.cpp)
    bool expression(Value& value);
    bool binary(Value& value, unsigned level);
    bool unary(Value& value);
    bool primary(Value& value);
    bool number_constant(Value& value);
    bool quoted_constant(Value& value);
    bool string_constant(Value& value);
    bool named_value(Value& value);
    bool apply(unsigned op, const char* at, Value& left, const Value& right);
    bool chain_frames(Value& left, const Value& right);     // geo_frames.cpp
    bool number_of(const Value& value, const char* at, double& number);
    bool index_list(std::vector<Value>& indices);
    bool reference_ahead(Reference& reference);              // a variable at the cursor; null reference: none there
    bool element_of(const Variable& variable, const std::vector<Value>& indices, const char* at, std::size_t& element);
    Reference find_variable(std::string_view upper_name) const;
    bool assign(const Reference& reference, Value value, const char* at);
    bool assignment(const Reference& reference);             // behind the name: = value, = SET(...), = (..)
    void store(const Reference& reference, Value value);
    std::string reference_name(const Reference& reference) const;
    int variable_type(const std::string& text) const;
    bool is_system_variable(std::string_view name) const;

    // system variables (system_variables.cpp)
    bool system_value(Value& value);                         // at '$'
    bool system_name(std::string& name, std::vector<Value>& indices);
    bool tool_value(const std::string& name, const std::vector<Value>& indices, const char* from, std::size_t length, Value& value);
    bool edge_cell(const std::string& name, const std::vector<Value>& indices, const char* from, std::size_t length, bool make, double*& cell);
    struct DataCell {
        const params::Row* row = nullptr;   // nullptr: no machine or setting data
        std::size_t slot = 0;
    };
    bool data_cell(const std::string& name, const std::vector<Value>& indices, const char* from, std::size_t length, DataCell& cell);
    bool write_data(const DataCell& cell, const std::string& name, double value, const char* from, std::size_t length);
    struct ZeroCell {
        int number = 0;               // n of $P_UIFR[n]
        std::int32_t row = 0;
        unsigned place = 0;
        std::string part;             // TR FI RT SC MI
        double* cell = nullptr;       // as the table shows it
    };
    bool zero_cell(const std::vector<Value>& indices, const char* from, std::size_t length, ZeroCell& at);
    bool settable_value(const std::vector<Value>& indices, const char* from, std::size_t length, Value& value);
    bool write_settable(const std::vector<Value>& indices, const char* from, std::size_t length, const Value& value);
    void tell_written_zeros();
    bool channel_of(const Value& value, unsigned& channel);
    bool marker_of(const Value& value, int& marker);

    // text (jumps.cpp, calls.cpp)
    bool jump_to_label(const std::string& label, int direction, bool alarm);
    bool jump_target(std::string& label);
    const Structure* structure_needed();
    bool condition(bool& holds);
    bool for_head(Reference& variable, double& last, bool first_time);
    std::optional<TextPosition> find_label(const std::string& label, int direction);
    const TextIndex& index_of(FileId file);
    void seek(TextPosition to);
    bool call_program(const std::string& name, std::vector<Argument> arguments, std::int64_t repeats, bool modal);
    bool bind_parameters(FileId file, const std::string& name, std::vector<Argument>& arguments, Level& level);
    bool read_proc(const std::string& name, std::vector<Argument>& arguments, Level& level);
    static std::string program_of_path(std::string_view path);
    bool return_from_level();
    bool restore_modal(const Modal& saved);
    bool run_section(TextPosition from, std::uint64_t end, std::int64_t repeats, bool block_only);
    void leave_sections(std::uint64_t offset);
    std::shared_ptr<Scope> scope() const { return levels_.back().scope; }
    bool declare(const std::string& name, std::shared_ptr<Variable> variable, const char* at);
    bool parse_type(Type& type, std::size_t& length);
    void undo(std::function<void()> back);

    // resume states (resume.cpp)
    struct ResumeState;
    void note_resume_point();

    Core core_;
    ProgramFiles* files_;
    Settings settings_;
    ToolTable tools_;
    std::map<FileId, TextIndex> indices_;

    // the text
    std::vector<Level> levels_;
    LineSource* source_ = nullptr;
    TextPosition here_;               // of the block being read
    std::string line_;
    Cursor cursor_;
    Block block_;

    Modal modal_;
    std::shared_ptr<Variable> r_;
    std::map<std::string, std::string, std::less<>> macros_;
    std::map<std::string, Value, std::less<>> written_system_;   // markers and other values that a program may write

    // the block
    bool wants_barrier_ = false, ended_ = false, jumped_ = false, reread_ = false, fresh_ = true, needs_barrier_ = false;
    bool called_ = false;
    std::uint64_t moves_before_ = 0;
    std::size_t fault_column_ = 0, fault_length_ = 0;
    unsigned depth_ = 0;                                         // of nested brackets
    bool reading_ = false;                                       // words are being computed, nothing has acted
    const Statement* statement_ = nullptr;                       // behind the words of the block
    std::size_t statement_at_ = 0, program_column_ = 0;
    std::uint32_t fault_line_ = 0;
    std::vector<std::function<void()>> block_undo_;              // assignments of the block being read
    struct Written { std::string name; Value value; };
    std::vector<Written> written_;                               // told when the block acts
    struct WrittenZero { int number; std::int32_t row; unsigned place; double value; };
    std::vector<WrittenZero> written_zeros_;
    double block_feed_ = 0.0;                                    // FB
    double parts_ = 0;
    std::string message_;

    // resume
    struct Point {
        std::uint64_t serial;
        TextPosition position;
        std::shared_ptr<ResumeState> state;
        bool compensated;
    };
    std::deque<Point> points_;
    std::deque<std::pair<std::uint64_t, std::function<void()>>> undo_log_;
    std::uint64_t serial_ = 0;
    bool keep_states_ = false, state_changed_ = true;
};

}  // namespace polyturn::channels::sinumerik
