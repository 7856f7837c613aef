#include "hmi/machine/live/channel_words.hpp"

#include <cmath>
#include <cstdio>

#include "hmi/machine/tools/edge_words.hpp"
#include "hmi/text/display_languages.hpp"
#include "ipc/requests/start_words.hpp"
#include "ipc/model/languages/wait_name.hpp"

namespace polyturn::hmi {

StateWords stateWords(const ChannelStatus& status) {
    switch (static_cast<ChannelState>(status.state)) {
        case ChannelState::Running:
            return {word("Runs"), Sign::Run, Tone::Good};
        case ChannelState::Held:
            return {word("Held"), Sign::Hold, Tone::Warning};
        case ChannelState::Waiting:
            return {word("Waits"), Sign::Wait, Tone::Waiting};
        case ChannelState::ProgramStop:
            return {word("Stopped"), Sign::Stop, Tone::Warning};
        case ChannelState::Ended:
            return {word("Ended"), Sign::Ended, Tone::Note};
        case ChannelState::Interrupted:
            return {word("Interrupted"), Sign::Alarm, Tone::Bad};
        case ChannelState::Dead:
            return {word("Process dead"), Sign::Alarm, Tone::Bad};
        case ChannelState::Reset:
            return {word("Reset"), Sign::Reset, Tone::Quiet};
        case ChannelState::Absent:
            break;
    }
    return {word("Absent"), Sign::Off, Tone::Quiet};
}

QString modeWord(std::uint32_t mode) {
    switch (static_cast<ChannelMode>(mode)) {
        case ChannelMode::Auto:
            return word("Automatic");
        case ChannelMode::Mdi:
            return word("MDI");
        case ChannelMode::Jog:
            return word("Jog");
        case ChannelMode::Handwheel:
            return word("Handwheel");
        case ChannelMode::Reference:
            return word("Reference");
    }
    return {};
}

QString waitWords(const Live& live, unsigned channel) {
    const ChannelStatus& status = live.channel(channel);
    if (status.wait_code == 0 && status.wait_missing == 0) return {};
    QStringList missing;
    for (unsigned other = 1; other <= kMaxChannels; ++other)
        if (status.wait_missing >> (other - 1) & 1u) missing << QString("L%1").arg(other);
    const QString since = timeText(live.seconds(live.status().tick - status.wait_since));
    const QString code = status.wait_code > 0
                             ? fromView(wait_name(live.language(channel), status.wait_code))
                             : word("a marker");
    return missing.isEmpty()
               ? word("Waits at %1, all are there").arg(code)
               : word("Waits at %1 for %2, %3 so far").arg(code, missing.join(" "), since);
}

bool lacksProgram(const Live& live, unsigned channel) {
    return (live.channel(channel).start_missing & kNothingToBegin) != 0;
}

bool works(const ChannelStatus& status) {
    const auto state = static_cast<ChannelState>(status.state);
    return state == ChannelState::Running || state == ChannelState::Held ||
           state == ChannelState::Waiting || state == ChannelState::ProgramStop;
}

std::vector<unsigned> groupsOf(const Live& live) {
    std::vector<unsigned> out;
    for (const unsigned channel : live.channels())
        out.push_back(live.config().channel(channel).group);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<unsigned> channelsOf(const Live& live, unsigned group) {
    std::vector<unsigned> out;
    for (const unsigned channel : live.channels())
        if (group == 0 || live.config().channel(channel).group == group) out.push_back(channel);
    return out;
}

unsigned groupOf(const Live& live, unsigned channel) {
    return groupsOf(live).size() > 1 ? live.config().channel(channel).group : 0;
}

StartPlan startPlan(const Live& live, unsigned group) {
    StartPlan out;
    QStringList programs;
    for (const unsigned channel : channelsOf(live, group)) {
        const ChannelStatus& status = live.channel(channel);
        const auto state = static_cast<ChannelState>(status.state);
        if (works(status))
            out.goOn.push_back(channel);
        else if (lacksProgram(live, channel))
            out.passed.push_back(channel);
        else if (state != ChannelState::Absent && state != ChannelState::Dead) {
            out.begin.push_back(channel);
            programs << QString("L%1=%2").arg(channel).arg(
                live.view(channel).programs.empty()
                    ? QString()
                    : QString::fromStdString(live.view(channel).programs[0]));
        }
    }
    out.subject = programs.join(' ');
    return out;
}

QString channelList(const std::vector<unsigned>& channels) {
    constexpr std::size_t kRange = 4;  // fewer in a row are named one by one
    QStringList out;
    for (std::size_t first = 0, behind = 0; first < channels.size(); first = behind) {
        behind = first + 1;
        while (behind < channels.size() && channels[behind] == channels[behind - 1] + 1) ++behind;
        if (behind - first >= kRange)
            out << QString::fromUtf8("L%1–L%2").arg(channels[first]).arg(channels[behind - 1]);
        else
            for (std::size_t i = first; i < behind; ++i) out << QString("L%1").arg(channels[i]);
    }
    return out.join(' ');
}

QStringList startNeeds(const Live& live, unsigned channel) {
    QStringList out;
    const std::uint32_t missing = live.channel(channel).start_missing;
    for (std::size_t row = 0; row < kStartWords.size(); ++row) {
        if (!(missing >> row & 1u)) continue;
        QString which;
        if (kStartWords[row].name == "referenced")
            for (std::size_t a = 0; a < live.config().last_axis; ++a) {
                const AxisConfig& axis = live.config().axes[a];
                if (axis.exists() && axis.channel == channel &&
                    !(live.status().axes[a].flags & kReferenced) && !axis.on_spindle)
                    which += fromView(axis.name_text()) + ' ';
            }
        out << which + word(kStartWords[row].text) + " (" + word(kStartWords[row].remedy) + ")";
    }
    return out;
}

bool storeHasLost(const Live& live) {
    return live.connected() &&
           std::any_of(live.channels().begin(), live.channels().end(), [&](unsigned channel) {
               return (live.channel(channel).start_missing & start_bit("store_whole")) != 0;
           });
}

Plight plight(const Live& live, const AlarmLog& alarms, unsigned channel) {
    if (const AlarmEntry* alarm = alarms.standing(channel))
        return {Plight::Kind::Alarm, alarm->number + "  " + alarm->text};
    const ChannelStatus& status = live.channel(channel);
    const auto state = static_cast<ChannelState>(status.state);
    // an aborted program does not wait
    const bool goesOn = state == ChannelState::Running || state == ChannelState::Held ||
                        state == ChannelState::ProgramStop;
    if (state == ChannelState::Waiting || (status.wait_missing && goesOn))
        return {Plight::Kind::Waits, waitWords(live, channel)};
    if (state != ChannelState::Running && status.start_missing)
        return {Plight::Kind::Needs,
                word("Start blocked:") + " " + startNeeds(live, channel).join("; ")};
    if (state == ChannelState::Held && status.mdi_waiting &&
        static_cast<ChannelMode>(status.mode) != ChannelMode::Mdi)
        return {Plight::Kind::Stands, word("A block entered by hand waits: start runs it")};
    if (const AlarmEntry* here =
            state == ChannelState::ProgramStop ? alarms.toldAt(channel, status.line) : nullptr)
        return {Plight::Kind::Stands, word("%1: start goes on").arg(here->text)};
    if (state == ChannelState::Held || state == ChannelState::ProgramStop) {
        switch (static_cast<StopReason>(status.stop_reason)) {
            case StopReason::M00:
                return {Plight::Kind::Stands, word("Programmed stop M0: start goes on")};
            case StopReason::M01:
                return {Plight::Kind::Stands, word("Optional stop M1: start goes on")};
            case StopReason::SingleBlock:
                return {Plight::Kind::Stands, word("Single block: start does the next one")};
            case StopReason::Restart:
                return {Plight::Kind::Stands, word("Restart: start makes the approach")};
            case StopReason::FirstPart:
                return {Plight::Kind::Stands, word("First part: start goes on with this tool")};
            case StopReason::Dialogue:
                return {Plight::Kind::Stands, word("The program asks: answer on its page")};
            case StopReason::Retrace:
                return {Plight::Kind::Stands, word("Retrace has come to its end")};
            default:
                return {Plight::Kind::Stands, word("Feed hold: start goes on")};
        }
    }
    const AlarmEntry* told = alarms.told(channel);
    if (!told) told = alarms.told(0);  // a note of the machine's builder
    if (told)
        return {Plight::Kind::Told,
                told->number.isEmpty() ? told->text : told->number + "  " + told->text};
    return {};
}

QString timeText(double seconds) {
    if (!(seconds >= 0) || seconds > 1e8) return QString::fromUtf8("–");
    const auto whole = static_cast<long>(seconds);
    if (whole < 3600) return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
    return QString("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QChar('0'))
        .arg(whole % 60, 2, 10, QChar('0'));
}

QString hoursText(double seconds) {
    const QString out = timeText(seconds);
    return out.count(':') == 1 ? (out.size() < 5 ? "0:0" : "0:") + out : out;
}

QString lengthText(double value, unsigned decimals) {
    if (!std::isfinite(value)) return QString::fromUtf8("–");
    const QString out = QString::number(value, 'f', static_cast<int>(decimals));
    const auto counts = [](QChar c) { return c >= '1' && c <= '9'; };
    // no -0.000
    return out.startsWith('-') && std::none_of(out.begin(), out.end(), counts) ? out.mid(1) : out;
}

double inTable(const AxisConfig& axis, double trueValue) {
    return axis.offset_diameter && !axis.rotary ? 2 * trueValue : trueValue;
}

double shown(const AxisConfig& axis, double trueValue) {
    return axis.diameter && !axis.rotary ? 2 * trueValue : trueValue;
}

double shownPlace(const AxisConfig& axis, double trueValue) {
    const double turn = axis.rollover_deg > 0 ? axis.rollover_deg : 360.0;
    return axis.rotary && (axis.rollover || axis.on_spindle)
               ? trueValue - std::floor(trueValue / turn) * turn
               : shown(axis, trueValue);
}

unsigned decimalsOf(const MachineConfig& machine, const AxisConfig& axis) {
    return axis.channel >= 1 && axis.channel <= kMaxChannels
               ? std::clamp(machine.channel(axis.channel).decimals(), 1u, 6u)
               : 3u;
}

QString channelTitle(const Live& live, unsigned channel) {
    const QString number = QString("L%1").arg(channel),
                  name = fromView(live.config().channel(channel).name_text());
    return name.isEmpty() || name == number ? number : number + "  " + name;
}

QString zeroTitle(const QString& name) {
    return name == "external" ? word("External") : name == "shift" ? word("Work shift") : name;
}

QString cellTitle(const QString& what) {
    const QStringList part = what.split(' ');
    int tool = 0, edge = 0, dp = 0;
    if (std::sscanf(what.toStdString().c_str(), "tool %d D%d DP%d", &tool, &edge, &dp) == 3)
        return QString("T%1  D%2  %3").arg(tool).arg(edge).arg(edgeParameterTitle(dp));
    if (part.size() == 3) return QString("%1  %2  %3").arg(part[0], zeroTitle(part[1]), part[2]);
    if (part.size() != 5 || part[1] != "offset") return what;
    const bool wear = part[3] == "wear";
    const QString field = part[4] == "R" ? (wear ? word("Wear R") : word("Radius"))
                          : part[4] == "T"
                              ? word("Tip")
                              : QString("%1 %2").arg(wear ? word("Wear") : word("Geom."), part[4]);
    return QString("%1  %2 %3  %4").arg(part[0], word("Offset"), part[2], field);
}

}  // namespace polyturn::hmi
