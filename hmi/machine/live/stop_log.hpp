// The log of stops as the store keeps it, for a period back from now: asked for while somebody
// looks, summed up by cause.
#pragma once
#include <QDateTime>
#include <QJsonArray>
#include <vector>

#include "hmi/machine/live/live.hpp"
#include "hmi/machine/live/requests.hpp"
#include "hmi/machine/live/tone.hpp"

namespace polyturn::hmi {

struct StopEntry {
    QDateTime begin;  // local time
    unsigned channel = 0;
    QString cause, number, detail, program;
    unsigned line = 0;
    double seconds = -1;  // negative: its end was not seen
    bool stands = false;  // it goes on
};

struct StopSum {
    QString cause;
    double seconds = 0;
    int count = 0;
};

class StopLog {
public:
    StopLog(Live& live, Requests& requests) : live_(live), requests_(requests) {}
    void setHours(int hours);  // how far back; asks anew
    int hours() const { return hours_; }
    void setChannel(unsigned channel);  // 0: all
    unsigned channel() const { return channel_; }
    void poll();  // some times a minute
    void forget();
    const std::vector<StopEntry>& all() const { return entries_; }  // the newest first
    std::vector<StopSum> sums() const;                              // the longest first
    const QString& whyNot() const { return whyNot_; }
    std::uint64_t version() const { return version_; }
    // another language: texts of alarms are translated anew
    void retell();

private:
    void take(const QJsonArray& stops);
    Live& live_;
    Requests& requests_;
    QJsonArray raw_;
    std::vector<StopEntry> entries_;
    QString whyNot_;
    int hours_ = 8;
    unsigned channel_ = 0;
    std::uint64_t version_ = 0;
    qint64 askAt_ = 0;
    bool asking_ = false;
};

StateWords stopWords(const QString& cause);
QString stopDetail(const StopEntry& stop);  // the alarm in the chosen language, whom it waits for

}  // namespace polyturn::hmi
