#include "hmi/machine/alarm_book.hpp"

#include <QFileInfo>
#include <QJsonArray>

#include "hmi/text/retold.hpp"
#include "hmi/text/tongues.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kAskEveryMs = 250;
constexpr std::size_t kKept = 1000;
constexpr int kToldAFrame = 40, kEarlierAtOnce = 200;

}  // namespace

void AlarmBook::poll() {
    if (live_.generation() != generation_) {
        generation_ = live_.generation();
        forget();
        asking_ = false;
        ++version_;
    }
    if (!live_.connected()) return;
    tellSome();
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
    heard_ = true;
    const qint64 next = static_cast<qint64>(answer.value("next").toDouble());
    if (next < next_) forget();   // another supervisor
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
    untold_ = entries_.size();
    tellSome();
    look();
}

// A thousand of a long shift are too many for a frame: the newest first, some in each.
void AlarmBook::tellSome() {
    int left = kToldAFrame;
    const auto tell = [&](AlarmEntry& entry, const QJsonObject& event) {
        QString text = event.value("text").toString();
        const QJsonObject builder = event.value("builder").toObject(), own = builder.value(codeOf(spoken())).toObject();   // the machine builder's messages bring their languages
        if (!own.isEmpty()) text.replace(builder.value("told").toString(), own.value("text").toString());
        const RetoldWords words = hmi::retold(entry.number, text);
        entry.text = words.text, entry.remedy = own.value("remedy").toString(words.remedy), entry.told = true;
        ++version_, --left;
    };
    for (; untold_ > 0 && left > 0; --untold_) {
        AlarmEntry& entry = entries_[untold_ - 1];
        if (entry.told) continue;
        tell(entry, events_[untold_ - 1]);
    }
    for (; toldEarlier_ < earlier_.size() && left > 0; ++toldEarlier_) tell(earlier_[toldEarlier_], earlierEvents_[toldEarlier_]);
}

void AlarmBook::forget() {
    entries_.clear(), events_.clear(), earlier_.clear(), earlierEvents_.clear();
    untold_ = toldEarlier_ = 0, next_ = 0;
    heard_ = earlierAll_ = false;
    ++version_;
}

// Before the oldest that the controller itself still knows.
void AlarmBook::askEarlier() {
    if (!heard_ || earlierAsked_ || earlierAll_ || !live_.connected()) return;
    QJsonObject request{{"do", "alarms.list"}, {"most", kEarlierAtOnce}};
    if (!events_.empty()) request.insert("before_utc", events_.front().value("utc"));
    if (!earlierEvents_.empty()) request.insert("before_id", earlierEvents_.back().value("id"));
    earlierAsked_ = true;
    requests_.store(request, [this, generation = generation_, after = earlier_.size()](const Answer& answer) {
        earlierAsked_ = false;
        if (generation != generation_ || after != earlier_.size()) return;
        const QJsonArray more = answer.object.value("alarms").toArray();
        earlierAll_ = !answer.ok || more.size() < kEarlierAtOnce;
        for (const auto& one : more) {
            earlierEvents_.push_back(one.toObject());
            earlier_.push_back(read(earlierEvents_.back()));
        }
        ++version_;
    }, true);
}

void AlarmBook::retold() {
    for (AlarmEntry& entry : entries_) entry.told = false;
    untold_ = entries_.size(), toldEarlier_ = 0;
    earlierAsked_ = false;   // an answer for the screens before does not come
    tellSome();
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
    return out;   // it speaks English, the numbers of its control: tellSome() finds the row that reads so
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
