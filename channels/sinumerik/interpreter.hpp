// The language sinumerik: blocks of words and high-level statements.
//
// One step() reads one block (a line):
//   skip level, block number, labels -> statement (IF, GOTOF, DEF, CALL ...), or words: every value
//   is computed, every assignment made -> check: one G command a group, every word has a reader ->
//   act, in the order of act(): settings -> T D -> F -> S M3 M4 M5 -> M H -> procedures -> motion
//   -> M that end -> calls
// Nothing has happened before the check. A block that needs a live value puts its assignments back
// and is read again behind the barrier (architecture 5.5).
#pragma once
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/language.hpp"
#include "channels/sinumerik/flow/synchronized.hpp"
#include "channels/sinumerik/grammar/block.hpp"
#include "channels/sinumerik/grammar/cursor.hpp"
#include "channels/sinumerik/grammar/text_index.hpp"
#include "channels/sinumerik/modal.hpp"
#include "channels/sinumerik/variables/settings.hpp"
#include "channels/state/resume_points.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::channels::cycles {
struct Drilling;
}

namespace polyturn::channels::sinumerik {

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
    void preset_stored(const polyturn::ToolTable& tools, const polyturn::ToolEdgeTable& edges,
                       int unit) override;
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

    // --- what handlers need
    const Block& block() const { return block_; }
    // the last one with this name; nullptr none
    const Word* word(std::string_view name) const;
    bool has(std::string_view name) const { return word(name) != nullptr; }
    const Settings& settings() const { return settings_; }
    Modal& modal() { return modal_; }
    unsigned active(unsigned group) const { return modal_.active[group]; }
    void activate(unsigned group, unsigned number);
    bool fail(Alarm alarm, std::string detail = {}, double v0 = 0.0, double v1 = 0.0) {
        return core_.fail(alarm, 0, std::move(detail), v0, v1);
    }
    bool fail_word(Alarm alarm, const Word& word, std::string detail = {}, double v0 = 0.0,
                   double v1 = 0.0);
    bool metric_lengths() const { return active(13) == 2 || active(13) == 4; }
    // mm in a programmed length
    double unit() const { return metric_lengths() ? 1.0 : 25.4; }
    // G700 and G710 say what feeds and other technology count in; under G70 and G71 that is the
    // basic system (sinumerik_part1 9.3.5).
    bool metric_technology() const {
        return active(13) == 4 || (active(13) != 3 && settings_.metric_base);
    }
    double feed_unit() const { return metric_technology() ? 1.0 : 25.4; }
    bool absolute() const { return active(14) == 1; }
    // Is the axis counted in diameters by an absolute word (incremental: by an incremental one)?
    bool counts_diameter(unsigned place, bool incremental) const;
    // Absolute or incremental, what G90 G91 or the word's own modifier say.
    bool is_incremental(const Word& word) const;
    // true mm or degrees: unit and diameter undone
    double length_mm(const Word& word, int place, bool incremental) const;
    // where the axis word wants its axis
    bool axis_target(const Word& word, AxisValues& target);
    bool has_axis(const Word& word);  // it is not released
    bool take_back_released_axes();
    // from path.programmed
    bool read_axis_words(AxisValues& target, AxisSet& named);
    // an axis word or one of POS
    static bool names_moved_axis(const Word& word);
    // axes with a word in this block
    AxisSet axis_words() const;
    // place, kSpindleAxis + n, or -1
    int find_axis(std::string_view name) const;
    std::string axis_name(int place) const;
    // keeps what SD42440 may have to travel
    void zeros_change(const std::function<void()>& change);
    // warns, once a program
    bool without_effect(std::string name, std::size_t column, std::size_t length);
    void tell_single_block();
    // each argument is an axis
    bool axes_only(const Call& c);
    // AtBarrier behind this block
    void stop_reading() { wants_barrier_ = true; }
    void report_variable(const std::string& name, const Value& value);
    // Core's feed from F, FZ, FB and group 15
    bool update_feed();

    // --- G commands (g_settings.cpp)
    // what becomes of a word: rows_g.cpp
    bool g_mode(const GCode&), g_as_machine(const GCode&), g_as_continuous(const GCode&),
        g_without_effect(const GCode&);
    bool g_units(const GCode&), g_plane(const GCode&), g_distance(const GCode&);
    bool g_feed_type(const GCode&), g_diameter(const GCode&), g_exact_stop(const GCode&),
        g_exact_once(const GCode&);
    bool g_zero(const GCode&);

    // --- geometry (geo_*.cpp)
    bool geo_motion(const GCode&), geo_arc(const GCode&), geo_cip(const GCode&),
        geo_ct(const GCode&), geo_thread(const GCode&);
    bool geo_barrel(const GCode&), geo_tap(const GCode&), geo_tap_chuck(const GCode&),
        geo_dwell(const GCode&);
    bool geo_reference(const GCode&), geo_fixed_point(const GCode&), geo_frame(const GCode&),
        geo_partial_shift(const GCode&);
    bool geo_limits(const GCode&), geo_pole(const GCode&), geo_compensation(const GCode&),
        geo_comp_option(const GCode&);
    bool geo_comp_kind(const GCode&), geo_approach(const GCode&), geo_retract(const GCode&);
    bool a_geometry(const Word&), a_without_effect(const Word&);
    bool f_ctrans(Call&), f_cfine(Call&), f_cscale(Call&), f_crot(Call&), f_cmirror(Call&),
        f_crpl(Call&), f_invframe(Call&), f_meaframe(Call&);

    // --- addresses (settings_words.cpp, tools.cpp, spindles.cpp)
    bool a_feed(const Word&), a_feed_tooth(const Word&), a_override(const Word&),
        a_feed_radius(const Word&);
    bool a_feed_limit(const Word&), a_axis_feed(const Word&), a_axis_diameter(const Word&),
        a_elsewhere(const Word&), a_as_machine(const Word&), a_rounding(const Word&),
        a_no_holder(const Word&);
    bool a_cutting_speed(const Word&), a_surface_axis(const Word&), a_limit(const Word&),
        a_spindle_position(const Word&);
    double spindle_feed_rpm(std::uint16_t spindle) const;
    bool a_fixed_stop(const Word&), a_stop_torque(const Word&), a_stop_window(const Word&);
    bool a_tool_length_offset(const Word&), a_tool_axis_offset(const Word&),
        a_tool_radius_offset(const Word&);

    // --- statements (statements.cpp, control.cpp, calls.cpp)
    bool st_if(), st_else(), st_end_marker(), st_while(), st_end_while(), st_for(), st_end_for(),
        st_loop(), st_end_loop();
    bool st_repeat(), st_until(), st_case(), st_goto(), st_def(), st_redef(), st_define(),
        st_proc(), st_extern(), st_call();
    bool st_pcall(), st_extcall(), st_mcall(), st_return();

    // --- commands (functions.cpp, strings.cpp, procedures.cpp, coordination.cpp)
    bool f_abs(Call&), f_sin(Call&), f_cos(Call&), f_tan(Call&), f_asin(Call&), f_acos(Call&),
        f_atan2(Call&), f_sqrt(Call&);
    bool f_pot(Call&), f_trunc(Call&), f_round(Call&), f_roundup(Call&), f_ln(Call&), f_exp(Call&),
        f_minval(Call&);
    bool f_maxval(Call&), f_bound(Call&), f_isnumber(Call&), f_number(Call&), f_toupper(Call&),
        f_tolower(Call&);
    bool f_strlen(Call&), f_index(Call&), f_rindex(Call&), f_mindex(Call&), f_match(Call&),
        f_substr(Call&), f_sprint(Call&);
    bool f_axname(Call&), f_axstring(Call&), f_isaxis(Call&), f_spi(Call&), f_axtospi(Call&),
        f_modaxval(Call&), f_isvar(Call&);
    bool f_toolenv(Call&), f_gettenv(Call&), f_deltoolenv(Call&);  // tool_environments.cpp
    // tool_functions.cpp
    bool f_gett(Call&), f_newt(Call&), p_delt(Call&), f_getdno(Call&), f_setdno(Call&),
        p_dzero(Call&), f_chkdno(Call&), f_chkdm(Call&), f_getacttd(Call&);
    bool f_getactt(Call&), f_toolgnt(Call&), f_toolgt(Call&), f_deldl(Call&), f_lentoax(Call&),
        p_tca(Call&), p_tml(Call&), call_tool(std::int64_t number, ToolCallBy by);
    std::vector<std::int64_t> tools_named(const std::string& name) const;  // by duplo
    std::int64_t tool_named(const Call& call, std::size_t duplo) const;
    // curve_table_commands.cpp
    enum class CurveFigure : std::uint8_t { Used, Free, Most };
    bool curve_point(const AxisValues&target),
        curve_sample(Call&c, std::size_t slope, const CurveTable::Sample&sample, double value),
        curve_extreme(Call&c, bool largest);
    bool curve_memory(Call&c, CurveFigure figure, double (*used)(const CurveTables&, bool),
                      double most),
        curve_fact(Call&c, const std::function<double(const CurveTable&)>&fact);
    const CurveTable* curve_table(const Call& c, std::size_t i);
    bool p_ctabdef(Call&), p_ctabend(Call&), p_ctab_each(Call&), f_ctab(Call&), f_ctabinv(Call&),
        f_ctabssv(Call&), f_ctabsev(Call&), f_ctabtsv(Call&), f_ctabtsp(Call&);
    bool f_ctabtev(Call&), f_ctabtep(Call&), f_ctabtmin(Call&), f_ctabtmax(Call&),
        f_ctabexists(Call&), f_ctabislock(Call&), f_ctabmemtyp(Call&), f_ctabperiod(Call&);
    bool f_ctabsegid(Call&), f_ctabpolid(Call&), f_ctabid(Call&), f_ctabno(Call&),
        f_ctabnomem(Call&), f_ctabfno(Call&), f_ctabseg(Call&), f_ctabfseg(Call&),
        f_ctabmseg(Call&);
    bool f_ctabpol(Call&), f_ctabfpol(Call&), f_ctabmpol(Call&);
    // 0: no edge has this D number
    static int edge_of_d(const Tool& tool, int d);
    // variable_facts.cpp
    bool f_getvarlim(Call&), f_getvardft(Call&), f_getvarphu(Call&), f_getvarap(Call&);
    bool f_getvartyp(Call&), f_stringis(Call&), f_isfile(Call&), f_calcdat(Call&),
        f_calcposi(Call&);
    bool p_preset(Call&), p_geometry_axes(Call&), p_soft_axes(Call&),
        p_profile_without_effect(Call&), p_single_block(Call&), p_overlay_off(Call&),
        p_axis_exchange(Call&);
    bool p_tool_of_spindle(Call&), p_lift_axes(Call&), p_feed_per_revolution(Call&),
        p_axis_per_revolution(Call&);
    bool f_crots(Call&), f_addframe(Call&);
    bool a_lift_position(const Word&), a_handwheel_feed(const Word&), a_axis_share(const Word&),
        a_thread_ramp(const Word&);
    bool geo_involute(const GCode&), g_grinding(const GCode&), g_tool_frame(const GCode&),
        geo_not_built(const GCode&);
    bool st_execstring(), st_setint(), st_synchronized();
    // files.cpp
    bool p_write(Call&), p_read(Call&), p_delete(Call&), p_file_size(Call&), p_file_facts(Call&);
    // synchronized.cpp
    bool p_cancel(Call&), p_lock(Call&), p_unlock(Call&), p_action_reset(Call&),
        p_stop_reading_of(Call&), p_cycle_steps(Call&), p_read_disable(Call&),
        p_delete_travel(Call&);
    bool p_interrupts(Call&), p_without_effect(Call&), p_trail(Call&), p_wheel_speed(Call&),
        a_sum_offset(const Word&);
    bool told_when(const Call& c, std::string_view name);
    bool p_msg(Call&), p_setal(Call&), p_stopre(Call&), p_setms(Call&), p_master_holder(Call&),
        p_wait_marker(Call&), p_wait_end(Call&);
    bool p_init(Call&), p_start(Call&);     // program_start.cpp
    bool p_fctdef(Call&), p_synfct(Call&);  // polynomials.cpp
    bool p_swivel(Call&), p_axis_to_channel(Call&), p_tangential(Call&);
    bool p_gear_define(Call&), p_gear_on(Call&), p_gear_off(Call&);
    // drilling_cycles.cpp
    bool p_cycle81(Call&), p_cycle82(Call&), p_cycle85(Call&), p_holes(Call&);
    bool p_set_marker(Call&), p_as_machine(Call&), p_fgroup(Call&), p_diamchan(Call&);
    bool p_reset_monitoring(Call& c);
    bool p_spindle_control(Call&), p_spindle_speed(Call&), p_wait_axis(Call&),
        p_wait_spindle(Call&), p_wrtpr(Call&);
    // geo_transform.cpp
    bool p_transmit(Call&), p_tracyl(Call&), p_traang(Call&), p_trafoof(Call&);
    bool p_coupling(Call&), f_posrange(Call&);  // couplings.cpp
    bool spindle_pair(const Call& c, std::uint16_t& follows, std::uint16_t& leads);
    bool keeps_turning(std::uint16_t follows);
    SpindleRatio configured_ratio(std::uint16_t follows, std::uint16_t leads);
    bool transformation_data(std::int64_t kind, const Call& c, std::size_t number_at,
                             std::array<int, 3>& axes);
    bool switch_transformation(const Transformation& wanted);

private:
    // reading and flow (interpreter.cpp)
    Step read_block();
    bool read_line();
    bool does_anything() const;
    Step after_block(bool ok);
    bool run_statement();
    void expand_macros();
    Step fault(Fault fault);
    Step end_of_text();
    void finish(StopReason reason);
    void reset_modal();
    std::optional<Diagnosis> reset_value_fault() const;
    bool next_line(bool& section_done);
    void live_value_barrier();
    bool need_fresh();
    bool parse_head(bool& skipped);
    bool syntax(const char* at, std::string detail = {});
    bool fail_at(Alarm alarm, const char* from, std::size_t length, std::string detail = {},
                 double v0 = 0.0, double v1 = 0.0);
    bool rest_must_be_empty();

    // words of a block (words.cpp, block.cpp)
    static bool names_cycle(std::string_view upper_name);
    bool parse_words();
    bool parse_word();
    bool parse_letter_word(const char* begin);
    bool parse_named_word(const char* begin, std::string_view name, const Symbol& symbol);
    bool parse_system_assignment();
    bool write_system(const std::string& name, const std::vector<Value>& indices, Value value,
                      const char* from, std::size_t length, const char* at);
    bool add_g(const GCode* code, const char* begin);
    bool turns_about_y() const;
    bool to_interpolation_parameter(Word& word) const;
    bool read_value(Word& word);
    bool read_index(Word& word, const Address& address);
    bool add_word(Word word, const char* begin);
    bool read_arguments(const Command& command, Call& call);
    bool read_program_arguments(const std::string& name, std::vector<Argument>& arguments);
    bool check_block();
    bool act();
    bool settings_and_tools();
    bool motion_changes(const GCode& to);
    bool feed_word(const Word& word);
    AxisSet display_swapped() const;
    bool functions_before();
    bool motion();
    bool functions_after();
    // FXS = 1: the drive holds its axis at the stop, or shall on the way there
    AxisSet stops_on_ = 0;
    AxisSet stops_wanted_ = 0;  // by this block
    bool begin_stops();
    bool start_positioning(AxisSet& wait);
    bool position_in_parts();
    bool position_axis(const Word&);
    bool drive_positioning_axis(std::size_t place, const AxisValues& target);
    bool drive_in_parts(const Word& word, AxisValues target);
    bool feed_source(const Argument& argument, std::uint16_t& spindle);
    bool axis_argument(Call& call, std::size_t k, std::string_view name, std::size_t& place);
    void set_feed_path();
    const GCode* motion_code() const;
    bool takes(const GCode& code, const Address& address) const;

    // M S T D H (functions_ms.cpp, tools.cpp, spindles.cpp)
    bool m_number(const Word& word, std::int64_t& number, std::uint16_t& spindle);
    void m_to_plc(const Word& word, std::int64_t m);
    double speed_of_tool(double m_min, double radius_mm, double most) const;
    bool refresh_cutting_speeds();
    double m19_position(std::uint16_t spindle) const;
    // G96 G961 G962
    bool surface_speed_active() const {
        return active(15) == 4 || active(15) == 7 || active(15) == 11;
    }
    // of the spindle that is meant (speed_limits.cpp)
    double spindle_data(std::string_view name) const;
    double highest_speed() const;
    double limited_speed(double rpm) const;
    bool ask_speed(double rpm);
    bool refresh_speed_limit(bool said = false);
    bool refresh_speed(bool said = false);
    void keep_axis_data(std::string_view name, std::size_t place, double value);
    void keep_spindle_data(std::string_view name, double value);
    bool tool_words();
    bool changes_tool() const;
    bool select_tool(const Word& word);
    // managed_tools.cpp
    bool managed();  // tool management answers T
    // the T or tool change of this block has been executed; false: it is read again behind it
    bool managed_tool();
    bool monitoring(const std::string& name, const std::vector<Value>& indices, const char* from,
                    std::size_t length, std::string& field, double& value);
    void tell_tool(const std::string& name, const Value& value);
    bool write_monitoring(const std::string& name, const std::vector<Value>& indices,
                          const char* from, std::size_t length, const Value& value);

    bool change_tool();
    bool select_edge(int edge);
    void apply_tool();
    std::array<int, 3> axes_of_lengths() const;
    bool spindle_words();
    bool spindle_share(const Word& word, double share);
    bool spindle_closed(std::uint16_t spindle) const {
        return modal_.closed_spindles >> (spindle - 1) & 1u;
    }
    // position control, by the PLC's M19
    void close_spindle(bool told, bool beside = false);
    // this block names an axis on such a spindle
    bool spindles_to_axes();
    void spindle_to_axis();
    bool with_spindle(std::uint16_t spindle, const std::function<bool()>& act);

    // geometry (geo_*.cpp)
    std::array<std::size_t, 2> plane_places();
    bool needs_plane();
    bool driven(const std::function<bool()>& drive);
    bool corner_words(bool contour);
    AxisValues trailed(AxisValues target) const;  // TRAILON
    bool leads_nobody(const AxisValues& target);
    const Trail* leads(const AxisValues& target) const;
    bool leads_itself(std::size_t follows, std::size_t leads) const;
    bool gear_is_on(std::size_t follows) const;
    double from_said(std::size_t place, double value) const;
    bool turn_to_tangent(const AxisValues& direction);
    bool tangential_line(AxisValues&target), tangential_arc(AxisValues&target, const ArcCall&call);
    bool bends_on_the_way(const AxisValues& wanted, std::vector<AxisValues>& bends);  // LEADON
    double shown_by_table(std::size_t place, double mm) const;
    bool is_coupled(int table) const;
    bool go_line(const AxisValues& target, bool rapid);
    bool go_arc(const AxisValues& target, const ArcCall& call);
    bool measuring_line(const AxisValues& target, const Word& probe, bool passes);
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
    bool go_curve(const AxisValues& target, const std::vector<AxisValues>& between,
                  const Point3& tangent);
    bool oblique_circle(const Point3& a, const Point3& b, const Point3& c, const AxisValues& target,
                        std::int32_t turns);
    // an arc of the plane is one of the machine too
    bool frame_keeps_circles() const;
    bool arc_lies_inclined() const;
    bool drawn_arc(const AxisValues& target, const ArcCall& call);
    std::size_t geometry_index(std::size_t place);  // 0 X, 1 Y, 2 Z
    bool arc_through(const Point3& a, const Point3& b, const Point3& c, const AxisValues& target);
    bool pitch_word(double& pitch, unsigned& axis, const Word*& said);
    double thread_start() const;
    bool travel_out(ThreadCall& call, const AxisValues& target);  // of a held thread: LFON
    using LeaveBy = std::function<void(std::size_t place, double by)>;
    void lift_to_positions(const LeaveBy& leave) const;  // LFPOS
    // LFTXT: of a thread, of an interrupted contour
    enum class LiftSide : std::uint8_t { AgainstInfeed, FromEdge };
    // LFWP, LFTXT
    bool lift_in_plane(std::size_t along, double on, LiftSide side, const LeaveBy& leave);
    double away_from_edge(std::size_t across) const;
    bool barrel_arc(AxisValues& target, ArcCall& arc);
    struct AreaFault {
        unsigned axis = 0;
        double value = 0.0, limit = 0.0;
        bool upper = false;
    };
    std::optional<AreaFault> area_fault(const AxisValues& target, const AxisValues& distance,
                                        double slack);
    bool within_areas(const AxisValues& target);
    // travel_limits.cpp
    int violated_limit(const AxisValues& point, const AxisValues& distance, unsigned kinds,
                       double slack);
    bool arc_within_areas(const AxisValues& target, const ArcCall& call);
    bool limit_speed(const Word& word, bool high);
    Frame frame_of(const FrameValue& value) const;
    FrameValue components_of(const Frame& frame, const FrameValue& like) const;
    void use_frame();
    // frames around it (settable_frames.cpp)
    Frame outer_frame() const;
    AxisValues programmable(const AxisValues& target) const;  // the point in the settable system
    void choose_settable(int number, std::int32_t row);
    FrameValue settable_frame(int number);
    bool set_settable_frame(int number, const FrameValue& value);
    bool names_settable(const std::string& text, int& number) const;
    bool add_to_settable(int number, const Frame& added);
    bool frame_number(const std::string& name, const std::vector<Value>& indices, int most,
                      int& number);
    bool component_named(const std::string& name, const std::vector<Value>& indices,
                         std::size_t first, std::size_t& place, std::string& part);
    bool frame_component(const std::string& name, const FrameValue& frame,
                         const std::vector<Value>& indices, std::size_t first, Value& value);
    bool change_frame_component(const std::string& name, FrameValue& frame,
                                const std::vector<Value>& indices, std::size_t first,
                                const Value& value);
    bool outer_frame_value(const std::string& name, const std::vector<Value>& indices, Value& value,
                           bool& known);
    bool write_outer_frame(const std::string& name, const std::vector<Value>& indices,
                           const Value& value, bool& known);
    bool set_programmable_frame(const FrameValue& value);
    bool frame_words(const GCode& code, FrameValue& value, std::optional<Frame>& about);
    bool solid_angles(Frame& frame);
    bool solid_angles(const std::array<std::optional<double>, 3>& of, Frame& frame);
    void mirror_by_reference(FrameValue& said) const;
    bool f_frame(Call& call, std::string_view name);
    bool geometry_value(const std::string& name, const std::vector<Value>& indices, Value& value,
                        bool& known);
    bool write_geometry(const std::string& name, const std::vector<Value>& indices,
                        const Value& value, bool& known);
    static double& frame_part(FrameValue& frame, std::size_t place, const std::string& part,
                              bool& known);
    bool update_compensation();
    bool tilted();
    bool approach_words(const GCode& code, SoftApproach& soft);
    int approach_side(const SoftApproach& soft, double tp, double tq, double op, double oq) const;
    bool approach_line(const AxisValues& to, bool rapid, double feed, std::uint8_t mode);
    bool approach_curve(const SoftApproach& soft, const AxisValues& to, int side,
                        const std::array<double, 2>& centre, double feed, std::uint8_t mode);
    bool finish_approach(const AxisValues& target, const ArcCall* arc, bool& taken);
    bool hole_of(const Call& c, cycles::Drilling& hole);
    static void dwell_of(const Call& c, cycles::Drilling& hole);
    bool modal_cycle();
    bool drill_at(double p_mm, double q_mm);

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
    bool chain_frames(Value& left, const Value& right);  // geo_frames.cpp
    bool number_of(const Value& value, const char* at, double& number);
    bool index_list(std::vector<Value>& indices);
    // a variable at the cursor; null reference: none there
    bool reference_ahead(Reference& reference);
    bool element_of(const Variable& variable, const std::vector<Value>& indices, const char* at,
                    std::size_t& element);
    bool call_section(const std::string& name, const std::string& first, const std::string& last);
    bool character_of(const Reference& reference, const char* at, std::size_t& i);
    Reference find_variable(std::string_view upper_name) const;
    bool assign(const Reference& reference, Value value, const char* at);
    // behind the name: = value, = SET(...), = (..)
    bool assignment(const Reference& reference);
    void store(const Reference& reference, Value value);
    std::string reference_name(const Reference& reference) const;
    int variable_type(const std::string& text) const;
    bool is_system_variable(std::string_view name) const;

    // system variables (system_variables.cpp)
    bool system_value(Value& value);  // at '$'
    bool system_name(std::string& name, std::vector<Value>& indices);
    bool feed_value(const std::string& name, const std::vector<Value>& indices, const char* from,
                    std::size_t length, Value& value, bool& known);
    bool feed_counts(unsigned place) const;
    bool tool_value(const std::string& name, const std::vector<Value>& indices, const char* from,
                    std::size_t length, Value& value);
    bool edge_cell(const std::string& name, const std::vector<Value>& indices, const char* from,
                   std::size_t length, bool make, double*& cell);
    struct DataCell {
        const params::Row* row = nullptr;  // nullptr: no machine or setting data
        std::size_t slot = 0;
    };
    bool is_data_name(std::string_view name) const;
    bool configuration_value(const std::string& name, const std::vector<Value>& indices,
                             const char* from, std::size_t length, Value& value, bool& known);
    bool data_cell(const std::string& name, const std::vector<Value>& indices, const char* from,
                   std::size_t length, DataCell& cell);
    bool write_data(const DataCell& cell, const std::string& name, double value, const char* from,
                    std::size_t length);
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
    bool call_program(const std::string& name, std::vector<Argument> arguments,
                      std::int64_t repeats, bool modal);
    bool bind_parameters(FileId file, const std::string& name, std::vector<Argument>& arguments,
                         Level& level);
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

    // interrupts (interrupts.cpp)
    struct Routine {
        std::string program;
        bool enabled = true, at_block_end = false;
        bool lifts = false;  // LIFTFAST
    };
    std::map<int, Routine> routines_;  // by input
    void arm_interrupts();
    bool lift_from_contour(const AxisValues& begin);
    bool interrupt_input(const Value& value, const char* at, int& input);

    // synchronized actions (synchronized.cpp)
    // in the order in which they were programmed
    std::vector<SynchronizedAction> actions_;
    bool in_action_ = false;  // one is being read or done
    bool synchronized_actions();
    bool read_action(const SynchronizedAction& action);
    bool do_action();
    bool each_action(Call& c, const std::function<void(SynchronizedAction&)>& change);
    bool only_in_action(std::string_view name);
    static bool find_do(Cursor& at);
    bool action_is_reportable(bool& deletes_travel);
    void split_dwell();
    bool asks_positions_only(Cursor condition, std::size_t end);  // delete_way.cpp
    struct Overlay {
        std::size_t place = 0;
        double mm = 0.0;
    };
    // $AA_OFF written by what is being done, still to be driven
    std::vector<Overlay> overlays_;
    bool write_overlay(const std::string& name, const std::vector<Value>& indices, const char* from,
                       std::size_t length, const Value& value);
    bool drive_overlays();
    // the way of this block: DELDTG is due before it begins
    bool travel_deleted_ = false;
    bool deletes_travel() const,
        holds_at(const SynchronizedAction&action, const AxisValues&point, bool&holds),
        limited_travel(AxisValues&target);
    bool machine_there();
    void tell_outputs();
    void look_at_outputs();
    struct Polynomial {
        double low = 0, high = 0;
        std::array<double, 4> factors{};
    };
    std::map<int, Polynomial> polynomials_;  // FCTDEF

    // text files (files.cpp)
    // nullopt: deleted
    std::map<std::string, std::optional<std::string>, std::less<>> written_files_;
    // limits of spindle speeds that REDEF ... PRLOC lets end with the program
    std::vector<const params::Row*> program_local_;
    void tell_speed_limit(const params::Row& row, std::size_t slot, double value);
    static bool limits_spindle_speed(const params::Row& row);  // SD43210, SD43220, SD43230
    bool redefine_data(const char* from);
    // of a machine or setting datum; nullptr none
    static const params::Row* data_row(const std::string& name);
    std::map<std::string, CalendarTime, std::less<>> written_at_;
    std::map<std::string, std::array<double, 3>, std::less<>> tool_environments_;  // T, D, DL
    CalendarTime time_of_file(const std::string& name);
    bool text_of_file(const std::string& name, std::string& text);
    void change_file(const std::string& name, std::optional<std::string> text);

    struct Left;  // carry.cpp
    // resume states (resume.cpp)
    struct ResumeState;
    void note_resume_point();

    Core core_;
    ProgramFiles* files_;
    Settings settings_;
    CurveTables curve_tables_;
    ToolTable tools_;
    std::map<FileId, TextIndex> indices_;

    // the text
    std::vector<Level> levels_;
    LineSource* source_ = nullptr;
    TextPosition here_;  // of the block being read
    std::string line_;
    Cursor cursor_;
    Block block_;

    Modal modal_;
    std::shared_ptr<Variable> r_;
    std::map<std::string, std::string, std::less<>> macros_;
    // what the store does not keep of a frame
    std::map<int, FrameValue> settable_parts_, grinding_frames_;
    // markers and other values that a program may write
    std::map<std::string, Value, std::less<>> written_system_;

    // the block
    bool wants_barrier_ = false, ended_ = false, jumped_ = false, reread_ = false, fresh_ = true,
         needs_barrier_ = false;
    bool called_ = false;
    // of this block: MCALL calls a program at each hole
    std::shared_ptr<const HolePattern> at_hole_;
    // of the block whose T has been executed before the rest of it
    std::uint64_t managed_serial_ = 0;
    std::uint64_t ways_before_ = 0;
    std::size_t fault_column_ = 0, fault_length_ = 0;
    unsigned depth_ = 0;  // of nested brackets
    // words are being computed, nothing has acted
    bool reading_ = false;
    const Statement* statement_ = nullptr;  // behind the words of the block
    std::size_t statement_at_ = 0, program_column_ = 0;
    std::uint32_t fault_line_ = 0;
    // assignments of the block being read
    std::vector<std::function<void()>> block_undo_;
    struct Written {
        std::string name;
        Value value;
    };
    std::vector<Written> written_;  // output when the block acts
    struct WrittenZero {
        int number;
        std::int32_t row;
        unsigned place;
        double value;
    };
    std::vector<WrittenZero> written_zeros_;
    bool of_channel_ = false;  // DEF CHAN
    // EXECSTRING: the line that comes next
    std::string execute_;
    std::shared_ptr<Scope> channel_scope_ = std::make_shared<Scope>();  // DEF CHAN
    double block_feed_ = 0.0;                                           // FB
    double parts_ = 0;
    std::string message_;

    // resume
    ResumePoints<ResumeState> points_;
    std::deque<std::pair<std::uint64_t, std::function<void()>>> undo_log_;
    std::uint64_t serial_ = 0;
    bool keep_states_ = false, state_changed_ = true;
};

}  // namespace polyturn::channels::sinumerik
