// A file read or written whole, in pieces that can be stopped: by workers (machine/aside.hpp), for it may lie on a network that hangs.
#pragma once
#include <QByteArray>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>

#include "hmi/machine/file_work.hpp"

namespace polyturn::hmi {

struct FileText {
    enum class Kind : std::uint8_t { Read, Unreadable, TooLarge, NoText, Stopped } kind = Kind::Unreadable;
    QString text;
    QString path;                      // as the system knows the file: links followed
};
// Of UTF-8; what would not come back the same when it is written again is NoText.
FileText readText(const QString& path, qint64 most, FileProgress& progress, const std::atomic<bool>& stop);
// Beside its place, then renamed: what breaks off leaves the file that was there before.
FileOutcome writeWhole(const QString& path, const QByteArray& bytes, FileProgress& progress, const std::atomic<bool>& stop);

// For tests, a device that hangs: called by the workers before each piece. Set while none of them runs.
void hangAtPieces(std::function<void()> hang);

}  // namespace polyturn::hmi
