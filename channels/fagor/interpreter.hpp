// The language fagor (8037 T): ISO blocks with G codes by table, statements in round brackets.
//
// One step() reads one block:
//   header -> words or statement   words: classify -> check that every word has a taker -> act, in
//                                  the order of GGroup
// A block that needs a live value stops before anything has been done: AtBarrier, then it is read
// again (architecture 5.5).
//
// Programmed numbers are X as the program writes it (diameter or radius); target_ is in true
// millimetres, X as a radius, before mirror and scale, which are a frame of Core.
#pragma once
#include <any>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "channels/cycles/contour.hpp"
#include "channels/fagor/grammar/expression.hpp"
#include "channels/fagor/grammar/g_codes.hpp"
#include "channels/fagor/grammar/reader.hpp"
#include "channels/fagor/grammar/values.hpp"
#include "channels/fagor/modal.hpp"
#include "channels/fagor/motion/spindle_override.hpp"
#include "channels/fagor/motion/way_counter.hpp"
#include "channels/fagor/settings.hpp"
#include "channels/language.hpp"
#include "channels/state/resume_points.hpp"

namespace polyturn::channels::fagor {

// A text that is being run: the main program, a subroutine, another program, a repeated part.
struct CallFrame {
    enum class Kind : std::uint8_t { Main, Subroutine, Program, Repeat } kind = Kind::Main;
    FileId file = 0;
    TextPosition resume;        // where the caller goes on
    std::int64_t program = -1;  // its number
    bool own_level = false;     // it has a set of local parameters
    bool modal = false;         // run for MCALL or MEXEC: no further one inside
    bool interrupt = false;
    bool maker = false;           // attribute O of its file
    std::int32_t m_code = -1;     // subroutine of this M function
    bool m_itself = false;        // the function itself follows
    bool reads_again = false;     // the calling block goes on behind it
    std::uint32_t given = 0;      // CALLP
    std::int64_t runs_left = 0;   // of a modal call with N, of RPT
    TextPosition begin;           // Repeat, and subroutines that run again
    std::uint32_t last_line = 0;  // Repeat
    AxisValues point{};           // interrupt: where the program was left, as programmed
};

class Interpreter final : public Language, private ReaderHost, private VariableHost {
public:
    Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files);
    ~Interpreter() override;

    Result<void> start(FileId main) override;
    Step step() override;
    void barrier_done() override;
    bool preset_variable(std::string_view name, double value) override;
    void preset_stored(const ToolTable& tools, const ToolEdgeTable& edges, int unit) override;
    Core& core() override { return core_; }
    void active_codes(std::string& out) const override;
    void list_variables(const ShowVariable& show) const override;
    void keep_resume_states(bool on) override;
    void executed(std::uint64_t serial) override;
    bool resume_at(std::uint64_t serial) override;
    bool may_resume_at(std::uint64_t serial) const override;
    bool offsets_changed() override;
    bool interrupt(std::uint64_t serial, bool within, unsigned input) override;
    std::any carry() const override;
    void take_carry(const std::any& before, bool after_reset) override;

    // --- handlers of g_codes.cpp
    bool g_units(const GCode&), g_x_format(const GCode&), g_plane(const GCode&),
        g_plane_of_axes(const GCode&), g_distance(const GCode&);
    bool g_feed_mode(const GCode&), g_spindle_mode(const GCode&), g_corner(const GCode&),
        g_look_ahead(const GCode&);
    bool g_mirror(const GCode&), g_mirror_axes(const GCode&), g_scale(const GCode&);
    void look_ahead(double percent, double error_mm, double square_deg);
    bool g_comp(const GCode&), g_zone_limit(const GCode&), g_zone(const GCode&);
    bool ends_reading() const;
    bool g_dwell(const GCode&), g_home(const GCode&), g_zero(const GCode&),
        g_zero_table(const GCode&), g_preset(const GCode&), g_polar_origin(const GCode&);
    bool g_linear(const GCode&), g_arc(const GCode&), g_thread(const GCode&),
        g_withdrawal(const GCode&), g_hard_stop(const GCode&);
    bool g_probe(const GCode&), g_inclined(const GCode&);
    bool g_section(const GCode&), g_drilling(const GCode&), g_threading(const GCode&),
        g_grooving(const GCode&), g_profile(const GCode&);

private:
    // reading and flow (interpreter.cpp)
    Step read_block();
    Step iso_block();
    Step end_block(bool counts, std::uint64_t ways_before);
    Step end_of_text();
    Step blank_line();
    void take_machine();
    bool inside_modal_call() const;
    void index_subroutines(FileId file);
    Step fault(Fault fault);
    Step fault_at(Alarm alarm, std::uint32_t column, std::uint32_t length, std::string detail = {},
                  double v0 = 0, double v1 = 0);
    void live_value_barrier();
    void finish(StopReason reason);
    void clear_modal();
    void show_diameter();
    bool fail_word(const Word& word, Alarm alarm, std::string detail = {}, double v0 = 0,
                   double v1 = 0);

    // calls (calls.cpp)
    std::optional<TextPosition> find_label(FileId file, std::int64_t label);
    bool find_subroutine(std::int64_t number, FileId& file, TextPosition& begin);
    std::optional<TextPosition> subroutine_in(FileId file, std::int64_t number);
    bool defined_twice(std::int64_t number, FileId known);
    std::optional<FileId> find_program(std::int64_t number);
    bool jump_to(std::int64_t label);
    bool call_subroutine(std::int64_t number, CallFrame frame, const LocalSet* arguments);
    bool call_program(std::int64_t number, CallFrame frame);
    bool push_frame(CallFrame frame);
    void pop_frame();
    bool return_from_frame();
    bool run_modal_call(std::int64_t repeats);
    bool attribute_of(FileId file, char attribute);

    // one block of words (block.cpp)
    bool classify();
    bool check_words();
    bool act();
    static std::string_view cycle_name(unsigned number);
    bool has(char letter) const { return (letters_ & letter_bit(letter)) != 0; }
    const Word* word(char letter) const;
    double number(char letter) const {
        const Word* w = word(letter);
        return w ? w->value : 0.0;
    }
    bool coded(GGroup group) const { return coded_[static_cast<std::size_t>(group)] != nullptr; }
    bool has_axes() const { return axis_word_count_ != 0; }
    bool whole(const Word& word, std::int64_t& value);
    double unit() const { return modal_.inch ? 25.4 : 1.0; }
    double length(double programmed, int place) const;  // true mm (X as a radius) or degrees
    double distance(char letter) const { return number(letter) * unit(); }
    double from_length(double true_mm, int place) const;  // as the program would write it
    double from_length_plain(double mm) const;
    bool feed_word(), spindle_word(), tool_words(), m_before(), m_after();
    bool managed() { return core_.port().tool_table() != nullptr; }  // tool management answers T
    // the T or M06 of this block is executed first; true: it was output just now
    bool asks_for_tool();
    bool take_over_change();
    void tell_tool(ToolField field, std::size_t n, double value);

    // tool, spindle, auxiliary functions (functions.cpp)
    bool change_tool(std::int64_t tool, std::int64_t offset);
    void load_tool();
    bool m_function(const Word& word, bool behind);
    bool waits(std::int32_t code);
    const MEntry* m_entry(double code) const;
    bool m_end(double code);
    bool spindle_gear(double code);
    double gear_limit() const;
    bool limit_surface_speed(bool said = false);

    // points and motion (points.cpp, g_motion.cpp)
    bool at_standstill();  // g_settings.cpp
    bool read_point(AxisValues& target, AxisSet* named);
    bool polar_point(AxisValues& target);
    bool angle_point(AxisValues& target);
    bool plane_places(unsigned& p, unsigned& q);
    void polar_origin(double& p, double& q) const;  // in the part, before mirror and scale
    void set_polar_origin(double p, double q);
    void reset_polar_origin();
    void refresh_frame();
    bool straight(const AxisValues& target, bool rapid);
    bool drive_line(const AxisValues& programmed, bool rapid);
    bool read_point_without_polar(AxisValues& target);
    void thread_travel(const AxisValues& target, double& length, double& along) const;
    int get_axis_type(unsigned place) const;
    bool only_positions(const AxisValues& target) const;
    bool has_positioning_axes(std::string_view letters) const;
    bool set_feed(const AxisValues& target);
    double largest_feed(const AxisValues& target) const;
    double largest_feed_on_arc(double from, double sweep, unsigned p, unsigned q) const;
    void follow_spindle(bool thread);
    bool arc_centre(const AxisValues& target, bool absolute, double& cp, double& cq);
    bool drive_arc(const AxisValues& programmed, double cp, double cq, bool clockwise);
    bool begin_machine_block();
    char centre_letter(unsigned place) const;
    bool tangent_arc(const AxisValues&target), three_point_arc(const AxisValues&target);
    void refresh_zero();

    // cycles (g_cycles.cpp, g_profile.cpp)
    bool cycle_needs(std::string_view letters), cycle_not_zero(std::string_view letters),
        cycle_not_negative(std::string_view letters), cycle_dwell(double&seconds);
    cycles::Point cycle_point(char abscissa, char ordinate);
    cycles::Point cycle_call_point();
    bool begin_cycle_block();
    void drop_compensation();
    bool read_profile(cycles::Contour& part, cycles::Contour& blank, bool& has_blank);
    bool record_profile(const Interpreter& caller, FileId file, TextPosition from,
                        std::uint32_t last_line, cycles::Point start,
                        cycles::ContourRecorder& recorder, cycles::Contour& part,
                        cycles::Contour& blank, bool& has_blank);
    cycles::Point caller_point(const Interpreter& caller);
    bool repeat_passes(const cycles::Contour& part, cycles::Point call, double l, double m,
                       bool square, double finishing);
    cycles::Contour close_for_tool(const cycles::Contour& part, bool facing, bool& closed);
    void close_for_nose(cycles::Contour& part, bool infeed_in_x, bool& closed);
    void keep_feed(double feed);

    // loops of a compensated contour (loop_scan.cpp)
    struct LoopPlan {
        // the block's travel in the plane; the first one of its loop decides
        bool left_out = false, first = false;
        std::optional<cycles::Point> end;  // otherwise where it ends instead
        // only the chamfer or rounding at its end is left out
        bool sharp = false;
    };
    bool scan_loops();
    compensation::Corner outer_corner() const;
    std::vector<cycles::Element> record_ahead(const Interpreter& caller,
                                              cycles::ContourRecorder& recorder, unsigned p,
                                              unsigned q, std::uint64_t& to);
    bool leave_out(AxisValues& target);
    bool ends_sharp() const;
    bool drive_left_out(const AxisValues& target, bool rapid);

    // probing, interrupts (g_probe.cpp)
    Step finish_probe();
    void touched();
    bool start_probe(std::string_view input, std::uint16_t code);
    void set_inclined(int state);
    void slide(AxisValues& target, AxisSet named) const;
    bool element_at_end(bool straight_block);
    bool end_direction(double& p, double& q) const;
    void note_direction(double p, double q);

    // statements (statements.cpp, assignments.cpp)
    Step statement_block();
    bool axes_settle(const char* at, const char* end);
    enum class Flow : std::uint8_t { Done, NeedsBarrier, Fault };
    Flow run_statement(const char*& at, const char* end, bool inside_if);
    void tell_control(bool group_ends);
    Flow assignments(const char*& at, const char* end);
    Flow evaluate(const char*& at, const char* end, double& value);
    Flow target(const char*& at, const char* end, Target& to);
    Flow assign(const Target& to, double value, const char* at);
    Flow flow_of(Expression::Status status);
    Flow flow_fault(Alarm alarm, const char* at, std::size_t length = 1, std::string detail = {},
                    double value = 0.0);
    Flow condition(const char*&at, const char*end), nothing_follows(const char*&at, const char*end);
    Flow error_statement(const char*&at, const char*end),
        message_statement(const char*&at, const char*end);
    Flow go_to(const char*&at, const char*end), repeat(const char*&at, const char*end);
    Flow call(const char*& at, const char* end, std::string_view how);
    Flow execute(const char*& at, const char* end, bool modal);
    Flow open(const char*&at, const char*end), write(const char*&at, const char*end);
    Flow reposition(const char*& at, const char* end);
    bool keep_written();
    Flow skip_definition(const char*& at, const char* end);
    Flow label_of_statement(const char*& at, const char* end, std::int64_t& label);
    Flow number_of_statement(const char*& at, const char* end, char letter, std::int64_t& number);
    bool quoted(const char*& at, const char* end, std::string& text);
    std::string with_parameters(std::string_view text, bool only_marked);

    // variables (system_variables.cpp)
    Access read(const Target& target, double& value) override;
    Access write_value(const Target& target, double value);
    Access read_named(const Target& target, double& value);
    Access write_named(const Target& target, double value);
    Access table_value(const Target& target, double& value);
    Access write_table(const Target& target, double value);
    Access read_state(const Target& target, double& value);
    Access read_coordinate(const Target& target, double& value);
    Access read_feed_or_spindle(const Target& target, double& value);
    double spindle_turns_at() const;
    Access plc_value(const Target& target, bool write, double& value);
    Access block_position(const Target& target, double& value);
    double* plc_cell(const Target& target);
    bool g_active(unsigned number) const;
    double machine_parameter(const Target& target) const;
    int place_of(char axis) const;
    Access variable_fault(Alarm alarm, std::string detail, double v0 = 0.0, double v1 = 0.0);

    // ReaderHost
    bool block_skip(unsigned number) override { return core_.port().block_skip(number); }
    std::optional<Alarm> parameter_value(std::int64_t number, double& value) override;

    // interrupt inputs (interrupts.cpp)
    void arm_interrupts();
    bool return_from_interrupt();
    void stay_where_left();

    // resume states (resume.cpp)
    struct ResumeState;
    struct Left;
    void note_resume_point();
    bool is_plain_move() const;

    SpindleOverride spindles_;  // behind the following
    TravelCounter ways_;        // between Core and the machine: the way of each axis
    Core core_;
    ProgramFiles* files_;
    Settings settings_;
    Reader reader_;
    Expression expression_;
    Values values_;
    Modal modal_;
    Block block_;
    std::vector<CallFrame> frames_;
    LineSource* source_ = nullptr;
    std::string line_storage_;
    std::string_view line_;

    // the block
    std::array<const GCode*, static_cast<std::size_t>(GGroup::Count)> coded_{};
    std::uint32_t letters_ = 0;  // of words that are not bound to a G code
    std::array<const Word*, 26> by_letter_{};
    std::array<const Word*, kChannelAxes> axis_words_{};
    unsigned axis_word_count_ = 0;
    std::array<const Word*, 7> m_words_{};
    unsigned m_count_ = 0;
    std::uint32_t mirrors_ = 0;            // G11 G12 G13 of this block: bits 1, 2, 4
    const Word* element_word_ = nullptr;   // R of G36 to G39
    const Word* number_word_ = nullptr;    // N of G41, G42, G159; K of G04
    const Word* centre_second_ = nullptr;  // second word of one centre letter (plane XU)
    std::int64_t repeats_ = -1;            // N at the end of the block
    AxisValues target_{};                  // of the part
    bool in_machine_ = false;              // G53 with motion

    TextPosition line_at_;        // of the block
    bool title_allowed_ = false;  // the line is the first of its text
    bool wants_barrier_ = false, ended_ = false, jumped_ = false, called_ = false;
    bool reread_ = false, fresh_ = false;
    // of the block whose T or M06 has been executed before the rest of it
    std::uint64_t managed_serial_ = 0;
    // an M06 has been output; its tool is known when it has been executed
    bool change_pending_ = false;
    bool probing_ = false;  // a probe move is before its barrier
    std::uint16_t probe_code_ = 75;
    // no move since: the axes stand behind the touched point by
    std::uint64_t moves_at_touch_ = 0;
    AxisValues braked_mm_{};
    std::uint64_t settled_moves_ = 0;  // no move since: the axes are quiet
    unsigned quiet_looks_ = 0, settle_looks_ = 0;
    int inclined_place_ = -1, orthogonal_place_ = -1;
    std::optional<Diagnosis> definition_fault_;  // of a SUB of the main program
    // the block in which the program was left is read again
    bool interrupt_again_ = false;
    AxisValues interrupt_begin_{};  // its start
    AxisValues interrupt_left_{};   // where the subroutine has left the axes ...
    // ... for those outside of the plane that the block read again does not name
    bool interrupt_fill_ = false;
    bool first_run_ = true;                     // FIRST
    double began_ms_ = 0.0;                     // CYTIME counts from here
    std::shared_ptr<ResumeState> interrupted_;  // what held there
    std::map<std::uint64_t, LoopPlan> loops_;   // by the serial of their blocks
    // serial of the last block that has been looked at for loops; 0 none
    std::uint64_t scanned_to_ = 0;
    // behind this block; this interpreter only looks ahead; to here
    bool scan_due_ = false, scanning_ = false, scan_over_ = false;
    bool reads_profile_ = false;  // this interpreter only looks at a profile
    std::uint32_t fault_column_ = 0, fault_length_ = 0, fault_line_ = 0;
    std::string message_;
    std::map<std::pair<FileId, std::int64_t>, TextPosition> labels_;
    std::map<std::int64_t, std::pair<FileId, TextPosition>> subroutines_;
    std::set<std::int64_t> looked_twice_;  // by defined_twice()
    // of written programs that were run: their files read them
    std::deque<std::shared_ptr<const std::string>> texts_;
    std::map<const std::string*, FileId> text_files_;
    std::array<std::int8_t, 26> place_{};  // axis letter -> place; -1 none

    ResumePoints<ResumeState> points_;
    std::uint64_t serial_ = 0;
    bool keep_states_ = false, state_changed_ = true;
};

}  // namespace polyturn::channels::fagor
