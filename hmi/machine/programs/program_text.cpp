#include "hmi/machine/programs/program_text.hpp"

#include <QFile>
#include <QFileInfo>

#include "hmi/machine/programs/ordinary_file.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kLookMs = 1'000;
constexpr qint64 kLargest = 64 << 20;
constexpr std::size_t kKept = 64;
constexpr int kFirstTimeout_ms = 5;  // of a frame: a program on the own disk is there at once

}  // namespace

ProgramText::Text ProgramText::read(const std::string& path, bool readBefore,
                                    const QDateTime& changed) {
    const QFileInfo info(QString::fromStdString(path));
    Text out;
    out.changed = info.lastModified();
    if (readBefore && info.exists() && out.changed == changed) {
        out.same = true;
        return out;
    }
    QFile source;
    if (path.empty() || info.size() > kLargest || !openOrdinary(source, info.filePath()))
        return out;
    out.lines = QString::fromUtf8(source.readAll()).split('\n');
    for (QString& one : out.lines)
        if (one.endsWith('\r')) one.chop(1);
    out.readable = true;
    return out;
}

const ProgramText::Text& ProgramText::text(const std::string& path) {
    if (files_.size() > kKept && !files_.count(path)) files_.clear();
    File& file = files_[path];
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (!file.reader.busy() && now - file.lookedMs >= kLookMs) {
        const int timeout = file.lookedMs ? 0 : kFirstTimeout_ms;
        file.lookedMs = now;
        file.reader.start([path, before = file.text.readable, changed = file.text.changed](
                              const std::atomic<bool>&) { return read(path, before, changed); },
                          timeout);
    }
    if (auto done = file.reader.take(); done && !done->same) file.text = std::move(*done);
    return file.text;
}

QString ProgramText::line(const std::string& path, std::uint32_t number) {
    const Text& from = text(path);
    return number >= 1 && number <= static_cast<std::uint32_t>(from.lines.size())
               ? from.lines[static_cast<int>(number) - 1]
               : QString();
}
int ProgramText::count(const std::string& path) {
    return static_cast<int>(text(path).lines.size());
}
bool ProgramText::readable(const std::string& path) { return text(path).readable; }

}  // namespace polyturn::hmi
