#include "hmi/machine/live/alarm_log.hpp"

#include <QFileInfo>
#include <QJsonArray>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <chrono>
#include <set>
#include <tuple>
#include <utility>

#include "hmi/text/display_languages.hpp"
#include "hmi/text/retold.hpp"
#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kAskEveryMs = 250;
constexpr std::size_t kKept = 1000;
// an alarm may be heard of before the image shows the standstill, and behind it
constexpr qint64 kSettleMs = 2'000;
constexpr qint64 kRefusalMs = 20'000;
constexpr double kFresh_s = 2;
constexpr qint64 kBeforeMs = -1'000'000'000;  // heard before these screens
constexpr int kToldAFrame = 40, kEarlierAtOnce = 200;

qint64 steadyMs() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

bool isAlarm(const QString& number, Alarm alarm) {
    const std::string_view wanted = alarm_number(alarm, Dialect::Polyturn);
    return number == QString::fromUtf8(wanted.data(), static_cast<qsizetype>(wanted.size()));
}

}  // namespace

void AlarmLog::poll() {
    if (live_.generation() != generation_) {
        generation_ = live_.generation();
        forget();
        asking_ = false;
        ++version_;
    }
    if (!live_.connected()) return;
    tellSome();
    look();
    const qint64 now = steadyMs();
    if (asking_ || now - asked_ms_ < kAskEveryMs) return;
    asking_ = true;
    asked_ms_ = now;
    requests_.ask({{"do", "alarms"}, {"since", next_}},
                  [this, generation = generation_](const Answer& answer) {
                      asking_ = false;
                      if (answer.ok && generation == generation_) take(answer.object);
                  });
}

void AlarmLog::take(const QJsonObject& answer) {
    const bool first = !std::exchange(heard_, true);
    const qint64 next = static_cast<qint64>(answer.value("next").toDouble());
    if (next < next_)
        forget();  // another supervisor
    else
        next_ = next;
    for (const auto& one : answer.value("alarms").toArray()) {
        events_.push_back(one.toObject());
        entries_.push_back(read(events_.back()));
        // One that has just been reported: resets that its stamp does not have yet came before it.
        // Wrong for a reset within this moment behind it, which is then pressed once more: rather
        // an alarm too long than one that is not seen. Screens that open in this moment do the
        // same.
        AlarmEntry& entry = entries_.back();
        const bool fresh = live_.seconds(live_.status().tick) - entry.seconds < kFresh_s;
        entry.heard_ms = first && !fresh ? kBeforeMs : steadyMs();
        entry.placed = first && !fresh;
        if (fresh && entry.resets >= 0 && entry.channel >= 1 && entry.channel <= kMaxChannels)
            entry.resets = std::max(entry.resets,
                                    static_cast<int>(live_.nc(signals::cn_reset(entry.channel))));
        ++version_;
    }
    if (entries_.size() > kKept) {
        entries_.erase(entries_.begin(), entries_.end() - kKept);
        events_.erase(events_.begin(), events_.end() - kKept);
    }
    untold_ = entries_.size();
    tellSome();
    // what the machine had reported before these screens: what belongs to this stop is active;
    // where nobody knows that any more, the newest may
    if (first) {
        const double since = live_.stoppedSince();
        bool newest = true;
        for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
            if (entry->channel == 0 && entry->severity == Severity::Error && !entry->builder) {
                const bool last = std::exchange(newest, false);
                entry->over |= since >= 0 ? entry->seconds < since - kSettleMs * 1e-3 : !last;
            }
    }
    look();
}

// A thousand of a long shift are too many for a frame: the newest first, some in each.
void AlarmLog::tellSome() {
    int left = kToldAFrame;
    const auto tell = [&](AlarmEntry& entry, const QJsonObject& event) {
        QString text = event.value("text").toString();
        // the machine builder's messages bring their languages
        const QJsonObject builder = event.value("builder").toObject(),
                          own = builder.value(codeOf(spoken())).toObject();
        if (!own.isEmpty())
            text.replace(builder.value("told").toString(), own.value("text").toString());
        const RetoldWords words = hmi::retold(entry.number, text);
        entry.text = words.text;
        entry.remedy = own.value("remedy").toString(words.remedy);
        entry.told = true;
        ++version_;
        --left;
    };
    for (; untold_ > 0 && left > 0; --untold_) {
        AlarmEntry& entry = entries_[untold_ - 1];
        if (entry.told) continue;
        tell(entry, events_[untold_ - 1]);
    }
    for (; toldEarlier_ < earlier_.size() && left > 0; ++toldEarlier_)
        tell(earlier_[toldEarlier_], earlierEvents_[toldEarlier_]);
}

void AlarmLog::forget() {
    entries_.clear();
    events_.clear();
    earlier_.clear();
    earlierEvents_.clear();
    untold_ = toldEarlier_ = 0;
    next_ = 0;
    heard_ = earlierAll_ = false;
    ++version_;
}

// Before the oldest that the controller itself still knows.
void AlarmLog::askEarlier() {
    if (!heard_ || earlierAsked_ || earlierAll_ || !live_.connected()) return;
    QJsonObject request{{"do", "alarms.list"}, {"most", kEarlierAtOnce}};
    if (!events_.empty()) request.insert("before_utc", events_.front().value("utc"));
    if (!earlierEvents_.empty()) request.insert("before_id", earlierEvents_.back().value("id"));
    earlierAsked_ = true;
    requests_.store(
        request,
        [this, generation = generation_, after = earlier_.size()](const Answer& answer) {
            earlierAsked_ = false;
            if (generation != generation_ || after != earlier_.size()) return;
            const QJsonArray more = answer.object.value("alarms").toArray();
            earlierAll_ = !answer.ok || more.size() < kEarlierAtOnce;
            for (const auto& one : more) {
                earlierEvents_.push_back(one.toObject());
                earlier_.push_back(read(earlierEvents_.back()));
            }
            ++version_;
        },
        true);
}

void AlarmLog::retold() {
    for (AlarmEntry& entry : entries_) entry.told = false;
    untold_ = entries_.size();
    toldEarlier_ = 0;
    earlierAsked_ = false;  // an answer for the screens before does not come
    tellSome();
    look();
    ++version_;
}

AlarmEntry AlarmLog::read(const QJsonObject& event) const {
    AlarmEntry out;
    out.channel = static_cast<unsigned>(event.value("ch").toInt());
    out.text = event.value("text").toString();
    const QString severity = event.value("severity").toString();
    out.severity = severity == "error"     ? Severity::Error
                   : severity == "warning" ? Severity::Warning
                                           : Severity::Message;
    const QJsonValue number = event.value("number");
    out.number =
        alarmNumberText(number.isDouble() ? QString::number(number.toInt()) : number.toString());
    out.refusal = isAlarm(out.number, Alarm::NotReady);
    // as alarms.csv has them in English
    static const QRegularExpression kBuilders("^(?:message|note) (\\d+) ");
    if (isAlarm(out.number, Alarm::BuilderMessage) || isAlarm(out.number, Alarm::BuilderNote))
        out.builder = kBuilders.match(out.text).captured(1).toInt();
    out.seconds = event.value("t").toDouble();
    out.when = QDateTime::fromString(event.value("utc").toString(), Qt::ISODate);
    out.resets = event.value("resets").toInt(-1);
    out.file = event.value("file").toString();
    if (!out.file.isEmpty()) out.place = QFileInfo(out.file).fileName();
    out.line = static_cast<std::uint32_t>(event.value("line").toInt());
    // the kernel's own do not name the file
    if (out.line)
        out.place += out.place.isEmpty() ? QString("%1 %2").arg(word("line")).arg(out.line)
                                         : QString(":%1").arg(out.line);
    // it speaks English, the numbers of its control: tellSome() finds the row that reads so
    return out;
}

void AlarmLog::look() {
    const auto step = static_cast<MachineStep>(live_.status().step);
    const bool stopped = step == MachineStep::EmergencyStop || step == MachineStep::Stopped;
    const qint64 now = steadyMs();
    if (std::exchange(stopped_, stopped) != stopped) stopped_ms_ = now;
    bool changed = false;
    // the newest of each
    std::array<const AlarmEntry*, kMaxChannels + 1> error{}, refusal{}, warning{}, message{};
    for (const AlarmEntry& entry : entries_)
        if (entry.channel <= kMaxChannels && !entry.builder)
            (entry.refusal                         ? refusal
             : entry.severity == Severity::Error   ? error
             : entry.severity == Severity::Warning ? warning
                                                   : message)[entry.channel] = &entry;
    // the same again says no more than its newest
    std::set<std::tuple<unsigned, QString, QString>> named;
    for (auto at = entries_.rbegin(); at != entries_.rend(); ++at) {
        AlarmEntry& entry = *at;
        bool standing = false;
        if (entry.refusal && now - entry.heard_ms > kRefusalMs) entry.over = true;
        if (entry.builder) {
            standing =
                entry.builder == live_.plc(entry.severity == Severity::Error ? signals::plc_alarm()
                                                                             : signals::plc_note());
        } else if (entry.channel == 0) {
            entry.over |= !stopped && now - entry.heard_ms > kSettleMs;
            standing = entry.severity == Severity::Error && stopped && !entry.over;
        } else if (entry.channel <= kMaxChannels) {
            const std::int32_t resets = live_.nc(signals::cn_reset(entry.channel));
            // The count that an alarm brings may be that of the PLC cycle before: a reset just
            // before it is in the first one behind it.
            if (!entry.placed && live_.seconds(live_.inputs().tick) >= entry.seconds) {
                entry.placed = true;
                if (entry.resets >= 0 && entry.resets + 1 == resets) entry.resets = resets;
            }
            const bool ofThisStop = stopped && !entry.refusal &&
                                    entry.severity == Severity::Error &&
                                    entry.heard_ms >= stopped_ms_ - kSettleMs;
            // for ever: a stop later on does not bring it back
            if (entry.placed && entry.resets < resets && !ofThisStop) entry.over = true;
            const ChannelStatus& status = live_.channel(entry.channel);
            const auto state = static_cast<ChannelState>(status.state);
            const bool works = state == ChannelState::Running || state == ChannelState::Held ||
                               state == ChannelState::Waiting || state == ChannelState::ProgramStop;
            switch (entry.severity) {
                // What was only refused has stopped nothing: the newest one is shown for a while,
                // then the channel's own state again.
                case Severity::Error:
                    if (entry.refusal)
                        standing = refusal[entry.channel] == &entry;
                    else
                        standing = stopped || live_.nc(signals::cn_alarm(entry.channel)) != 0 ||
                                   error[entry.channel] == &entry;
                    break;
                case Severity::Warning:
                    standing = warning[entry.channel] == &entry;
                    break;
                // #3006 until the start that goes on; an MSG until the next one
                case Severity::Message:
                    if (state == ChannelState::ProgramStop && status.line == entry.line)
                        entry.held = true;
                    else if (entry.held && state == ChannelState::Running)
                        entry.over = true;
                    standing = message[entry.channel] == &entry && works && !entry.text.isEmpty();
            }
            standing = standing && !entry.over && (entry.resets == resets || ofThisStop);
        }
        standing = standing && named.insert({entry.channel, entry.number, entry.text}).second;
        if (standing != entry.standing) {
            entry.standing = standing;
            changed = true;
        }
    }
    if (changed) ++version_;
}

const AlarmEntry* AlarmLog::standing(unsigned channel) const {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
        if (entry->standing && entry->severity == Severity::Error &&
            (channel == 0 || entry->channel == channel))
            return &*entry;
    return nullptr;
}

const AlarmEntry* AlarmLog::told(unsigned channel) const {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
        if (entry->standing && entry->severity != Severity::Error && entry->channel == channel)
            return &*entry;
    return nullptr;
}

const AlarmEntry* AlarmLog::toldAt(unsigned channel, std::uint32_t line) const {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
        if (entry->standing && entry->severity == Severity::Message && entry->channel == channel &&
            entry->line == line)
            return &*entry;
    return nullptr;
}

std::size_t AlarmLog::standingCount() const {
    return static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.end(), [](const AlarmEntry& entry) {
            return entry.standing && entry.severity == Severity::Error;
        }));
}

}  // namespace polyturn::hmi
