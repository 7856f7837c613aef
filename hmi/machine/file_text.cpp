#include "hmi/machine/file_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace polyturn::hmi {
namespace {

constexpr qint64 kPiece = 1 << 16;

std::function<void()>& hang() {
    static std::function<void()> one;
    return one;
}

FileOutcome failed(const QString& path) { return {FileOutcome::Kind::Failed, QFileInfo(path).fileName() + ": " + QString::fromLocal8Bit(std::strerror(errno)), 0}; }

}  // namespace

void hangAtPieces(std::function<void()> one) { hang() = std::move(one); }

FileText readText(const QString& path, qint64 most, FileProgress& progress, const std::atomic<bool>& stop) {
    FileText out;
    QFile source(path);
    if (!source.open(QIODevice::ReadOnly)) return out;
    progress.all = source.size();
    QByteArray bytes;
    for (;;) {
        if (hang()) hang()();
        if (stop) return out.kind = FileText::Kind::Stopped, out;
        const QByteArray piece = source.read(kPiece);
        if (piece.isEmpty()) break;
        bytes += piece;
        progress.done = bytes.size();
        if (bytes.size() > most) return out.kind = FileText::Kind::TooLarge, out;
    }
    if (source.error() != QFileDevice::NoError) return out;
    out.text = QString::fromUtf8(bytes);
    out.kind = out.text.toUtf8() == bytes ? FileText::Kind::Read : FileText::Kind::NoText;
    out.path = QFileInfo(path).canonicalFilePath();
    return out;
}

FileOutcome writeWhole(const QString& path, const QByteArray& bytes, FileProgress& progress, const std::atomic<bool>& stop) {
    const QString canonical = QFileInfo(path).canonicalFilePath(), target = canonical.isEmpty() ? path : canonical;   // a link stays one
    const QFileInfo info(target);
    const QByteArray part = QFile::encodeName(info.absolutePath() + "/." + info.fileName() + QString(".part%1").arg(::getpid()));
    struct stat before {};
    const bool existed = ::stat(QFile::encodeName(target).constData(), &before) == 0;
    if (existed && ::access(QFile::encodeName(target).constData(), W_OK) != 0) return failed(path);   // protected: renaming over it would go around that
    progress.all = bytes.size();
    const int fd = ::open(part.constData(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd < 0) return failed(path);
    const auto giveUp = [&](FileOutcome why) { return ::close(fd), ::unlink(part.constData()), why; };
    for (qint64 at = 0; at < bytes.size();) {
        if (hang()) hang()();
        if (stop) return giveUp({FileOutcome::Kind::Stopped, info.fileName(), 0});
        const auto wrote = ::write(fd, bytes.constData() + at, static_cast<std::size_t>(std::min(kPiece, bytes.size() - at)));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) return giveUp(failed(path));
        progress.done = at += wrote;
    }
    if (existed) (void)::fchmod(fd, before.st_mode & 07777);
    if (::fsync(fd) != 0) return giveUp(failed(path));
    if (stop) return giveUp({FileOutcome::Kind::Stopped, info.fileName(), 0});
    if (::close(fd) != 0 || std::rename(part.constData(), QFile::encodeName(target).constData()) != 0) {
        const FileOutcome why = failed(path);
        ::unlink(part.constData());
        return why;
    }
    return {FileOutcome::Kind::Done, info.fileName(), 1};
}

}  // namespace polyturn::hmi
