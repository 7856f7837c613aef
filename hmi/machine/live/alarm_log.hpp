// Alarms, warnings and messages since the controller started: read from the supervisor, translated
// into the chosen language. Which of them are active is seen from the image: an alarm of a channel
// until that channel's next reset (of a machine stop: as long as the stop, too), one of the
// machine until it is ready again, a message until the program goes on, ends or sends another one,
// a warning until the next reset, a refused key for a while, the machine builder's messages as long
// as his PLC program sends them.
#pragma once
#include <QDateTime>
#include <QJsonObject>
#include <QString>
#include <vector>

#include "hmi/machine/live/live.hpp"
#include "hmi/machine/live/requests.hpp"

namespace polyturn::hmi {

struct AlarmEntry {
    unsigned channel = 0;  // 0: the machine
    Severity severity = Severity::Error;
    QString number, text, remedy, place;  // place: program and line
    double seconds = 0;                   // since the start of the kernel
    QDateTime when;
    std::int32_t resets = -1;
    bool standing = false;
    QString file;            // of the program, whole; empty: nobody has named it
    std::uint32_t line = 0;  // of the program
    // the program has stopped at it; it is stopped no more, whatever the image says
    bool held = false, over = false;
    qint64 heard_ms = 0;   // by a clock that is never set; long ago: before these screens
    bool placed = false;   // `resets` is certain
    int builder = 0;       // number of the machine builder's message; 0: none of his
    bool refusal = false;  // a key that could not be obeyed: nothing has happened
    bool told = false;     // text and remedy are in the language of the screens
};

class AlarmLog {
public:
    AlarmLog(Live& live, Requests& requests) : live_(live), requests_(requests) {}
    void poll();  // asks for what is new, some times a second
    // since the controller started, the newest last
    const std::vector<AlarmEntry>& all() const { return entries_; }
    // Of the days before, from the store: the newest first, more of them each time.
    void askEarlier();
    const std::vector<AlarmEntry>& earlier() const { return earlier_; }
    // The newest active alarm: of a channel (0: of all); nullptr when there is none.
    const AlarmEntry* standing(unsigned channel = 0) const;
    // what a program or the machine's builder wants to be read while the channel works
    const AlarmEntry* told(unsigned channel) const;
    // the program's message there
    const AlarmEntry* toldAt(unsigned channel, std::uint32_t line) const;
    std::size_t standingCount() const;
    std::uint64_t version() const { return version_; }
    void retold();  // the language has changed

private:
    void take(const QJsonObject& answer);
    AlarmEntry read(const QJsonObject& event) const;
    void tellSome();
    void forget();
    void look();

    Live& live_;
    Requests& requests_;
    std::vector<AlarmEntry> entries_;
    std::vector<QJsonObject> events_;
    std::vector<AlarmEntry> earlier_;
    std::vector<QJsonObject> earlierEvents_;
    // heard: what the controller itself knows
    bool heard_ = false, earlierAsked_ = false, earlierAll_ = false;
    std::uint64_t version_ = 0, generation_ = 0;
    std::size_t untold_ = 0;       // entries from the oldest on that may be unreported
    std::size_t toldEarlier_ = 0;  // of the days before: so many from the newest on are reported
    qint64 next_ = 0, asked_ms_ = 0, stopped_ms_ = 0;
    bool stopped_ = false;  // the machine, when looked at last
    bool asking_ = false;
};

}  // namespace polyturn::hmi
