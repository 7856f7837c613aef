#include "channels/check/event_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "channels/program_start.hpp"

namespace polyturn::channels {
namespace {

constexpr double kHalfUlp = 0.5e-6;  // six decimals

// Builds {"ev":"...","ch":n,...} key by key.
class Object {
public:
    Object(std::string& out, std::string_view ev, const EventScene& scene, const BlockContext* at)
        : out_(out) {
        out_ += "{\"ev\":\"";
        out_ += ev;
        out_ += '"';
        integer("ch", scene.view->channel);
        if (!at) return;
        if (scene.files && at->file < scene.files->count())
            text("file", scene.files->path(at->file));
        if (at->line) integer("line", at->line);
        if (at->block >= 0) integer("n", at->block);
    }
    ~Object() { out_ += '}'; }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    void key(std::string_view name) {
        out_ += ",\"";
        out_ += name;
        out_ += "\":";
    }
    void integer(std::string_view name, std::int64_t value) {
        key(name);
        fmt::format_to(std::back_inserter(out_), "{}", value);
    }
    void number(std::string_view name, double value) {
        key(name);
        append_number(value);
    }
    void text(std::string_view name, std::string_view words) {
        key(name);
        append_text(words);
    }
    void append_number(double value) {
        if (!std::isfinite(value)) {
            out_ += "null";
            return;
        }
        if (std::fabs(value) >= 1e12) {
            fmt::format_to(std::back_inserter(out_), "{:.6e}", value);
            return;
        }
        // Millionths as an integer: written many times a block, and printf is ten times
        // as long.
        auto millionths = static_cast<std::int64_t>(std::llround(value * 1e6));
        if (millionths == 0) {
            out_ += '0';
            return;
        }
        if (millionths < 0) {
            out_ += '-';
            millionths = -millionths;
        }
        char digits[24];
        char* const end = digits + sizeof digits;
        char* at = end;
        std::int64_t whole = millionths / 1'000'000, rest = millionths % 1'000'000;
        if (rest) {
            int places = 6;
            while (rest % 10 == 0) {
                rest /= 10;
                --places;
            }
            for (; places; --places, rest /= 10) *--at = static_cast<char>('0' + rest % 10);
            *--at = '.';
        }
        do *--at = static_cast<char>('0' + whole % 10);
        while (whole /= 10);
        out_.append(at, end);
    }
    void append_text(std::string_view words) {
        out_ += '"';
        for (const char c : words) {
            switch (c) {
                case '"':
                    out_ += "\\\"";
                    break;
                case '\\':
                    out_ += "\\\\";
                    break;
                case '\n':
                    out_ += "\\n";
                    break;
                case '\t':
                    out_ += "\\t";
                    break;
                default:
                    if (static_cast<unsigned char>(c) < 0x20)
                        fmt::format_to(std::back_inserter(out_), "\\u{:04x}",
                                       static_cast<unsigned>(c));
                    else
                        out_ += c;
            }
        }
        out_ += '"';
    }
    void raw(std::string_view json) { out_ += json; }

private:
    std::string& out_;
};

void channel_set(Object& object, std::uint32_t set) {
    object.key("channels");
    object.raw("[");
    bool first = true;
    for (unsigned channel = 1; channel <= kMaxChannels; ++channel) {
        if (!(set >> (channel - 1) & 1u)) continue;
        object.raw(fmt::format("{}{}", first ? "" : ",", channel));
        first = false;
    }
    object.raw("]");
}

std::string_view shown_name(const ChannelAxis& axis) {
    return axis.named_y ? std::string_view("Y") : std::string_view(axis.name);
}

void axes(Object& object, std::string_view name, const MachineView& view, const AxisValues& values,
          bool shown, AxisSet swapped) {
    object.key(name);
    object.raw("{");
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const ChannelAxis& axis = view.axes[i];
        if (i) object.raw(",");
        object.append_text(shown ? shown_name(axis) : std::string_view(axis.name));
        object.raw(":");
        double value = shown && view.axes[i].diameter != ((swapped >> i & 1u) != 0)
                           ? values[i] * 2.0
                           : values[i];
        if (shown ? axis.rollover : axis.rollover || axis.rolls_over) {
            value -= std::floor(value / axis.rollover_deg) * axis.rollover_deg;
            if (axis.rollover_deg - value < kHalfUlp) value = 0.0;
        }
        object.append_number(value);
    }
    object.raw("}");
}

std::string_view kind_name(MoveKind kind) {
    switch (kind) {
        case MoveKind::Rapid:
            return "rapid";
        case MoveKind::Linear:
            return "linear";
        case MoveKind::ArcCw:
            return "cw";
        case MoveKind::ArcCcw:
            return "ccw";
        case MoveKind::Thread:
            return "thread";
        case MoveKind::Skip:
            return "skip";
        case MoveKind::Reference:
            return "reference";
    }
    return "";
}

std::string_view feed_name(FeedMode mode) {
    switch (mode) {
        case FeedMode::PerMinute:
            return "per_min";
        case FeedMode::PerRevolution:
            return "per_rev";
        case FeedMode::InverseTime:
            return "inverse_time";
        default:
            return {};
    }
}

void tool(Object& object, const BlockContext& at) {
    if (at.tool.number < 0 && at.tool.offset < 0 && at.tool.name.empty()) return;
    object.key("tool");
    object.raw("{");
    std::string_view comma;
    const auto integer = [&](std::string_view name, std::int64_t value) {
        object.raw(fmt::format("{}\"{}\":{}", comma, name, value));
        comma = ",";
    };
    if (at.tool.number >= 0) integer("number", at.tool.number);
    if (!at.tool.name.empty()) {
        object.raw(comma);
        object.raw("\"name\":");
        object.append_text(at.tool.name);
        comma = ",";
    }
    if (at.tool.offset >= 0) integer("offset", at.tool.offset);
    if (at.tool.edge >= 0) integer("edge", at.tool.edge);
    object.raw("}");
}

}  // namespace

void append_event(std::string& out, const EventScene& scene, const Move& move,
                  const BlockContext& at) {
    const MachineView& view = *scene.view;
    Object object(out, "move", scene, &at);
    object.text("kind", kind_name(move.kind));
    axes(object, "pos", view, move.pos, true, at.display_swapped);
    axes(object, "machine", view, move.machine, false, 0);
    if (move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw ||
        (move.kind == MoveKind::Thread && move.sweep != 0)) {
        object.key("centre");
        object.raw("{");
        object.append_text(shown_name(view.axes[move.plane_p]));
        object.raw(":");
        object.append_number(move.pos_centre_p);
        object.raw(",");
        object.append_text(shown_name(view.axes[move.plane_q]));
        object.raw(":");
        object.append_number(move.pos_centre_q);
        object.raw("}");
        object.number("radius", move.radius);
        if (move.turns) object.integer("turns", move.turns);
    }
    if (const std::string_view mode = feed_name(move.feed_mode); !mode.empty()) {
        object.key("feed");
        object.raw("{\"mode\":\"");
        object.raw(mode);
        object.raw("\",\"value\":");
        object.append_number(move.feed);
        object.raw("}");
    }
    if (move.kind == MoveKind::Thread) {
        object.number("lead", move.lead);
        object.number("start_angle", move.start_angle);
        if (move.starts) object.integer("starts", move.starts);
        if (move.lead_change != 0.0) object.number("lead_change", move.lead_change);
    }
    tool(object, at);
    if (at.comp != CompSide::Off) object.text("comp", at.comp == CompSide::Left ? "left" : "right");
    if (!at.cycle.empty()) object.text("cycle", at.cycle);
}

void append_event(std::string& out, const EventScene& scene, const Dwell& dwell,
                  const BlockContext& at) {
    Object object(out, "dwell", scene, &at);
    object.number(dwell.revolutions ? "revolutions" : "seconds", dwell.value);
}

void append_event(std::string& out, const EventScene& scene, const Aux& aux,
                  const BlockContext& at) {
    Object object(out, "aux", scene, &at);
    object.text("code", aux.text);
}

void append_event(std::string& out, const EventScene& scene, const Spindle& spindle,
                  const BlockContext& at) {
    if (spindle.silent) return;
    Object object(out, "spindle", scene, &at);
    if (spindle.mode == SpindleModeCode::Couple || spindle.mode == SpindleModeCode::Uncouple) {
        const bool couples = spindle.mode == SpindleModeCode::Couple;
        if (spindle.follower >= kMaxAxes)
            object.integer("spindle", spindle.follower - static_cast<int>(kMaxAxes) + 1);
        else
            object.integer("axis", spindle.follower + 1);
        object.text("mode", couples ? "synchronous" : "free");
        if (!couples) return;
        object.integer("master", spindle.spindle);
        object.number("value", spindle.turns / spindle.master_turns);
        return;
    }
    object.integer("spindle", spindle.spindle);
    std::string_view mode = "rpm";
    if (spindle.mode == SpindleModeCode::SurfaceSpeed)
        mode = "css";
    else if (spindle.mode == SpindleModeCode::Position)
        mode = "position";
    else if (spindle.mode == SpindleModeCode::Off)
        mode = "off";
    object.text("mode", mode);
    if (spindle.mode != SpindleModeCode::Off) object.number("value", spindle.value);
    if (spindle.turn != SpindleTurn::Stop)
        object.text("direction", spindle.turn == SpindleTurn::Cw ? "cw" : "ccw");
    if (spindle.limit > 0) object.number("limit", spindle.limit);
}

void append_event(std::string& out, const EventScene& scene, const Wait& wait,
                  const BlockContext& at) {
    if (wait.act == Wait::Act::Arrive) return;  // for what the channel has itself begun
    if (wait.act != Wait::Act::Meet) {
        Object object(out, "marker", scene, &at);
        if (wait.code >= 0) object.integer("code", wait.code);  // absent: all
        object.integer("value", wait.act == Wait::Act::SetMarker);
        return;
    }
    Object object(out, "wait", scene, &at);
    if (wait.marker.empty())
        object.integer("code", wait.code);
    else
        object.text("code", wait.marker);
    channel_set(object, wait.channels);
    object.text("kind", wait.flying ? "flying" : "stop");
}

void append_event(std::string& out, const EventScene& scene, const Variable& variable,
                  const BlockContext& at) {
    Object object(out, "variable", scene, &at);
    object.text("name", variable.name);
    if (variable.is_text)
        object.text("value", variable.text);
    else
        object.number("value", variable.value);
}

void append_event(std::string& out, const EventScene& scene, const OffsetWrite& offset,
                  const BlockContext& at) {
    Object object(out, "offset", scene, &at);
    object.text("table", offset.table);
    if (!offset.zero_name.empty()) object.text("name", offset.zero_name);
    object.integer("number", offset.number);
    object.text("axis", offset.axis);
    object.number("value", offset.value);
}

void append_event(std::string& out, const EventScene& scene, const Stop& stop,
                  const BlockContext& at) {
    Object object(out, "stop", scene, &at);
    std::string_view reason = "end";
    switch (stop.reason) {
        case StopReason::M00:
            reason = "M00";
            break;
        case StopReason::M01:
            reason = "M01";
            break;
        case StopReason::M02:
            reason = "M02";
            break;
        case StopReason::M30:
            reason = "M30";
            break;
        case StopReason::Held:
            reason = "held";
            break;
        case StopReason::Waiting:
            reason = "waiting";
            break;
        case StopReason::Restart:
            reason = "restart";
            break;
        case StopReason::Dialogue:
            reason = "dialogue";
            break;
        default:
            break;
    }
    object.text("reason", reason);
}

void append_event(std::string& out, const EventScene& scene, const Diagnosis& diagnosis,
                  const BlockContext& at) {
    Object object(out, "alarm", scene, nullptr);
    if (!diagnosis.place.file.empty())
        object.text("file", diagnosis.place.file);
    else if (scene.files && at.file < scene.files->count())
        object.text("file", scene.files->path(at.file));
    if (diagnosis.place.line) object.integer("line", diagnosis.place.line);
    if (at.block >= 0) object.integer("n", at.block);
    // A program's own alarm carries its number itself.
    const std::string_view number = alarm_number(diagnosis.alarm, scene.dialect);
    std::int64_t value = 0;
    bool digits = !number.empty();
    for (const char c : number) {
        digits = digits && c >= '0' && c <= '9';
        value = value * 10 + (c - '0');
    }
    if (diagnosis.alarm == Alarm::MacroAlarm)
        object.integer("number", static_cast<std::int64_t>(diagnosis.values[0]));
    else if (digits)
        object.integer("number", value);
    else
        object.text("number", number);
    object.text("text", diagnosis.text());
    const Severity severity = diagnosis.severity();
    object.text("severity", severity == Severity::Error     ? "error"
                            : severity == Severity::Warning ? "warning"
                                                            : "message");
    if (diagnosis.place.column) object.integer("column", diagnosis.place.column);
    if (!diagnosis.remedy().empty()) object.text("remedy", diagnosis.remedy());
}

void append_message_event(std::string& out, const EventScene& scene, std::string_view text,
                          const BlockContext& at) {
    Object object(out, "message", scene, &at);
    object.text("text", text);
}

void append_print_event(std::string& out, const EventScene& scene, std::string_view text,
                        const BlockContext& at) {
    Object object(out, "print", scene, &at);
    object.text("text", text);
}

void append_signal_event(std::string& out, const EventScene& scene, std::string_view name,
                         double value, const BlockContext& at) {
    if (const auto selection = selection_of(name)) {
        Object object(out, "select", scene, &at);
        object.integer("channel", selection->channel);
        object.text("program", selection->file);
    } else if (name == kStartSignal) {
        Object object(out, "start", scene, &at);
        channel_set(object, static_cast<std::uint32_t>(value));
    }
}

void append_part_event(std::string& out, const EventScene& scene, double count,
                       const BlockContext& at) {
    Object object(out, "part", scene, &at);
    object.number("count", count);
}

}  // namespace polyturn::channels
