// What a program leaves to the next one in its channel: #100 and on, #1 to #33 of the main program
// (F6001#6, #7 also over a reset), the outputs and timers (#1100 to #1133, #3001, #3002;
// fanuc_lathe 6.3.1, 6.10), the tool offset where F5003#6 or N1414#5 keep it, and with N1301 CLR
// the G groups that N1302 to N1306 keep (nct part 1 14.2).
//
// A program's end counts as a reset here: without CLR all groups begin as the machine was switched
// on. But only the reset itself and M02, M30 (which reset and rewind) cancel the tool offset
// (fanuc_lathe 1.6): what T calls by hand is in use for what comes next.
#include "channels/fanuc/program/inherited.hpp"

#include <memory>

#include "channels/fanuc/b_axis/b_memory.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/frames/g_frames.hpp"
#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/tools/tool_words.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Group gg of an nct control is in bit gg % 8 of table gg / 8.
bool keeps(const params::Table& t, unsigned channel, unsigned group) {
    return params::bit(t, params::nth(params::n1302_clr_g_table1, group / 8 + 1), channel,
                       group % 8);
}

struct Inherited {
    std::vector<double> common;
    LocalSet locals;
    ModalState modal;
    std::vector<ModalCall> modal_calls;
    PathState path;
    CompSide side = CompSide::Off;
    double pattern = 0;                            // #5900: until another one is chosen
    std::array<std::vector<BStep>, 3> b_programs;  // registered ones stay
    VariableNames names;
    std::uint32_t outputs = 0;
    double outputs_wide = 0, timer_ms = 0, timer_h = 0;
    bool by_code = false;  // M02 or M30 has ended it
    // #3901, and N2307 of the table: it follows a moment later, unless somebody has set it
    double parts = 0, parts_table = 0;
};

void keep_groups(Execution& x, const Inherited& was) {
    // The other program's values, to take what belongs to the groups that stay.
    const auto now = x.modal;
    x.modal = was.modal;
    const auto was_active = x.modal.active;
    const GCode* const motion = x.modal.motion;
    const GCode* const drilling = x.modal.drilling;
    const DrillWords drill = x.modal.cycles.drill;
    const bool absolute = x.modal.input.absolute, inch = x.modal.input.inch,
               polar = x.modal.polar.on;
    const double unit = x.modal.input.unit;
    const FrameChain frames = x.modal.frames;
    const LengthState length = x.modal.length;
    x.modal = now;
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const auto stays = [&](unsigned group, GGroup of) {
        if (!keeps(t, l, group)) return false;
        x.modal.in_force(of) = was_active[static_cast<std::size_t>(of)];
        return true;
    };
    PathState& path = x.core.path;
    if (stays(1, GGroup::Motion)) x.modal.motion = motion;
    if (stays(2, GGroup::Plane)) path.plane = was.path.plane;
    if (stays(3, GGroup::Distance)) x.modal.input.absolute = absolute;
    if (stays(4, GGroup::StrokeArea) && was.path.stroke2_off) {
        path.stroke2_off = true;
        x.core.signal("STROKE2", 0.0);
        x.core.refresh_limits();
    }
    if (stays(5, GGroup::FeedMode)) {
        path.feed_mode = was.path.feed_mode;
        path.feed = was.path.feed;
    }
    if (stays(6, GGroup::Units)) {
        x.modal.input.inch = inch;
        x.modal.input.unit = unit;
    }
    if (stays(9, GGroup::Drilling)) {
        x.modal.drilling = drilling;
        x.modal.cycles.drill = drill;
    }
    (void)stays(10, GGroup::ReturnLevel);
    if (stays(13, GGroup::Surface)) {
        path.spindle.mode = was.path.spindle.mode;
        path.spindle.surface_m_min = was.path.spindle.surface_m_min;
    }
    if (stays(14, GGroup::Zero)) x.core.select_zero(was.path.zero_row);
    if (stays(15, GGroup::ExactStop)) {
        path.exact_stop_mode = was.path.exact_stop_mode;
        path.override_locked = was.path.override_locked;
        if (control_bits(x) != 0) tell_control(x);  // G63
    }
    if (stays(17, GGroup::Polar)) x.modal.polar.on = polar;
    if (stays(11, GGroup::Scale)) x.modal.frames.scaling = frames.scaling;
    if (stays(22, GGroup::Mirror)) x.modal.frames.mirror = frames.mirror;
    if (stays(16, GGroup::Rotation)) x.modal.frames.rotation = frames.rotation;
    apply_frames(x);
    if (stays(8, GGroup::Length)) {
        x.modal.length = length;
        (void)apply_tool_offsets(x);
    }
    if (stays(12, GGroup::MacroModal)) x.calls.modal = was.modal_calls;
    // The start of a program is a barrier: the plane may begin here, where the axes stand.
    const Transformation& plane = was.path.transformation;
    if (keeps(t, l, 21) && plane.active() && kind_of(plane.kinematics) == KinematicsKind::Polar) {
        (void)stays(21, GGroup::Transform);
        if (x.core.transform(plane)) {
            x.modal.plane_before = path.plane;
            path.plane = Plane::XY;
        } else
            x.reading.barrier_fault = x.core.fault();
    }
    // Compensation begins anew with the next move.
    if (stays(7, GGroup::Comp) && was.side != CompSide::Off) (void)x.core.compensation(was.side);
}

}  // namespace

std::any inheritance(const Execution& x) {
    return std::make_shared<Inherited>(Inherited{
        x.macro.variables.common(), x.macro.variables.levels().front(), x.modal, x.calls.modal,
        x.core.path, x.core.at.comp, x.macro.system.pattern, x.b_axis.programs, x.macro.names,
        x.macro.system.outputs, x.macro.system.outputs_wide, x.macro.system.timer_ms_offset,
        x.macro.system.timer_h_offset, x.text.ended_by_code, x.modal.parts, x.settings.parts_made});
}

// What was saved over power-off; a text that cannot be read leaves nothing, and is reported.
void recall_kept(Execution& x) {
    const auto ignored = [&x](std::string_view what) {
        x.core.sink().alarm({Alarm::StoreRowIgnored,
                             {x.files.path(x.calls.frames.back().file), 0, 0, 0},
                             {},
                             std::string(what)},
                            x.core.at);
    };
    if (const std::string text = x.core.port().kept(kBProgramsKept); !text.empty()) {
        if (auto programs = b_programs(text))
            x.b_axis.programs = std::move(*programs);
        else
            ignored("G101 G102 G103");
    }
    if (!x.macro.names.take(x.core.port().kept(kNamesKept))) ignored("SETVN");
}

void inherit(Execution& x, const std::any& before, bool after_reset) {
    const auto* held = std::any_cast<std::shared_ptr<Inherited>>(&before);
    if (!held || !*held) return;
    const Inherited& last = **held;
    x.macro.system.pattern = last.pattern;
    // what was read ahead when it was reset has made no part
    if (!after_reset && last.parts_table == x.settings.parts_made) x.modal.parts = last.parts;
    // as new as what is kept over power-off, and there without a disk too
    x.b_axis.programs = last.b_programs;
    x.macro.names = last.names;
    // What was read ahead when it was reset has written no output: those that are on say it
    // themselves.
    x.macro.system.outputs = after_reset ? static_cast<std::uint32_t>(static_cast<std::int64_t>(
                                               x.core.port().interface_value(1132)))
                                         : last.outputs;
    x.macro.system.outputs_wide =
        after_reset ? x.core.port().interface_value(1133) : last.outputs_wide;
    x.macro.system.timer_ms_offset = last.timer_ms;
    x.macro.system.timer_h_offset = last.timer_h;
    if (!after_reset || x.settings.keeps_common) x.macro.variables.take_common(last.common);
    if (!after_reset || x.settings.keeps_locals) x.macro.variables.locals() = last.locals;
    if (x.settings.keeps_offset ||
        (x.settings.policy.program.offset_outlasts_end && !after_reset && !last.by_code)) {
        x.core.path.tool = last.path.tool;
        x.core.at.tool = x.core.path.tool.ref;
        if (apply_tool_offsets(x)) x.core.take_wanted();  // the machine is stopped with it already
    }
    if (x.settings.policy.program.keeps_groups &&
        params::bit(x.core.view().table(), params::n1301_defaultg2, x.core.view().channel, 7))
        keep_groups(x, last);
}

}  // namespace polyturn::channels::fanuc
