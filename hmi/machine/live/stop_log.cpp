#include "hmi/machine/live/stop_log.hpp"

#include <QFileInfo>
#include <QJsonObject>
#include <algorithm>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/text/display_languages.hpp"
#include "hmi/text/retold.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kAskEvery_ms = 2'000;
constexpr int kMost = 2'000;

}  // namespace

void StopLog::setHours(int hours) {
    hours_ = hours;
    askAt_ = 0;
}
void StopLog::setChannel(unsigned channel) {
    channel_ = channel;
    take(raw_);
}
void StopLog::forget() {
    raw_ = {};
    entries_.clear();
    askAt_ = 0;
    asking_ = false;
    ++version_;
}
void StopLog::retell() { ++version_; }

void StopLog::poll() {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (!live_.connected() || asking_ || now < askAt_) return;
    asking_ = true;
    askAt_ = now + kAskEvery_ms;
    const QString since =
        QDateTime::currentDateTimeUtc().addSecs(-3600LL * hours_).toString("yyyy-MM-ddTHH:mm:ss");
    requests_.store(
        {{"do", "stops.list"}, {"since", since}, {"most", kMost}},
        [this](const Answer& answer) {
            asking_ = false;
            whyNot_ = answer.ok ? QString() : answer.text;
            take(answer.object.value("stops").toArray());
        },
        true);
}

void StopLog::take(const QJsonArray& stops) {
    raw_ = stops;
    entries_.clear();
    std::uint32_t seen = 0;  // channels whose newest stop has been read
    for (const auto& value : stops) {
        const QJsonObject one = value.toObject();
        StopEntry entry{
            QDateTime::fromString(one.value("utc").toString(), Qt::ISODateWithMs).toLocalTime(),
            static_cast<unsigned>(one.value("channel").toInt()),
            one.value("cause").toString(),
            one.value("number").toString(),
            one.value("detail").toString(),
            QFileInfo(one.value("program").toString()).fileName(),
            static_cast<unsigned>(one.value("line").toInt()),
            one.value("seconds").toDouble(-1),
            false};
        if (entry.channel < 1 || entry.channel > kMaxChannels) continue;
        const bool newest = !(seen >> entry.channel & 1u);
        seen |= 1u << entry.channel;
        const auto state = static_cast<ChannelState>(live_.channel(entry.channel).state);
        if (entry.seconds < 0 && newest && state != ChannelState::Running &&
            state != ChannelState::Absent) {
            entry.stands = true;
            entry.seconds = std::max(
                0.0, static_cast<double>(entry.begin.msecsTo(QDateTime::currentDateTime())) / 1e3);
        }
        if (channel_ == 0 || entry.channel == channel_) entries_.push_back(std::move(entry));
    }
    ++version_;
}

std::vector<StopSum> StopLog::sums() const {
    std::vector<StopSum> out;
    for (const StopEntry& stop : entries_) {
        auto at = std::find_if(out.begin(), out.end(),
                               [&](const StopSum& one) { return one.cause == stop.cause; });
        if (at == out.end()) at = out.insert(out.end(), StopSum{stop.cause, 0, 0});
        at->seconds += std::max(0.0, stop.seconds);
        ++at->count;
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const StopSum& a, const StopSum& b) { return a.seconds > b.seconds; });
    return out;
}

StateWords stopWords(const QString& cause) {
    if (cause == "alarm") return {word("Alarm"), Sign::Alarm, Tone::Bad};
    if (cause == "emergency") return {word("Emergency stop"), Sign::Alarm, Tone::Bad};
    if (cause == "dead") return {word("Process dead"), Sign::Alarm, Tone::Bad};
    if (cause == "off") return {word("Machine off"), Sign::Off, Tone::Quiet};
    if (cause == "hold") return {word("Feed hold"), Sign::Hold, Tone::Warning};
    if (cause == "wait") return {word("Waits for a channel"), Sign::Wait, Tone::Waiting};
    if (cause == "program") return {word("Programmed stop"), Sign::Stop, Tone::Warning};
    if (cause == "single") return {word("Single block"), Sign::Stop, Tone::Note};
    if (cause == "operator") return {word("Work by hand"), Sign::Manual, Tone::Note};
    if (cause == "reset") return {word("Reset"), Sign::Reset, Tone::Quiet};
    return {word("No start"), Sign::Ended, Tone::Note};
}

QString stopDetail(const StopEntry& stop) {
    if (stop.number.isEmpty()) return stop.detail;
    return alarmNumberText(stop.number) + "  " + retold(stop.number, stop.detail).text;
}

}  // namespace polyturn::hmi
