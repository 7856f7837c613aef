// Alarms, warnings and messages since the controller started: read from the supervisor, told in the chosen language. Which of them
// stand is seen from the image: an alarm of a channel until that channel's next reset, one of the machine until it is ready again.
#pragma once
#include <QDateTime>
#include <QJsonObject>
#include <QString>
#include <vector>

#include "hmi/machine/live.hpp"
#include "hmi/machine/requests.hpp"

namespace polyturn::hmi {

struct AlarmEntry {
    unsigned channel = 0;        // 0: the machine
    Severity severity = Severity::Error;
    QString number, text, remedy, place;   // place: program and line
    double seconds = 0;          // since the start of the kernel
    QDateTime when;
    std::int32_t resets = -1;
    bool standing = false;
};

class AlarmBook {
public:
    AlarmBook(Live& live, Requests& requests) : live_(live), requests_(requests) {}
    void poll();                                       // asks for what is new, some times a second
    const std::vector<AlarmEntry>& all() const { return entries_; }   // the newest last
    // The newest that stands: of a channel (0: of all); nullptr when there is none.
    const AlarmEntry* standing(unsigned channel = 0) const;
    std::size_t standingCount() const;
    std::uint64_t version() const { return version_; }
    void retold();                                     // the language has changed

private:
    void take(const QJsonObject& answer);
    AlarmEntry read(const QJsonObject& event) const;
    void look();

    Live& live_;
    Requests& requests_;
    std::vector<AlarmEntry> entries_;
    std::vector<QJsonObject> events_;
    std::uint64_t version_ = 0, generation_ = 0;
    qint64 next_ = 0, asked_ms_ = 0;
    bool asking_ = false;
};

}  // namespace polyturn::hmi
