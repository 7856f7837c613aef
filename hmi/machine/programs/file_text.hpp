// A file read or written whole, in pieces that can be stopped: by workers (machine/aside.hpp), for
// it may lie on a network that hangs.
#pragma once
#include <QByteArray>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>

#include "hmi/machine/programs/file_work.hpp"

namespace polyturn::hmi {

// Of a file that is too long to be edited at once, the part that is: whole lines. Of all others,
// all of it.
struct FilePart {
    qint64 from = 0, to = 0, all = 0;  // bytes
    qint64 line = 0;                   // lines before it
    qint64 written_ns = 0;             // when the file was written last
    bool whole() const { return from == 0 && to == all; }
};
struct FileText {
    enum class Kind : std::uint8_t {
        Read,
        Unreadable,
        TooLarge,
        NoText,
        Stopped
    } kind = Kind::Unreadable;
    QString text;  // its lines end with \n
    QString path;  // as the system knows the file: links followed
    FilePart part;
    bool dos = false;  // ... with \r\n in the file
};
// Of UTF-8; what would not come back the same when it is written again is NoText.
FileText readText(const QString& path, qint64 most, FileProgress& progress,
                  const std::atomic<bool>& stop);
// Likewise; of a file longer than `most` the whole lines from that of byte `at` on, no more than
// `part` bytes.
FileText readPart(const QString& path, qint64 most, qint64 part, qint64 at, FileProgress& progress,
                  const std::atomic<bool>& stop);
// Beside its place, then renamed: what breaks off leaves the file that was there before.
FileOutcome writeWhole(const QString& path, const QByteArray& bytes, FileProgress& progress,
                       const std::atomic<bool>& stop);
// Likewise, with these bytes for a part of the file; the rest is that of the file, which must still
// be the one that was read. `part` is then where they stand.
FileOutcome writePart(const QString& path, const QByteArray& bytes, FilePart& part,
                      FileProgress& progress, const std::atomic<bool>& stop);

// For tests, a device that hangs: called by the workers before each piece. Set while none of them
// runs.
void hangAtPieces(std::function<void()> hang);

}  // namespace polyturn::hmi
