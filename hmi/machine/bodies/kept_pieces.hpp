// What a restart of the screens shows again and is too large for a line of settings: the events of
// a dry run, the paths of the running part. Each in a file of its own, written aside and replaced
// whole. The newest is in memory too: another language makes the screens anew.
#pragma once
#include <QByteArray>
#include <QString>
#include <map>
#include <optional>

#include "hmi/machine/live/aside.hpp"

namespace polyturn::hmi {

class KeptPieces {
public:
    // Where files lie: what outlasts a start of the computer, and what means nothing after one.
    // Empty: in memory only.
    void in(const QString& lasting, const QString& passing) {
        lasting_ = lasting;
        passing_ = passing;
    }
    enum class Span : std::uint8_t { Lasting, Passing };
    void put(const QString& name, QByteArray piece, Span span);
    void tend();  // what came while an older one was written
    // Once it has been read; nothing: not yet. Empty: there is none.
    std::optional<QByteArray> get(const QString& name, Span span);
    ~KeptPieces();

private:
    struct Piece {
        std::optional<QByteArray> known;
        Span span{};
        bool written = true;
        Aside<QByteArray> reading;
        Aside<bool> writing;
    };
    QString fileOf(const QString& name, Span span) const;
    QString lasting_, passing_;
    std::map<QString, Piece> pieces_;
};

}  // namespace polyturn::hmi
