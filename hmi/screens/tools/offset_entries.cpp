#include "hmi/screens/tools/offset_entries.hpp"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/text/dates.hpp"

namespace polyturn::hmi {
namespace {
constexpr double kTurningTool = 500;  // of a new edge whose tool has no type
}  // namespace

OffsetEntries::OffsetEntries(Context& context, const OffsetTable& table)
    : context_(context), table_(table) {
    undo_.present = [this](const OffsetValue& value) { return presentOf(context_.live, value); };
    undo_.same = [](double a, double b) { return std::abs(a - b) <= 5e-7; };
    undo_.putBack = [this](const Undo::Change& change) {
        OffsetValue value = change.where;
        if (!value.gone.empty()) return setEdge(value, true);
        value.present = presentOf(context_.live, value);
        takeBack(value, change.old, change.now);
    };
    undo_.keep = [this](const Undo::Change& change, double there) {
        if (!change.where.gone.empty())
            return context_.tell(word("%1 has values again: they stay").arg(change.where.title),
                                 Told::Refused);
        context_.tell(
            word("%1 is %2 by now: it stays").arg(change.where.title, change.where.text(there)),
            Told::Refused);
    };
}

const AxisConfig& OffsetEntries::axisOf(const OffsetValue& value) const {
    const MachineConfig& machine = context_.live.config();
    return machine.axis(
        machine.channel(context_.channel).axes[static_cast<std::size_t>(value.place)]);
}

void OffsetEntries::put(const OffsetValue& value, double now) {
    const double old = value.present;
    undo_.asked();
    const auto done = [this, value, old, now](const Answer& answer) {
        if (!answer.ok) return undo_.refused();  // told already
        undo_.entered({value, old, now});
        tellEntered(value, old, now);
    };
    if (value.ofEdge())
        return askStore(
            value,
            {{"do", "offsets.set"}, {"dp", value.dp}, {"value", std::round(now * 1e9) / 1e9}},
            done);
    context_.requests.set(value.words + "=" + QString::number(now, 'f', 9), done);
}

void OffsetEntries::tellEntered(const OffsetValue& value, double old, double now) {
    context_.tell(
        QString::fromUtf8("%1: %2 → %3").arg(value.title, value.text(old), value.text(now)),
        Told::Good);
    if (onEntered) onEntered();
}

// The store adds: a measured part, another panel or the program may have written since this value
// was drawn.
void OffsetEntries::add(const OffsetValue& value, double delta) {
    undo_.asked();
    enterInStore(value, {{"delta", std::round(delta * 1e9) / 1e9}},
                 [this, value](const Answer& answer) { entered(value, answer); });
}

// Likewise: it puts the old value back only where the entered one still stands.
void OffsetEntries::takeBack(const OffsetValue& value, double old, double there) {
    undo_.asked();
    enterInStore(value, {{"value", std::round(old * 1e9) / 1e9}, {"expected", there}},
                 [this, value, old, there](const Answer& answer) {
                     if (!answer.ok) return undo_.refused();
                     undo_.takenBack({value, there, old});
                     tellEntered(value, there, old);
                 });
}

void OffsetEntries::enterInStore(const OffsetValue& value, QJsonObject entry,
                                 const std::function<void(const Answer&)>& done) {
    const QStringList words = value.words.split(' ');  // «offset L1 3 wear X», «zero L1 G54 Z»
    entry.insert("do", value.zero ? "zeros.set" : "offsets.set");
    if (value.zero) {
        entry.insert("channel", static_cast<int>(value.channel));
        entry.insert("zero", words[2]);
        entry.insert("field", words[3]);
        return context_.requests.store(entry, done);
    }
    if (value.ofEdge())
        entry.insert("dp", value.dp);
    else {
        entry.insert("table", words[3]);
        entry.insert("field", words[4]);
    }
    askStore(value, entry, done);
}

// An operation of the store on the chosen offset or edge; it reads table and field, an edge's also
// by the plane.
void OffsetEntries::askStore(const OffsetValue& value, QJsonObject request,
                             const std::function<void(const Answer&)>& done) {
    const unsigned channel = value.words.section(' ', 1, 1).mid(1).toUInt();
    request.insert("channel", static_cast<int>(channel));
    if (value.ofEdge()) {
        request.insert("tool", value.edge.tool);
        request.insert("edge", value.edge.edge);
        request.insert("plane", 17 + static_cast<int>(planeNow(context_.live, channel)));
    } else {
        request.insert("number", value.words.section(' ', 2, 2).toInt());
    }
    context_.requests.store(request, done);
}

// An operation of the store has entered it: what it says counts.
void OffsetEntries::entered(const OffsetValue& value, const Answer& answer) {
    if (!answer.ok) return undo_.refused();
    const double now = answer.object.value("new").toDouble(),
                 old = answer.object.contains("old") ? answer.object.value("old").toDouble()
                                                     : value.present;
    undo_.entered({value, old, now});
    context_.tell(
        QString::fromUtf8("%1: %2 → %3").arg(value.title, value.text(old), value.text(now)),
        Told::Good);
    if (onEntered) onEntered();
}

// The tool's tip is at a measured position: geometry (with the wear that there is) follows from
// where the axis is.
void OffsetEntries::measure(const OffsetValue& value, double typed) {
    if (table_.zeros() || value.place < 0) return;
    const ChannelView& view = context_.live.view(context_.channel);
    const auto place = static_cast<std::size_t>(value.place);
    const AxisConfig& axis = axisOf(value);
    double zero = 0;
    if (!context_.live.zeroNow(context_.channel, static_cast<unsigned>(place), zero))
        zero = context_.live.tableZero(
            context_.channel, static_cast<unsigned>(place),
            view.known ? view.picture.zero_row : static_cast<std::int32_t>(kZeroG54));
    // Where the axis is and what the wear is by then, the store knows best; which zero acts,
    // the program.
    const char* const field = axis.role == PlaneRole::BasicX   ? "X"
                              : axis.role == PlaneRole::BasicY ? "Y"
                                                               : "Z";
    undo_.asked();
    askStore(
        value,
        {{"do", "offsets.measure"},
         {"table",
          value.ofEdge() && value.dp >= kDpBase && value.dp <= kDpBase + 2 ? "second" : "geometry"},
         {"field", field},
         {"value", typed},
         {"zero_at", shown(axis, zero)}},
        [this, value](const Answer& answer) { entered(value, answer); });
}

// The position of the tool's tip is to be called so in this zero: its value follows from where the
// axis is.
void OffsetEntries::zeroHere(const OffsetValue& value, double typed) {
    if (!table_.zeros()) return;
    const ChannelView& view = context_.live.view(context_.channel);
    const auto place = static_cast<std::size_t>(value.place);
    const AxisConfig& axis = axisOf(value);
    // also of one that a program before has left
    const double tool = shown(axis, view.toolShift[place]);
    const QStringList words = value.words.split(' ');  // «zero L1 G54 Z»
    undo_.asked();
    context_.requests.store({{"do", "zeros.here"},
                             {"channel", static_cast<int>(context_.channel)},
                             {"zero", words[2]},
                             {"field", words[3]},
                             {"value", typed},
                             {"length", tool}},
                            [this, value](const Answer& answer) { entered(value, answer); });
}

// Whose length counts when a workpiece is touched: the probe's, that the channel works with now; 0:
// none.
int OffsetEntries::probe() const {
    const ChannelView& view = context_.live.view(context_.channel);
    return view.known ? std::max<int>(0, static_cast<int>(view.picture.geometry)) : 0;
}

// The store knows by axis and direction what was touched; of an offset only its number and table
// are said, of a zero its name, the probe and what the surface is to be.
void OffsetEntries::touched(const OffsetValue& value, std::optional<double> typed) {
    const QStringList words = value.words.split(' ');  // «offset L1 3 wear X», «zero L1 G54 Z»
    const auto done = [this, value](const Answer& answer) {
        const auto number = [&](const char* name) {
            return value.text(answer.object.value(name).toDouble());
        };
        if (answer.ok)
            context_.tell(QString::fromUtf8("%1: %2 → %3")
                              .arg(cellTitle(answer.object.value("what").toString()), number("old"),
                                   number("new")),
                          Told::Good);
        if (onEntered) onEntered();
    };
    if (!table_.zeros())
        return askStore(
            value, {{"do", "offsets.touch"}, {"table", value.wear() ? "wear" : "geometry"}}, done);
    QJsonObject request{{"do", "zeros.touch"}, {"channel", static_cast<int>(context_.channel)}};
    request.insert("zero", words[2]);
    // else the PLC says it
    if (!params::bit(context_.live.table(), params::n3016_tool_wp_setter_config, context_.channel,
                     0))
        request.insert("offset", probe());
    if (typed) request.insert("value", *typed);
    context_.requests.store(request, done);
}

void OffsetEntries::relativeZero() {
    context_.requests.store(
        {{"do", "offsets.origin"}, {"channel", static_cast<int>(context_.channel)}},
        [this](const Answer& answer) {
            if (answer.ok)
                context_.tell(word("The relative counter of L%1 begins here").arg(context_.channel),
                              Told::Good);
        });
}

void OffsetEntries::relativeInput(const OffsetValue& value) {
    if (table_.zeros() || value.place < 0) return;
    const AxisConfig& axis = axisOf(value);
    const char* const field = axis.role == PlaneRole::BasicX   ? "X"
                              : axis.role == PlaneRole::BasicY ? "Y"
                                                               : "Z";
    undo_.asked();
    askStore(value,
             {{"do", "offsets.relative"},
              {"table", value.wear() ? "wear" : "geometry"},
              {"field", field}},
             [this, value](const Answer& answer) { entered(value, answer); });
}

// Another edge of the chosen tool, of the same type.
void OffsetEntries::newEdge(const OffsetValue& value) {
    if (!value.ofEdge()) return;
    EdgeLine fresh{value.edge.tool, 0};
    for (const EdgeLine& one : table_.edges())
        if (one.tool == fresh.tool && edgeOf(context_.live, one))
            fresh.edge = std::max(fresh.edge, one.edge);
    ++fresh.edge;
    const double type = edgeValue(context_.live, value.edge, kDpType);
    context_.requests.store(
        {{"do", "offsets.set"},
         {"channel", static_cast<int>(context_.channel)},
         {"tool", fresh.tool},
         {"edge", fresh.edge},
         {"dp", kDpType},
         {"value", type ? type : kTurningTool}},
        [this, fresh](const Answer& answer) {
            if (answer.ok)
                context_.tell(word("%1 is new").arg(edgeTitle(context_.live, fresh)), Told::Good);
        });
}

void OffsetEntries::deleteEdge(const OffsetValue& value) {
    const ToolEdge* edge = value.ofEdge() ? edgeOf(context_.live, value.edge) : nullptr;
    if (!edge) return;
    OffsetValue whole = value;
    whole.title = edgeTitle(context_.live, value.edge);
    whole.dp = 0;
    whole.present = 1;
    whole.words = QString("edge L%1 T%2 D%3 DP0")
                      .arg(context_.channel)
                      .arg(value.edge.tool)
                      .arg(value.edge.edge);
    for (std::size_t dp = 1; dp < edge->dp.size(); ++dp)
        if (edge->dp[dp] != 0) whole.gone.emplace_back(static_cast<int>(dp), edge->dp[dp]);
    setEdge(whole, false);
}

// In one request, so that an edge is there whole or not at all. What no value is left of is no edge
// any more.
void OffsetEntries::setEdge(const OffsetValue& value, bool undone) {
    QJsonObject fields;
    for (const auto& [dp, held] : value.gone)
        fields.insert(QString("D%1.DP%2").arg(value.edge.edge).arg(dp), undone ? held : 0.0);
    undo_.asked();
    context_.requests.store(
        {{"do", "tools.set"}, {"tool", value.edge.tool}, {"fields", fields}},
        [this, value, undone](const Answer& answer) {
            if (!answer.ok) return undo_.refused();
            if (undone)
                undo_.takenBack({value, 0, 1});
            else
                undo_.entered({value, 1, 0});
            context_.tell(
                (undone ? word("%1 is there again") : word("%1 is deleted")).arg(value.title),
                Told::Good);
            if (onEdge) onEdge();
        });
}

// Who has changed it before, since the store was begun.
void OffsetHistory::ask(const std::optional<OffsetValue>& value) {
    lines_.clear();
    of_ = value ? value->words : QString();
    if (!value || !context_.live.connected()) return;
    const QStringList words = value->words.split(' ');
    const QString about =
        value->ofEdge()
            ? QString("tool %1 D%2 DP%3").arg(value->edge.tool).arg(value->edge.edge).arg(value->dp)
        : value->zero ? QString("%1 %2 place %3").arg(words[1], words[2]).arg(value->place + 1)
                      : QString("%1 offset %2 %3 %4").arg(words[1], words[2], words[3], words[4]);
    context_.requests.store(
        {{"do", "history.list"}, {"of", about}, {"most", 40}},
        [this, of = of_, value = *value](const Answer& answer) {
            if (!answer.ok || of_ != of) return;
            lines_.clear();  // it may have been asked for twice
            for (const auto& entry : answer.object.value("history").toArray()) {
                const QJsonObject one = entry.toObject();
                const auto number = [&](const char* name) {
                    return value.text(one.value(name).toString().toDouble());
                };
                lines_ << QString::fromUtf8("%1  %2: %3 → %4")
                              .arg(shortMomentText(QDateTime::fromString(
                                                       one.value("utc").toString(), Qt::ISODate)
                                                       .toLocalTime(),
                                                   "HH:mm"),
                                   one.value("who").toString(), number("old"), number("new"));
            }
            if (onCome) onCome();
        },
        true);
}

}  // namespace polyturn::hmi
