#include "channels/records/record_sink.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "channels/program_start.hpp"
#include "channels/records/record_place.hpp"
#include "ipc/image/balance.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/program_start.hpp"
#include "ipc/model/machine/named_inputs.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"

namespace polyturn::channels {
namespace {

void copy_text(std::string_view from, std::array<char, 48>& to) {
    to.fill(0);
    std::memcpy(to.data(), from.data(), std::min(from.size(), to.size() - 1));
}

}  // namespace

// The describing sink writes its line into *text_; a call may also describe nothing.
template <class Call>
std::uint64_t RecordSink::note(Call&& call) {
    if (!describe_) return 0;
    std::string& text = *text_;
    text.clear();
    call(*describe_);
    if (text.empty()) return 0;
    if (text.back() == '\n') text.pop_back();
    put_note_(++note_, text);
    return note_;
}

std::uint64_t RecordSink::note_step(const Dwell* dwell, const Aux* aux, const BlockContext& at) {
    return note([&](Sink& sink) {
        if (dwell)
            sink.dwell(*dwell, at);
        else
            sink.aux(*aux, at);
    });
}

std::uint64_t RecordSink::note_move(const Move& move, const BlockContext& at) {
    return note([&](Sink& sink) { sink.move(move, at); });
}

PathRecord RecordSink::event(RecordKind kind, const BlockContext& at, std::uint64_t note) const {
    PathRecord r;
    r.kind = code_of(kind);
    // kMoreBehind of what is no move: single block does not stop here.
    r.flags = kBlockBegin | kBlockEnd | (at.statement ? std::uint32_t{kMoreBehind} : 0u);
    r.note = note;
    place(at, r);
    return r;
}

void RecordSink::push(PathRecord& r, bool stands, bool drains) {
    // what is in the ring moves on only behind the interrupt
    if (ahead_ == Ahead::AtOnce && !ring_->has_room()) ahead_ = Ahead::Kept;
    if (ahead_ == Ahead::Kept || (ahead_ == Ahead::AtOnce && r.kind == code_of(RecordKind::Stop)))
        return kept_.push_back(r);
    if (ahead_ == Ahead::AtOnce) r.flags |= kAtOnce;
    if (drains) r.flags |= kDrains;
    maker_->add_event(r, stands || drains);
    drained_ = drains;
    if (drains) drain_index_ = ring_->last_index();
}

void RecordSink::dwell(const Dwell& dwell, const BlockContext& at) {
    if (at.own_axis >= 0) return own_dwell(dwell, at);
    PathRecord r = event(RecordKind::Dwell, at, note([&](Sink& sink) { sink.dwell(dwell, at); }));
    r.feed_mode =
        static_cast<std::uint8_t>(dwell.revolutions ? FeedMode::Revolutions : FeedMode::Seconds);
    r.feed = dwell.value;
    r.value = dwell.rest;
    r.spindle = dwell.spindle;
    if (const auto input =
            dwell.until.empty() ? std::nullopt : input_by_name(dwell.until, view_->channel)) {
        r.flags |= kSkipMove;
        r.code = static_cast<std::int32_t>(*input);
    }
    push(r, true, false);
}

void RecordSink::look_up_tool(const Aux& code, const BlockContext& at) {
    PathRecord r = event(RecordKind::Aux, at, 0);
    r.plane[2] = 1;
    push_code(r, code);
}

void RecordSink::aux(const Aux& aux, const BlockContext& at) {
    if (at.own_axis >= 0) return own_function(aux, at);
    PathRecord r =
        event(RecordKind::Aux, at, aux.silent ? 0 : note([&](Sink& sink) { sink.aux(aux, at); }));
    push_code(r, aux);
}

void RecordSink::push_code(PathRecord& r, const Aux& aux) {
    r.code = aux.letter;
    r.value = aux.value;
    if (aux.beside) r.flags |= kPositioning;
    r.plane[0] = static_cast<std::uint8_t>(aux.by);
    copy_text(aux.name.empty() ? aux.text : aux.name, r.text);
    r.plane[1] = !aux.name.empty();
    push(r, true, aux.drained);
}

void RecordSink::spindle(const Spindle& spindle, const BlockContext& at) {
    if (at.own_axis >= 0) return;  // its code goes to the PLC
    std::uint64_t number =
        spindle.silent ? 0 : note([&](Sink& sink) { sink.spindle(spindle, at); });
    PathRecord r = event(RecordKind::SpindleMode, at, number);
    r.spindle = spindle.spindle;
    r.code = static_cast<std::int32_t>(spindle.mode);
    r.value = spindle.value;
    if ((spindle.mode == SpindleModeCode::Rpm || spindle.mode == SpindleModeCode::SurfaceSpeed) &&
        spindle.spindle <= kMaxSpindles)
        r.value *= shares_.spindle[spindle.spindle];
    r.shape[0] = spindle.limit;
    if (spindle.for_release) r.mask = 1;
    if (spindle.css_axis >= 0) {
        r.axis[0] = view_->axes[static_cast<std::size_t>(spindle.css_axis)].machine_axis;
        r.shape[1] = spindle.css_zero;
        r.shape[2] = spindle.least;
    }
    if (spindle.mode == SpindleModeCode::Position) {
        r.plane[0] = static_cast<std::uint8_t>(spindle.approach);
        r.shape[2] = spindle.way;
        r.feed = spindle.feed_rpm / 60.0;
        r.mask = spindle.needs_loop;
        if (spindle.beside && spindle.spindle >= 1 && spindle.spindle <= kMaxSpindles) {
            r.flags |= kPositioning;
            under_way_.spindle[spindle.spindle - 1u] = true;
            return push(r, false, false);
        }
    }
    if (spindle.mode == SpindleModeCode::Watch) {
        r.value = spindle.watch[0];
        r.shape[0] = spindle.watch[1];
        r.shape[2] = spindle.watch[2];
        r.shape[3] = spindle.watch[3];
    }
    const bool couples = spindle.mode == SpindleModeCode::Couple,
               frees = spindle.mode == SpindleModeCode::Uncouple;
    if (couples || frees) {
        r.axis[0] = spindle.follower;
        r.axis[1] = spindle.helix;
        r.shape[0] = spindle.turns;
        r.shape[1] = spindle.master_turns;
        r.shape[2] = spindle.phase_deg;
        r.shape[3] = spindle.helix_deg_mm;
        r.mask = (spindle.gear ? 1u : 0u) | (spindle.cutter ? 2u : 0u) |
                 (frees && spindle.for_release ? 4u : 0u);
        return push(r, true, true);  // what follows it is an axis that has turned
    }
    // An S word alone is a speed; what it turns like is the PLC's.
    const bool plain =
        spindle.mode == SpindleModeCode::Rpm && !spindle.mode_changed && !spindle.limit_changed;
    if (plain) r.kind = code_of(RecordKind::SpindleSpeed);
    push(r, spindle.mode == SpindleModeCode::Position, false);
}

void RecordSink::wait(const Wait& wait, const BlockContext& at) {
    if (wait.act == Wait::Act::Arrive) {
        Outstanding whom;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (wait.axes >> i & 1u) whom.axis[view_->axes[i].machine_axis] = true;
        for (unsigned s = 0; s < kMaxSpindles; ++s)
            whom.spindle[s] = (wait.spindles >> s & 1u) != 0;
        return await(whom, at);
    }
    if (wait.act != Wait::Act::Meet) {
        PathRecord r =
            event(RecordKind::Marker, at, note([&](Sink& sink) { sink.wait(wait, at); }));
        r.code = static_cast<std::int32_t>(wait.code);
        r.value = wait.act == Wait::Act::SetMarker ? 1.0 : 0.0;
        push(r, false, false);
        return;
    }
    PathRecord r = event(RecordKind::Wait, at, note([&](Sink& sink) { sink.wait(wait, at); }));
    r.code = static_cast<std::int32_t>(wait.code);
    r.mask = wait.channels;
    copy_text(wait.marker, r.text);
    if (wait.flying) r.flags |= kFlying;
    // A flying wait reads nothing of the machine, and the path goes on behind it: the kernel brakes
    // in front of it when a partner is missing.
    push(r, !wait.flying || wait.code == kBalanceMeeting, !wait.flying);
}

void RecordSink::variable(const Variable& variable, const BlockContext& at) {
    const std::uint64_t number = note([&](Sink& sink) { sink.variable(variable, at); });
    // not visible outside this process
    if (variable.persistent < 0 && number == 0) return;
    PathRecord r = event(RecordKind::Variable, at, number);
    r.code = variable.persistent;
    r.mask = variable.channel;
    r.value = variable.value;
    copy_text(variable.name, r.text);
    push(r, false, false);
}

void RecordSink::offset(const OffsetWrite& offset, const BlockContext& at) {
    if (changes_) changes_->wrote(offset);
    PathRecord r =
        event(RecordKind::Offset, at, note([&](Sink& sink) { sink.offset(offset, at); }));
    r.code = static_cast<std::int32_t>(offset.work ? OffsetTable::Work : offset.store_table);
    r.mask = static_cast<std::uint32_t>(offset.work ? offset.row : offset.number);
    r.plane[0] = static_cast<std::uint8_t>(offset.work ? offset.place
                                                       : static_cast<std::int32_t>(offset.field));
    r.plane[1] = static_cast<std::uint8_t>(offset.work ? std::uint32_t{offset.until_power_off}
                                                       : offset.channel);
    r.value = offset.value;
    push(r, false, false);
}

void RecordSink::message(std::string_view text, const BlockContext& at) {
    PathRecord r =
        event(RecordKind::Message, at, note([&](Sink& sink) { sink.message(text, at); }));
    copy_text(text, r.text);
    push(r, false, false);
}

void RecordSink::interrupts(const Interrupts& interrupts, const BlockContext& at) {
    PathRecord r = event(RecordKind::Interrupts, at, 0);
    r.code = interrupts.on;
    r.mask = (interrupts.at_block_end ? kInterruptAtBlockEnd : 0u) |
             (interrupts.by_level ? kInterruptByLevel : 0u) |
             (interrupts.mint ? kInterruptByMint : 0u) |
             (interrupts.wires ? kInterruptByWires : 0u);
    r.value = interrupts.inputs;
    push(r, false, false);
}

void RecordSink::signal(std::string_view name, double value, const BlockContext& at) {
    if (name == "SMOOTHING") {  // internal to making the path
        maker_->flush();
        maker_->smooth(
            smoothing_of(view_->table(), view_->machine, view_->channel, static_cast<int>(value)));
        return;
    }
    if (takes_share(name, value) || demand(name, value, at) || other_program(name, value, at))
        return;
    static constexpr std::pair<std::string_view, std::int32_t> kCodes[] = {
        {"TAPPING", kFlagTapping}, {"CONTROL", kFlagControl},      {"STROKE2", kFlagStroke2},
        {"CN_UOUT", kFlagOutputs}, {"CN_UOUTW", kFlagOutputsWide}, {"CN_BALANCE", kFlagBalance}};
    for (const auto& [known, code] : kCodes) {
        if (name != known) continue;
        PathRecord r = event(RecordKind::Flag, at, 0);
        r.code = code;
        r.value = value;
        push(r, false, false);
    }
}

// The program of another channel: chosen piece by piece, or started.
bool RecordSink::other_program(std::string_view name, double value, const BlockContext& at) {
    const auto selection = selection_of(name);
    if (!selection && name != kStartSignal) return false;
    const std::uint64_t number = note([&](Sink& sink) { sink.signal(name, value, at); });
    if (!selection) {
        PathRecord r = event(RecordKind::Flag, at, number);
        r.code = kFlagStart;
        r.mask = static_cast<std::uint32_t>(value);
        push(r, false, false);
        return true;
    }
    for (std::size_t from = 0; from < selection->file.size();) {
        PathRecord r = event(RecordKind::Flag, at, from == 0 ? number : 0);
        const std::string_view piece = selection->file.substr(from, r.text.size() - 1);
        r.code = kFlagProgram;
        r.mask = selection->channel;
        r.value = static_cast<double>(from);
        from += piece.size();
        r.plane[0] = from == selection->file.size();
        copy_text(piece, r.text);
        push(r, false, false);
    }
    return true;
}

// A column or tool parameter that does not exist is the language's mistake, reported before it
// comes here.
void RecordSink::tool_write(const ToolWrite& write, const BlockContext& at) {
    PathRecord r = event(RecordKind::ToolData, at, 0);
    r.mask = static_cast<std::uint32_t>(write.tool);
    r.value = write.value;
    if (write.field.empty()) {
        r.plane[0] = static_cast<std::uint8_t>(write.edge);
        r.code = write.dp;
    } else {
        const auto field = find_tool_field(write.field);
        if (!field) return;
        r.code = static_cast<std::int32_t>(*field);
    }
    copy_text(write.text, r.text);
    push(r, false, false);
}

void RecordSink::life_group(const LifeGroup& group, const BlockContext& at) {
    PathRecord r = event(RecordKind::LifeGroup, at, 0);
    r.code = static_cast<std::int32_t>(group.step);
    r.mask = static_cast<std::uint32_t>(group.group);
    r.plane[0] = static_cast<std::uint8_t>(group.kind);
    r.value = group.step == LifeGroupStep::Tool ? group.station : group.life;
    // Each tool carries the life of its group, its place in the order and its offset.
    if (group.step == LifeGroupStep::Open) {
        group_ = group;
        group_order_ = 0;
    }
    if (group.step == LifeGroupStep::Tool) {
        r.plane[0] = static_cast<std::uint8_t>(group_.kind);
        char text[sizeof r.text];
        std::snprintf(text, sizeof text, "%d %d %.6g", group.offset, ++group_order_, group_.life);
        copy_text(text, r.text);
    }
    push(r, false, false);
}

void RecordSink::parameter(std::string_view line, const BlockContext& at) {
    PathRecord r = event(RecordKind::Parameter, at, 0);
    copy_text(line, r.text);
    push(r, true, false);
}

// Only an event: a variable that is not saved.
void RecordSink::print(std::string_view text, const BlockContext& at) {
    const std::uint64_t number = note([&](Sink& sink) { sink.print(text, at); });
    if (number == 0) return;
    PathRecord r = event(RecordKind::Variable, at, number);
    r.code = -1;
    copy_text("DPRNT", r.text);  // a name that the store does not keep
    push(r, false, false);
}

void RecordSink::stop(const Stop& stop, const BlockContext& at) {
    const bool asks = stop.reason == StopReason::Dialogue;
    if (asks && stop.page && show_dialogue_) show_dialogue_(*stop.page);
    if (!asks && stop.reason != StopReason::M00 && stop.reason != StopReason::M01 &&
        stop.reason != StopReason::Restart && stop.reason != StopReason::Alarm)
        await(under_way_, at);
    PathRecord r = event(RecordKind::Stop, at, note([&](Sink& sink) {
                             sink.stop({stop.reason, stop.page}, at);
                         }));
    r.code = static_cast<std::int32_t>(stop.reason);
    // the key may come while the machine drives what comes before it
    if (!stop.asked) return push(r, true, false);
    const bool goes_on = asks || stop.reason == StopReason::M00 || stop.reason == StopReason::M01;
    // the interpreter reads on behind it
    if (stop.reason == StopReason::Restart) return push(r, true, false);
    // reported, but the machine goes on with the next part
    if (!goes_on && more_parts_) r.kind = code_of(RecordKind::Barrier);
    push(r, true, goes_on || more_parts_);
    if (!goes_on) stopped_ = true;
}

void RecordSink::part(double count, const BlockContext& at) {
    PathRecord r = event(RecordKind::Part, at, note([&](Sink& sink) { sink.part(count, at); }));
    r.value = count;
    push(r, false, false);
}

// In path order: the machine drives what comes before it, then reports it and stops.
void RecordSink::alarm(const Diagnosis& diagnosis, const BlockContext& at) {
    const std::uint64_t number = note([&](Sink& sink) { sink.alarm(diagnosis, at); });
    const bool error = diagnosis.severity() == Severity::Error;
    PathRecord r = event(error ? RecordKind::Stop : RecordKind::Message, at, number);
    r.code = error ? static_cast<std::int32_t>(StopReason::Alarm) : 0;
    r.value = static_cast<double>(static_cast<std::int32_t>(diagnosis.alarm));
    copy_text(diagnosis.text(), r.text);
    push(r, error, false);
    if (error) stopped_ = failed_ = true;
}

void RecordSink::barrier(const BlockContext& at) {
    if (ahead_ != Ahead::No) return;  // the picture was taken just now
    await_spindles(at);               // a preprocessing stop waits for them
    PathRecord r = event(RecordKind::Barrier, at, 0);
    push(r, true, true);
}

void RecordSink::block_end(const BlockContext& at) { last_ = at; }

void RecordSink::skip_ended(Port& port) {
    if (!skip_.number || !describe_) return;
    Move& m = skip_.move;
    m.skip_name = skip_.input;
    m.kinematics = nullptr;  // it may be gone
    skip_.at.tool.name = skip_.tool;
    skip_.at.cycle = skip_.cycle;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const auto end =
            m.moved >> i & 1u ? port.axis_at_skip(view_->axes[i].machine_axis) : std::nullopt;
        if (!end) continue;
        const double there = view_->axes[i].from_drive(*end);
        m.pos[i] += there - m.machine[i];
        m.machine[i] = there;
    }
    text_->clear();
    describe_->move(m, skip_.at);
    if (!text_->empty() && text_->back() == '\n') text_->pop_back();
    if (!text_->empty()) put_note_(skip_.number, *text_);
    skip_.number = 0;
}

void RecordSink::at_once(bool on) {
    if (on) kept_.clear();
    ahead_ = !on ? Ahead::No : ring_->has_room() ? Ahead::AtOnce : Ahead::Kept;
    if (ahead_ == Ahead::AtOnce) maker_->flush();
}

void RecordSink::push_kept() {
    for (PathRecord& r : kept_) {
        if (r.kind == code_of(RecordKind::Stop)) stopped_ = failed_ = true;
        push(r, r.kind == code_of(RecordKind::Stop), false);
    }
    kept_.clear();
}

void RecordSink::reach_barrier() {
    if (!drained_) barrier(last_);
}

void RecordSink::finish(StopReason reason) {
    if (stopped_)
        maker_->flush();
    else
        stop({reason}, last_);
}

void RecordSink::end_of_part() { reach_barrier(); }

}  // namespace polyturn::channels
