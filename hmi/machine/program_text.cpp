#include "hmi/machine/program_text.hpp"

#include <QFile>
#include <QFileInfo>

namespace polyturn::hmi {
namespace {

constexpr qint64 kLookMs = 1'000;
constexpr qint64 kLargest = 4 << 20;   // a larger program is not shown line by line: reading it would hold up the screen
constexpr std::size_t kKept = 64;

}  // namespace

ProgramText::File& ProgramText::file(const std::string& path) {
    if (files_.size() > kKept && !files_.count(path)) files_.clear();
    File& out = files_[path];
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (now - out.lookedMs < kLookMs) return out;
    out.lookedMs = now;
    const QFileInfo info(QString::fromStdString(path));
    if (out.readable && info.exists() && info.lastModified() == out.changed) return out;
    out = {{}, info.lastModified(), now, false};
    QFile source(info.filePath());
    if (path.empty() || info.size() > kLargest || !source.open(QIODevice::ReadOnly)) return out;
    out.lines = QString::fromUtf8(source.readAll()).split('\n');
    for (QString& one : out.lines)
        if (one.endsWith('\r')) one.chop(1);
    out.readable = true;
    return out;
}

QString ProgramText::line(const std::string& path, std::uint32_t number) {
    const File& from = file(path);
    return number >= 1 && number <= static_cast<std::uint32_t>(from.lines.size()) ? from.lines[static_cast<int>(number) - 1] : QString();
}
int ProgramText::count(const std::string& path) { return static_cast<int>(file(path).lines.size()); }
bool ProgramText::readable(const std::string& path) { return file(path).readable; }

}  // namespace polyturn::hmi
