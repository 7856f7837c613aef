#include "hmi/machine/alarm_book.hpp"

#include <QFileInfo>
#include <QJsonArray>

#include "hmi/text/retold.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kAskEveryMs = 250;
constexpr std::size_t kKept = 1000;

}  // namespace

void AlarmBook::poll() {
    if (live_.generation() != generation_) {
        generation_ = live_.generation();
        entries_.clear(), events_.clear();
        next_ = 0;
        asking_ = false;
        ++version_;
    }
    if (!live_.connected()) return;
    look();
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (asking_ || now - asked_ms_ < kAskEveryMs) return;
    asking_ = true;
    asked_ms_ = now;
    requests_.ask({{"do", "alarms"}, {"since", next_}}, [this, generation = generation_](const Answer& answer) {
        asking_ = false;
        if (answer.ok && generation == generation_) take(answer.object);
    });
}

void AlarmBook::take(const QJsonObject& answer) {
    const qint64 next = static_cast<qint64>(answer.value("next").toDouble());
    if (next < next_) next_ = 0, entries_.clear(), events_.clear();   // another supervisor
    else next_ = next;
    for (const auto& one : answer.value("alarms").toArray()) {
        events_.push_back(one.toObject());
        entries_.push_back(read(events_.back()));
        ++version_;
    }
    if (entries_.size() > kKept) {
        entries_.erase(entries_.begin(), entries_.end() - kKept);
        events_.erase(events_.begin(), events_.end() - kKept);
    }
    look();
}

void AlarmBook::retold() {
    for (std::size_t i = 0; i < events_.size(); ++i) entries_[i] = read(events_[i]);
    look();
    ++version_;
}

AlarmEntry AlarmBook::read(const QJsonObject& event) const {
    AlarmEntry out;
    out.channel = static_cast<unsigned>(event.value("ch").toInt());
    out.text = event.value("text").toString();
    const QString severity = event.value("severity").toString();
    out.severity = severity == "error" ? Severity::Error : severity == "warning" ? Severity::Warning : Severity::Message;
    const QJsonValue number = event.value("number");
    out.number = number.isDouble() ? QString::number(number.toInt()) : number.toString();
    out.seconds = event.value("t").toDouble();
    out.when = QDateTime::fromString(event.value("utc").toString(), Qt::ISODate);
    out.resets = event.value("resets").toInt(-1);
    if (event.contains("file")) out.place = QFileInfo(event.value("file").toString()).fileName();
    if (event.contains("line")) out.place += QString(":%1").arg(event.value("line").toInt());
    // The event speaks English and the numbers of its control; the row that reads so is told in our language.
    const RetoldWords words = hmi::retold(out.number, out.text);
    out.text = words.text, out.remedy = words.remedy;
    return out;
}

void AlarmBook::look() {
    const auto step = static_cast<MachineStep>(live_.status().step);
    bool changed = false;
    std::array<const AlarmEntry*, kMaxChannels + 1> newest{};
    for (const AlarmEntry& entry : entries_)
        if (entry.channel <= kMaxChannels) newest[entry.channel] = &entry;
    for (AlarmEntry& entry : entries_) {
        bool standing = false;
        if (entry.channel == 0) {
            standing = entry.severity == Severity::Error && (step == MachineStep::EmergencyStop || step == MachineStep::Stopped) && newest[0] == &entry;
        } else if (entry.channel <= kMaxChannels && entry.resets == live_.nc(signals::cn_reset(entry.channel))) {
            // What was only refused or told does not stop anything: the newest one is shown until the next reset.
            standing = entry.severity == Severity::Error && (live_.nc(signals::cn_alarm(entry.channel)) != 0 || newest[entry.channel] == &entry);
        }
        if (standing != entry.standing) entry.standing = standing, changed = true;
    }
    if (changed) ++version_;
}

const AlarmEntry* AlarmBook::standing(unsigned channel) const {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
        if (entry->standing && (channel == 0 || entry->channel == channel)) return &*entry;
    return nullptr;
}

std::size_t AlarmBook::standingCount() const {
    std::size_t count = 0;
    for (const AlarmEntry& entry : entries_) count += entry.standing;
    return count;
}

}  // namespace polyturn::hmi
