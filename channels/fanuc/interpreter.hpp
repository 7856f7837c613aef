// The fanuc family: address words, G codes by table, custom macro B. Used for fanuc (systems A, B,
// C) and nct.
//
// One step() reads one block:
//   scan -> words   classify -> G rows, M codes   check -> every word is taken by somebody   act, in the order of GGroup
//   settings -> F -> S -> T -> M that begin -> one-shot or motion -> M that end -> calls
// A block that needs a live value stops before anything has been done: AtBarrier, then it is read
// again (architecture 5.5).
#pragma once
#include <deque>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "channels/cycles/contour.hpp"
#include "channels/cycles/drilling.hpp"
#include "channels/cycles/simple_cycles.hpp"
#include "channels/fanuc/block_index.hpp"
#include "channels/fanuc/block_words.hpp"
#include "channels/fanuc/fault_place.hpp"
#include "channels/fanuc/macro/expression.hpp"
#include "channels/fanuc/macro/jump_memory.hpp"
#include "channels/fanuc/macro/variables.hpp"
#include "channels/fanuc/modal_state.hpp"
#include "channels/fanuc/settings.hpp"
#include "channels/language.hpp"
#include "channels/state/resume_points.hpp"
#include "channels/text/byte_stream.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

// The values that its blocks leave stand in ModalState, those of the block being read in
// BlockWords.
class Interpreter : public Language,
                    private ScanHook,
                    private VariableHost,
                    private ModalState,
                    private BlockWords {
public:
    using MakeSettings = Settings (*)(const params::Table&, unsigned channel);
    Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files,
                MakeSettings make_settings);
    ~Interpreter() override;

    Result<void> start(FileId main) override;
    Step step() override;
    void barrier_done() override;
    bool preset_variable(std::string_view name, double value) override;
    Core& core() override { return core_; }
    void active_codes(std::string& out) const override;
    void list_variables(const ShowVariable& show) const override;
    void keep_resume_states(bool on) override;
    void executed(std::uint64_t serial) override;
    bool resume_at(std::uint64_t serial) override;
    bool may_resume_at(std::uint64_t serial) const override;
    bool offsets_changed() override;
    bool starts_away() const override { return settings_.nct; }
    void start_away(const AxisValues& by) override;
    bool interrupt(std::uint64_t serial, bool within, unsigned input) override;
    bool interrupt_ahead(std::uint64_t serial) override;
    void interrupt_arrived() override;
    std::any carry() const override;
    void take_carry(const std::any& before, bool after_reset) override;
    bool loses_offset(bool by_reset) const override {
        return !settings_.mefi && !settings_.keeps_offset && (by_reset || ended_by_code_);
    }
    const Settings& settings() const { return settings_; }

    // --- handlers of g_codes.cpp
    bool g_units(const GCode&);
    bool g_plane(const GCode&);
    bool g_distance(const GCode&);
    bool g_feed_mode(const GCode&);
    bool g_exact_stop(const GCode&);
    bool g_exact_once(const GCode&);
    bool g_spindle_watch(const GCode&);
    bool g_stroke_area(const GCode&);
    bool g_polygon(const GCode&);  // g_couplings.cpp
    bool g_polygon_off(const GCode&);
    bool polygon_alone();
    bool turns_polygon(unsigned place) const;
    bool g_gear(const GCode&);
    bool g_gear_off(const GCode&);
    bool gear_block() const {
        return coded_groups_ >> static_cast<unsigned>(GGroup::OneShot) & 1u &&
               coded_[static_cast<std::size_t>(GGroup::OneShot)]->tenths == 818;
    }
    bool polygon_follower(std::uint8_t& follower);
    bool g_surface(const GCode&);
    bool surface_shares_p() const;
    bool g_comp_on(const GCode&);
    bool g_comp_off(const GCode&);
    bool g_nothing(const GCode&);
    bool g_zero(const GCode&);
    bool g_zero_extended(const GCode&);
    bool g_fixture(const GCode&);
    bool g_shift(const GCode&);        // mefi
    bool g_shift_table(const GCode&);  // mefi
    bool g_rapid(const GCode&);
    bool g_linear(const GCode&);
    bool g_arc(const GCode&);
    bool g_thread(const GCode&);
    bool g_thread_variable(const GCode&);
    bool g_thread_arc(const GCode&);
    bool g_tool_direction(const GCode&);  // tool_direction.cpp
    bool g_dwell(const GCode&);
    bool g_data(const GCode&);
    bool g_reference(const GCode&);
    bool g_reference_check(const GCode&);
    bool g_local_zero(const GCode&);
    bool g_machine(const GCode&);
    bool g_preset(const GCode&);
    bool g_macro_call(const GCode&);
    bool g_macro_modal(const GCode&);
    bool g_macro_modal_off(const GCode&);
    bool g_cycle_turning(const GCode&);
    bool g_cycle_facing(const GCode&);
    bool g_cycle_thread(const GCode&);
    bool g_drilling(const GCode&);
    bool g_finishing(const GCode&);
    bool g_stock_removal(const GCode&);
    bool g_pattern(const GCode&);
    bool g_grooving(const GCode&);
    bool g_thread_passes(const GCode&);
    bool g_skip(const GCode&);
    bool g_measure(const GCode&);
    std::int32_t measured_offset() const;
    bool g_drilling_off(const GCode&);
    bool g_diameter(const GCode&);
    bool g_preset_off(const GCode&);
    bool g_binary_input(const GCode&);
    bool g_smoothing(const GCode&);
    bool g_polar(const GCode&);
    bool g_length(const GCode&);
    bool g_scale(const GCode&);
    bool g_mirror(const GCode&);
    bool g_turret_mirror(const GCode&);
    bool g_rotation(const GCode&);
    bool g_polar_plane(const GCode&);
    bool g_cylinder(const GCode&);
    bool g_b_register(const GCode&);
    bool g_b_single(const GCode&);

private:
    // reading and flow (interpreter.cpp)
    Step read_block();
    void live_value_barrier();
    void read_value_barrier();
    void check_synchronous_axes();
    Step fault(Fault fault);
    const Word* word_at_fault(Alarm alarm) const;
    Step fault_at(Alarm alarm, std::uint32_t column, std::uint32_t length, std::string detail = {},
                  double v0 = 0, double v1 = 0);
    LinePlace place_in_file(FileId file, std::uint32_t wanted, char letter);  // fault_place.cpp
    Step end_of_text();
    void finish(StopReason reason);
    void clear_modal();
    const BlockIndex& index_of(FileId file);
    std::optional<TextPlace> find_block(std::int64_t number);
    // `column` of the line in hand while it holds a further block, else the next line
    TextPlace place_behind(std::size_t column) const;
    void go_on_at(const TextPlace& place);
    std::optional<TextPosition> find_program_in(FileId file, std::int64_t number);
    bool read_line(LineSource::Status& status);
    bool jump_to(std::int64_t number);
    void go_to(const TextPlace& place);
    bool enter_program(FileId file, std::int64_t number, std::int64_t repeats,
                       const LocalSet* arguments, bool by_code, bool modal);
    void look_whether_hidden();
    bool call_levels_left(bool macro, bool modal, char letter);
    bool call_program(std::int64_t number, std::int64_t repeats, const LocalSet* arguments,
                      bool by_code, bool modal, char letter);
    bool call_block(std::int64_t number);  // M97 P
    bool return_from(bool has_target, std::int64_t target);

    // resume states (resume.cpp)
    struct ResumeState;
    struct Inherited;  // inherited.cpp
    void keep_groups(const Inherited& was);
    void note_resume_point();
    bool go_back_to(std::uint64_t serial, bool within_compensation);
    bool is_plain_move() const;
    // Everything that holds from block to block besides positions, calls and variables.
    auto modal() {
        return std::tie(motion_, active_, cycle_end_, cycle_set_, cycle_taper_, drilling_, drill_,
                        finishing_, cycle_data_, absolute_, inch_, unit_, last_m_, last_t_, last_n_,
                        parameter_input_, life_, lead_, single_block_off_, no_finish_wait_,
                        automatic_control_, parts_, program_number_, tape_begun_, blocks_begun_,
                        interrupting_, frames_of_, length_, corner_then_, polar_, polar_known_,
                        polar_radius_, polar_angle_, plane_before_);
    }

    // transformations (g_transform.cpp)
    bool switches_transformation() const;
    bool transformation_allows();
    bool transformation_alone(Alarm alarm);
    int transformation_axis(std::int64_t number, bool rotary) const;

    // one block (block.cpp)
    Step nc_block();
    bool classify();
    std::uint32_t drilling_name(std::uint32_t tenths) const;
    bool check_words();
    bool act();
    bool read_axis_words(AxisValues& target, AxisSet* named = nullptr);
    bool axis_word(const Word& word, AxisValues& target, AxisSet& named);
    struct AxisOf {
        int place;
        bool incremental;
    };
    // the axis that an axis word means, and whether it counts from the last point
    AxisOf axis_of(const Word& word) const;
    void judge_points();  // fault_place.cpp
    // mm or degrees, as the axis is programmed (not halved)
    double length(const Word& word, int place) const;
    double radius_length(char letter) const;  // I K R: mm
    double seconds(const Word& word) const;
    bool whole(char letter, std::int64_t& value);
    bool set_feed(const Word& word);
    bool is_macro_call() const;
    const GCode* g_row(unsigned k) const;  // of the k-th G word of the block
    bool macro_call();

    // interrupt macro (interrupts.cpp)
    bool interrupt_code(const Word& word);
    bool interrupt_program_has_statements(std::int64_t program);
    bool return_from_interrupt(bool has_target, std::int64_t target);
    void arm_interrupts(bool on);
    void restore_interrupted_position();
    // S, T, M (functions.cpp)
    bool spindle_word();
    bool named_spindles();
    // H alone: the offset of the length compensation that holds from power-on (N1300 G43, G44).
    bool length_word() const;
    bool tool_word();
    bool apply_tool_offsets();
    void load_nose();
    bool m_before(), m_after(), one_wait_code();
    bool is_draining(double code) const;
    bool wait_code(const Word& word);
    bool gives_arguments() const;
    const Word* stops_or_waits() const;
    bool stands_alone(const Word& stop);
    bool per_block_call();
    bool code_calls(bool& called);
    bool function_code(const Word& word, bool late);
    unsigned spindle_of_codes() const;
    const Settings::Indexing* indexing_of(double code) const;
    void note_loop(double code);
    bool can_orient(unsigned spindle);
    // Core::spindle_angle
    bool turn_spindle(unsigned spindle, double degrees, bool incremental, bool closed,
                      double rpm = 0);
    // What the program knows of a spindle's position loop: at its start nothing, unless nobody else
    // can have closed it.
    enum class SpindleLoop : std::uint8_t { Unknown, Open, Closed };
    struct TurnedSpindle {
        SpindleLoop loop = SpindleLoop::Unknown;
        double angle_deg = 0;
    };
    std::array<TurnedSpindle, kMaxSpindles + 1> turned_{};
    bool sub_call(bool external);
    std::string_view text_of(const Word& word) const {
        return line_.substr(word.column - 1u, word.length);
    }

    // frames, corners, lengths (g_frames.cpp, g_corners.cpp, g_length.cpp)
    void apply_frames();
    Point3 frame_point(bool present, std::array<bool, 3>* named);
    bool polar_target(AxisValues& target, AxisSet named);
    bool corner_allowed(char letter);
    bool corner_word(const Word& word);
    bool lathe_corner(AxisSet named);
    void note_corner(double size, bool rounding, char letter);
    bool corner_has_room(const AxisValues& target);
    bool is_at_right_angles(const CornerBefore& before, const AxisValues& target);
    bool follows_corner(const AxisValues& target, bool line);
    const Word* angle_word() const;
    bool angle_line(AxisSet named);
    bool radius_offset();
    double second_geometry(std::size_t axis, const OffsetCell& cell);
    bool offset_value_good(OffsetTable table, double shown);
    // B axis (b_axis.cpp)
    bool b_step(BStep& step, bool single);
    bool b_record();
    bool b_axis_here();
    bool b_keep();
    void recall_kept();
    bool b_run(const std::vector<BStep>& program);
    bool b_steps(const std::vector<BStep>& program, unsigned b);
    bool b_function(const BStep& step, bool line);
    bool b_start(double code);
    bool arc_words(ArcCall& call, bool& goes);
    void thread_words(ThreadCall& call);
    bool cycle_words(cycles::SimpleCycle& cycle, char taper_letter);
    Step finish_skip();
    std::string_view dwell_signal();
    // repetitive cycles (g_repetitive.cpp)
    bool read_contour(cycles::Contour& contour, ContourText& text);
    bool read_contour_blocks(cycles::ContourRecorder& recorder, Interpreter& reader,
                             ContourText& text);
    void after_contour(const ContourText& text);
    bool end_finishing();
    double shift_word(char letter, PlaneRole role) const;
    bool first_of_two() const { return !block_.has('P') && !block_.has('Q'); }
    void keep_word(std::optional<double>& kept, char letter);
    bool series15_count(char letter, double& value);
    bool turning_cycles_available(const GCode& row);
    double fine_length(char letter) const;
    bool begin_rigid_tap(cycles::Drilling& hole);
    bool tap_pitch(cycles::Drilling& hole);
    bool rigid_form(const GCode& row) const;
    bool lead_spindle(cycles::Drilling& hole);
    void bore_out(cycles::Drilling& hole);
    void fine_way(cycles::Drilling& hole);
    bool bores_back(const GCode& row);
    bool drilling_words(const GCode& row);
    bool run_drilling();
    int drilling_axis();

    // remote data (remote_data.cpp)
    Step binary_step();
    bool external_call(std::int64_t number, std::int64_t repeats);  // M198
    Step external_step();
    bool binary_block(const unsigned char* bytes, unsigned axes, bool& ends);

    // macro (macro.cpp, calls.cpp)
    double rounding_step(char address) const;
    Step macro_statement(std::size_t at);
    enum class Flow : std::uint8_t { Done, NeedsBarrier, Fault };
    Flow run_statement(const char*& at, const char* end);
    Flow assignment(const char*& at, const char* end);
    Flow name_variables(const char*& at, const char* end);
    Flow condition(const char*& at, const char* end, bool& holds);
    Flow evaluate(const char*& at, const char* end, double& value);
    Flow flow_fault(Alarm alarm, const char* at, std::string detail = {}, double value = 0.0);
    Flow flow_of(Expression::Status status);
    Flow loop_number(const char*& at, const char* end, std::uint8_t& number);
    Flow skip_loop(std::uint8_t number, const char* at);
    static std::uint8_t loop_word(std::string_view line, bool& ends);
    bool loops_nest(std::uint8_t number, std::size_t from);
    Flow print_statement(std::string_view name, const char*& at, const char* end);  // printing.cpp
    Flow print_item(bool binary, const char*& at, const char* end, std::string& text);
    // pattern_data.cpp
    bool g_pattern_data(std::int64_t kind);
    bool ends_program() const;
    bool pattern_dialogue(bool& done);
    bool go_on_with(std::int64_t number);
    bool modal_variable(std::int64_t number, double& value);
    VariableStatus value_fault(std::int64_t number, double value);
    double mirrored_axes() const;  // #3007
    std::uint32_t control_bits() const;
    void tell_control();  // #3003, #3004
    Flow jump(const char*& at, const char* end);
    bool written(std::int64_t number, double value, std::string_view comment);
    bool gather_arguments(LocalSet& arguments, std::size_t from_word);
    double argument_step(char letter) const;
    bool call_stands_first(std::size_t call);
    bool program_word(char letter, std::int64_t& program);
    bool call_count(std::int64_t& repeats);
    bool macro_words(std::int64_t& program, std::int64_t& repeats, LocalSet& arguments);
    // managed_tool.cpp
    enum class ToolRequest : std::uint8_t { Plain, OwnOffset, Group, Place };
    ToolRequest tool_request() const;  // what the T of the block asks of tool management
    bool waits_for_tool() const;       // ... whose offset is known only behind it
    bool call_managed_tool();
    bool names_managed_offset() const;  // H or D with the code of N2923
    bool managed_offset(bool radius, std::int64_t& offset);
    bool g10_offset(), g10_milling_offset(int kind), g10_zero(), g10_parameter_block();
    bool begin_life_groups(), life_group_block();  // life_groups.cpp
    void tell_life_group(const LifeGroup& group);
    bool give_parameter(const std::string& line, char letter);
    bool stroke_limits();
    void reload_settings();
    void end_one_block_shift();
    bool says_it_once();  // mefi
    bool too_many_words(const Word& word);
    void write_offset(OffsetTable table, std::int32_t number, OffsetField field, double value);
    void write_zero(std::int32_t row, unsigned place, double value);

    // ScanHook
    Read read_value(const char*& at, const char* end, double& value) override;
    bool block_skip(unsigned number) override;
    bool skip_sign_waits() override { return settings_.skip_sign_drains && !fresh_; }
    std::size_t axis_name(const char* at, const char* end, int& axis) override;
    // VariableHost
    VariableStatus read_system(std::int64_t number, double& value) override;
    VariableStatus write_system(std::int64_t number, double value) override;
    bool barrier_fresh() override;
    VariableStatus shared_variable(std::int64_t number, bool write, double& value) override;

    Core core_;
    ProgramFiles* files_;
    MakeSettings make_settings_;
    Settings settings_;
    GTable table_;
    WordScanner scanner_;
    VariableSet variables_;
    VariableNames names_;
    Expression expression_;
    Block block_;

    // the text
    std::vector<std::uint32_t> takes_;  // by row of g_codes(): letters it consumes
    std::vector<CallLevel> frames_;
    std::vector<Loop> loops_;
    // places of DO whose structure is good
    std::vector<std::pair<FileId, std::uint64_t>> checked_loops_;
    JumpMemory jumps_;                                  // ends of loops
    std::vector<std::unique_ptr<BlockIndex>> indexes_;  // by file
    std::vector<ModalCall> modal_calls_;
    LineSource* source_ = nullptr;
    std::string_view line_;
    std::size_t column_ = 0;           // next byte of line_ to read
    bool line_left_ = false;           // line_ holds a further block
    std::size_t behind_ = 0;           // and that one begins here, while the block before it acts
    bool tape_begun_ = false;          // a % was read
    bool ended_by_code_ = false;       // by M02 or M30
    bool blocks_begun_ = false;        // of the running program text
    std::int64_t program_number_ = 0;  // O of the running program

    bool only_macros_ = false;  // of an interrupt program, while the path is on its way to it
    // a length without a point has been met: the program has others with one, or was warned of
    bool points_judged_ = false;
    bool reads_contour_ = false;  // this interpreter only looks at a contour
    std::uint16_t units_code(bool inch) const {
        return static_cast<std::uint16_t>((settings_.system == kC ? 700 : 200) + (inch ? 0 : 10));
    }

    // asynchronous to the blocks
    Measuring measuring_;
    RemoteData remote_;                       // G5: blocks of binary data come
    ExternalProgram external_;                // M198: a program text comes through a socket
    std::deque<std::string> external_texts_;  // of programs that came
    BPrograms b_;
    Interruption interruption_;                 // an interrupt program runs
    std::shared_ptr<ResumeState> interrupted_;  // what held when the program was interrupted
    PatternDialogue dialogue_;
    // of the block whose T has been executed before the rest of it
    std::uint64_t managed_serial_ = 0;
    bool wants_barrier_ = false, ended_ = false, jumped_ = false, called_ = false;
    // the block is before a barrier and is read again behind it
    bool reread_ = false;
    bool fresh_ = false;  // live values are those of the barrier just passed
    // those of them that may be read while a block is held for its corner
    bool inputs_fresh_ = false;
    std::string kept_line_;
    Fault pending_fault_;
    bool has_pending_fault_ = false;
    // what the world looks like behind a barrier is a mistake
    std::optional<Fault> barrier_fault_;
    AxisSet synchronous_ = 0;  // axes that follow a master (F8311)
    ResumePoints<ResumeState> points_;
    std::uint64_t serial_ = 0;
    bool keep_states_ = false, state_changed_ = true;

    std::string message_;  // text of #3000, #3006 while it is reported

    // letters -> axes
    std::array<std::int8_t, 26> absolute_axis_{}, incremental_axis_{};
    std::uint32_t axis_letters_ = 0;
    bool hidden_ = false;  // in a program in which single block does not stop (N1756)
};

}  // namespace polyturn::channels::fanuc
