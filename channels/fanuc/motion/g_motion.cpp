// Handlers of moves: G0 to G3, threads, G53, reference.
#include <cmath>
#include <limits>

#include "channels/fanuc/interpreter.hpp"
#include "channels/fanuc/motion/feed_words.hpp"

namespace polyturn::channels::fanuc {

bool Interpreter::g_rapid(const GCode&) {
    if (!axis_word_count_) return true;
    return read_axis_words(target_) && follows_corner(target_, false) && core_.rapid(target_);
}

bool Interpreter::g_linear(const GCode&) {
    const bool angle = angle_word() != nullptr;
    if (angle && settings_.mefi) return core_.fail(Alarm::AddressIllegal, 'A', "A");
    if (!axis_word_count_ && !angle) {
        // I and K beside G40 only say how the contour would go on (fanuc_lathe 2.7).
        const bool leaves =
            (coded_groups_ >> static_cast<unsigned>(GGroup::Comp) & 1u) &&
            coded_[static_cast<std::size_t>(GGroup::Comp)]->act == &Interpreter::g_comp_off;
        for (const char letter : {'I', 'K', 'R'})
            if (block_.has(letter) && !(leaves && letter != 'R'))
                return core_.fail(Alarm::CornerMoveMissing, letter);
        return true;
    }
    AxisSet named = 0;
    if (!read_axis_words(target_, &named)) return false;
    if (angle && !angle_line(named)) return false;
    if (core_.move_reserved() && angle && !named) {  // its end comes with the next block
        // they stand at right angles to a line along an axis; here ,C and ,R can
        for (const char letter : {'I', 'K', 'R', 'C'})
            if (block_.has(letter) && !(letter == 'C' && (axis_letters_ & letter_bit('C'))))
                return core_.fail(Alarm::CornerTaper, letter);
        return true;
    }
    if (core_.move_reserved()) return core_.fail(Alarm::AngleParallel, 'G');
    return follows_corner(target_, true) && lathe_corner(named) && core_.linear(target_);
}

bool Interpreter::g_arc(const GCode& row) {
    ArcCall call;
    call.clockwise = row.tenths == 20;
    bool goes = false;
    return arc_words(call, goes) && (!goes || core_.arc(target_, call));
}

// Target and centre or radius of an arc; goes: the block names any of them.
bool Interpreter::arc_words(ArcCall& call, bool& goes) {
    const bool centre_words = block_.has('I') || block_.has('J') || block_.has('K');
    goes = axis_word_count_ || centre_words;
    if (!goes) return block_.has('R') ? core_.fail(Alarm::ArcWithoutRadius) : true;
    AxisSet named = 0;
    if (!read_axis_words(target_, &named) || !follows_corner(target_, false)) return false;
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    if (p < 0 || q < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    call.tolerance = settings_.arc_tolerance;
    if (block_.has('R')) {
        call.has_radius = true;
        call.radius = radius_length('R');
        return call.radius <= 0 && !settings_.nct ? core_.fail(Alarm::ArcRadiusIllegal, 'R') : true;
    }
    if (!centre_words) return core_.fail(Alarm::ArcWithoutRadius, 'G');
    // An end beside the arc is no alarm under compensation: the circle about the same centre
    // through it counts there (fanuc_lathe 3.8). A contour of a cycle has no compensation yet.
    const bool compensated = core_.compensating() && core_.at.comp != CompSide::Off &&
                             !core_.path.tool.nose_off && !reads_contour_;
    if (compensated && !settings_.nct && !settings_.mefi)
        call.tolerance = std::numeric_limits<double>::infinity();
    // by plane: first, second axis
    static constexpr char kCentre[3][2] = {{'I', 'J'}, {'K', 'I'}, {'J', 'K'}};
    static constexpr char kForeign[3] = {'K', 'J', 'I'};
    const auto plane = static_cast<std::size_t>(core_.path.plane);
    if (block_.has(kForeign[plane]))
        return core_.fail(Alarm::PlaneAxisIllegal, kForeign[plane],
                          std::string(1, kForeign[plane]));
    const auto pi = static_cast<std::size_t>(p), qi = static_cast<std::size_t>(q);
    call.centre_p = radius_length(kCentre[plane][0]) +
                    (settings_.centre_absolute ? 0.0 : core_.path.programmed[pi]);
    call.centre_q = radius_length(kCentre[plane][1]) +
                    (settings_.centre_absolute ? 0.0 : core_.path.programmed[qi]);
    return true;
}

bool Interpreter::g_thread(const GCode&) {
    if (!axis_word_count_) return true;
    if (!read_axis_words(target_)) return false;
    ThreadCall call;
    thread_words(call);
    return core_.thread(target_, call);
}

// Lead (F, E) and start angle (Q) of a thread.
void Interpreter::thread_words(ThreadCall& call) {
    if (block_.has('E')) {
        const Word& word = block_.word('E');
        lead_ =
            fine_feed(word, word.has_point || word.from_expression || settings_.point_means_nothing,
                      settings_.series15, inch_) *
            unit_;
    }
    call.lead = lead_ > 0                                         ? lead_
                : core_.path.feed_mode == FeedMode::PerRevolution ? core_.path.feed
                                                                  : 0.0;
    if (!block_.has('Q')) return;
    const Word& word = block_.word('Q');
    // Fanuc counts thousandths of a degree and knows no point here; series 15 programs accept Q
    // without effect.
    call.start_angle = word.has_point || settings_.nct ? word.value : word.value * 0.001;
    if (settings_.series15) call.start_angle = 0.0;
}

// G35: a thread on an arc, clockwise.
bool Interpreter::g_thread_arc(const GCode&) {
    ArcCall arc;
    arc.clockwise = true;
    bool goes = false;
    if (!arc_words(arc, goes)) return false;
    if (!goes) return true;
    ThreadCall call;
    thread_words(call);
    call.arc = &arc;
    return core_.thread(target_, call);
}

bool Interpreter::g_thread_variable(const GCode&) {
    if (!axis_word_count_) return true;
    if (!read_axis_words(target_)) return false;
    ThreadCall call;
    call.lead = lead_ > 0                                         ? lead_
                : core_.path.feed_mode == FeedMode::PerRevolution ? core_.path.feed
                                                                  : 0.0;
    call.lead_change = block_.has('K') ? block_.value('K') * unit_ : 0.0;
    if (block_.has('Q'))
        call.start_angle = block_.word('Q').has_point || settings_.nct ? block_.value('Q')
                                                                       : block_.value('Q') * 0.001;
    return core_.thread(target_, call);
}

bool Interpreter::g_machine(const GCode&) {
    AxisValues machine = core_.path.machine;
    AxisSet which = 0;
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        int place = word.axis >= 0 ? word.axis
                                   : absolute_axis_[static_cast<std::size_t>(word.address - 'A')];
        if (place < 0 || !absolute_) continue;  // an incremental word is ignored with G53
        const auto i = static_cast<std::size_t>(place);
        machine[i] = length(word, place) * (core_.view().axes[i].diameter ? 0.5 : 1.0);
        which |= 1u << i;
    }
    return which ? core_.machine_rapid(machine, which) : true;
}

// G28, G30, G30.1 (to F1244): rapid to the point of the block, then to the reference position.
bool Interpreter::g_reference(const GCode& row) {
    if (!axis_word_count_)
        return core_.fail(Alarm::ReferenceAxisMissing, 'G', std::string(row.name));
    AxisSet named = 0;
    if (!read_axis_words(target_, &named)) return false;
    std::size_t position = 0;
    if (row.tenths == 300) {
        std::int64_t p = settings_.nct ? 1 : 2;
        if (block_.has('P') && !whole('P', p)) return false;
        // Fanuc counts the second to fourth reference position, nct the three further ones.
        const std::int64_t index = settings_.nct ? p : p - 1;
        if (index < 1 || index > 3)
            return core_.fail(Alarm::OffsetValueIllegal, 'P', {}, static_cast<double>(p));
        position = static_cast<std::size_t>(index);
    }
    if (!core_.rapid(target_)) return false;
    AxisValues machine = core_.path.machine;
    const bool floating = row.tenths == 301;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        const ChannelAxis& axis = core_.view().axes[i];
        if (named >> i & 1u)
            machine[i] =
                floating ? params::get(core_.view().table(), params::f1244, axis.machine_axis + 1u)
                         : axis.reference_mm[position];
    }
    if (!core_.reference(machine, named, MoveKind::Reference)) return false;
    // an axis finds its reference point
    wants_barrier_ = wants_barrier_ || core_.due_at_barrier();
    return true;
}

bool Interpreter::g_reference_check(const GCode& row) {
    if (!axis_word_count_)
        return core_.fail(Alarm::ReferenceAxisMissing, 'G', std::string(row.name));
    AxisSet named = 0;
    if (!read_axis_words(target_, &named) || !core_.rapid(target_)) return false;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if ((named >> i & 1u) &&
            std::fabs(core_.path.machine[i] - core_.view().axes[i].reference_mm[0]) > 1e-6)
            return core_.fail(Alarm::ReferenceNotReached, core_.view().axes[i].name[0],
                              std::string(core_.view().axes[i].name));
    return true;
}

}  // namespace polyturn::channels::fanuc
