// What a program leaves to the next one in its channel: #100 and on, #1 to #33 of the main program
// (F6001#6, #7 also over a reset), the outputs and timers (#1100 to #1133, #3001, #3002;
// fanuc_lathe 6.3.1, 6.10), the tool offset where F5003#6 or N1414#5 keep it, and with N1301 CLR
// the G groups that N1302 to N1306 keep (nct part 1 14.2).
//
// A program's end counts as a reset here: without CLR all groups begin as the machine was switched
// on. But only the reset itself and M02, M30 (which reset and rewind) cancel the tool offset
// (fanuc_lathe 1.6): what T calls by hand is in use for what comes next.
#include "channels/fanuc/motion/b_memory.hpp"
#include "channels/fanuc/resume_state.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Group gg of an nct control is in bit gg % 8 of table gg / 8.
bool keeps(const params::Table& t, unsigned channel, unsigned group) {
    return params::bit(t, params::nth(params::n1302_clr_g_table1, group / 8 + 1), channel,
                       group % 8);
}

}  // namespace

struct Interpreter::Inherited {
    std::vector<double> common;
    LocalSet locals;
    decltype(values_of(std::declval<Interpreter&>().modal())) modal;
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

std::any Interpreter::carry() const {
    // modal() ties references; they are only read here
    auto& self = const_cast<Interpreter&>(*this);
    return std::make_shared<Inherited>(Inherited{
        variables_.common(), variables_.levels().front(), values_of(self.modal()), modal_calls_,
        core_.path, core_.at.comp, pattern_, b_.programs, names_, outputs_, outputs_wide_,
        timer_ms_offset_, timer_h_offset_, ended_by_code_, parts_, settings_.parts_made});
}

// What was saved over power-off; a text that cannot be read leaves nothing, and is reported.
void Interpreter::recall_kept() {
    const auto ignored = [this](std::string_view what) {
        core_.sink().alarm({Alarm::StoreRowIgnored,
                            {files_->path(frames_.back().file), 0, 0, 0},
                            {},
                            std::string(what)},
                           core_.at);
    };
    if (const std::string text = core_.port().kept(kBProgramsKept); !text.empty()) {
        if (auto programs = b_programs(text))
            b_.programs = std::move(*programs);
        else
            ignored("G101 G102 G103");
    }
    if (!names_.take(core_.port().kept(kNamesKept))) ignored("SETVN");
}

void Interpreter::take_carry(const std::any& before, bool after_reset) {
    const auto* held = std::any_cast<std::shared_ptr<Inherited>>(&before);
    if (!held || !*held) return;
    const Inherited& last = **held;
    pattern_ = last.pattern;
    // what was read ahead when it was reset has made no part
    if (!after_reset && last.parts_table == settings_.parts_made) parts_ = last.parts;
    // as new as what is kept over power-off, and there without a disk too
    b_.programs = last.b_programs;
    names_ = last.names;
    // What was read ahead when it was reset has written no output: those that are on say it
    // themselves.
    outputs_ = after_reset ? static_cast<std::uint32_t>(
                                 static_cast<std::int64_t>(core_.port().interface_value(1132)))
                           : last.outputs;
    outputs_wide_ = after_reset ? core_.port().interface_value(1133) : last.outputs_wide;
    timer_ms_offset_ = last.timer_ms;
    timer_h_offset_ = last.timer_h;
    if (!after_reset || settings_.keeps_common) variables_.take_common(last.common);
    if (!after_reset || settings_.keeps_locals) variables_.locals() = last.locals;
    if (settings_.keeps_offset || (!settings_.mefi && !after_reset && !last.by_code)) {
        core_.path.tool = last.path.tool;
        core_.at.tool = core_.path.tool.ref;
        if (apply_tool_offsets()) core_.take_wanted();  // the machine is stopped with it already
    }
    if (settings_.nct &&
        params::bit(core_.view().table(), params::n1301_defaultg2, core_.view().channel, 7))
        keep_groups(last);
}

void Interpreter::keep_groups(const Inherited& was) {
    // The other program's values, to take what belongs to the groups that stay.
    const auto now = values_of(modal());
    modal() = was.modal;
    const auto was_active = active_;
    const GCode* const motion = motion_;
    const GCode* const drilling = drilling_;
    const DrillWords drill = drill_;
    const bool absolute = absolute_, inch = inch_, polar = polar_;
    const double unit = unit_;
    const FrameChain frames = frames_of_;
    const LengthState length = length_;
    modal() = now;
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    const auto stays = [&](unsigned group, GGroup of) {
        if (!keeps(t, l, group)) return false;
        active_[static_cast<std::size_t>(of)] = was_active[static_cast<std::size_t>(of)];
        return true;
    };
    PathState& path = core_.path;
    if (stays(1, GGroup::Motion)) motion_ = motion;
    if (stays(2, GGroup::Plane)) path.plane = was.path.plane;
    if (stays(3, GGroup::Distance)) absolute_ = absolute;
    if (stays(4, GGroup::StrokeArea) && was.path.stroke2_off) {
        path.stroke2_off = true;
        core_.signal("STROKE2", 0.0);
        core_.refresh_limits();
    }
    if (stays(5, GGroup::FeedMode)) {
        path.feed_mode = was.path.feed_mode;
        path.feed = was.path.feed;
    }
    if (stays(6, GGroup::Units)) {
        inch_ = inch;
        unit_ = unit;
    }
    if (stays(9, GGroup::Drilling)) {
        drilling_ = drilling;
        drill_ = drill;
    }
    (void)stays(10, GGroup::ReturnLevel);
    if (stays(13, GGroup::Surface)) {
        path.spindle.mode = was.path.spindle.mode;
        path.spindle.surface_m_min = was.path.spindle.surface_m_min;
    }
    if (stays(14, GGroup::Zero)) core_.select_zero(was.path.zero_row);
    if (stays(15, GGroup::ExactStop)) {
        path.exact_stop_mode = was.path.exact_stop_mode;
        path.override_locked = was.path.override_locked;
        if (control_bits() != 0) tell_control();  // G63
    }
    if (stays(17, GGroup::Polar)) polar_ = polar;
    if (stays(11, GGroup::Scale)) frames_of_.scaling = frames.scaling;
    if (stays(22, GGroup::Mirror)) frames_of_.mirror = frames.mirror;
    if (stays(16, GGroup::Rotation)) frames_of_.rotation = frames.rotation;
    apply_frames();
    if (stays(8, GGroup::Length)) {
        length_ = length;
        (void)apply_tool_offsets();
    }
    if (stays(12, GGroup::MacroModal)) modal_calls_ = was.modal_calls;
    // The start of a program is a barrier: the plane may begin here, where the axes stand.
    const Transformation& plane = was.path.transformation;
    if (keeps(t, l, 21) && plane.active() && kind_of(plane.kinematics) == KinematicsKind::Polar) {
        (void)stays(21, GGroup::Transform);
        if (core_.transform(plane)) {
            plane_before_ = path.plane;
            path.plane = Plane::XY;
        } else
            barrier_fault_ = core_.fault();
    }
    // Compensation begins anew with the next move.
    if (stays(7, GGroup::Comp) && was.side != CompSide::Off) (void)core_.compensation(was.side);
}

}  // namespace polyturn::channels::fanuc
