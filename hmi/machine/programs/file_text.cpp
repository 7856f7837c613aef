#include "hmi/machine/programs/file_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include "hmi/machine/programs/ordinary_file.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kPiece = 1 << 16;

std::function<void()>& hang() {
    static std::function<void()> one;
    return one;
}

// The bytes as text; NoText where they would not come back the same. Lines that end in two ways
// stay as they are.
void takeProgramBytes(FileText& out, const QByteArray& bytes) {
    out.text = QString::fromUtf8(bytes);
    out.kind = out.text.toUtf8() == bytes ? FileText::Kind::Read : FileText::Kind::NoText;
    const auto lines = bytes.count('\n');
    out.dos = lines > 0 && bytes.count("\r\n") == lines;
    if (out.dos) out.text.replace("\r\n", "\n");
}

qint64 writtenNs(const struct stat& about) {
    return about.st_mtim.tv_sec * 1'000'000'000LL + about.st_mtim.tv_nsec;
}

void describeFile(const QString& path, FileText& out) {
    struct stat about {};
    if (::stat(QFile::encodeName(path).constData(), &about) == 0)
        out.part.written_ns = writtenNs(about);
    out.path = QFileInfo(path).canonicalFilePath();
}

}  // namespace

void hangAtPieces(std::function<void()> one) { hang() = std::move(one); }

FileText readText(const QString& path, qint64 most, FileProgress& progress,
                  const std::atomic<bool>& stop) {
    FileText out;
    QFile source;
    if (!openOrdinary(source, path)) return out;
    progress.all = source.size();
    QByteArray bytes;
    for (;;) {
        if (hang()) hang()();
        if (stop) {
            out.kind = FileText::Kind::Stopped;
            return out;
        }
        const QByteArray piece = source.read(kPiece);
        if (piece.isEmpty()) break;
        bytes += piece;
        progress.done = bytes.size();
        if (bytes.size() > most) {
            out.kind = FileText::Kind::TooLarge;
            return out;
        }
    }
    if (source.error() != QFileDevice::NoError) return out;
    takeProgramBytes(out, bytes);
    out.part.to = out.part.all = bytes.size();
    describeFile(path, out);
    return out;
}

FileText readPart(const QString& path, qint64 most, qint64 part, qint64 at, FileProgress& progress,
                  const std::atomic<bool>& stop) {
    FileText out;
    QFile source;
    if (!openOrdinary(source, path)) return out;
    out.part.all = source.size();
    if (out.part.all <= most) {
        source.close();
        return readText(path, most, progress, stop);
    }
    progress.all = std::min(at, out.part.all) + part;
    // Where the line of `at` begins, and how many stand before it.
    qint64 here = 0;
    while (here < at) {
        if (hang()) hang()();
        if (stop) {
            out.kind = FileText::Kind::Stopped;
            return out;
        }
        const QByteArray piece = source.read(std::min(kPiece, at - here));
        if (piece.isEmpty()) break;
        if (const auto lines = piece.count('\n')) {
            out.part.line += lines;
            out.part.from = here + piece.lastIndexOf('\n') + 1;
        }
        progress.done = here += piece.size();
    }
    if (!source.seek(out.part.from)) return out;
    QByteArray bytes;
    while (bytes.size() < part) {
        if (hang()) hang()();
        if (stop) {
            out.kind = FileText::Kind::Stopped;
            return out;
        }
        const QByteArray piece = source.read(std::min(kPiece, part - bytes.size()));
        if (piece.isEmpty()) break;
        bytes += piece;
        progress.done = here + bytes.size();
    }
    if (source.error() != QFileDevice::NoError) return out;
    if (out.part.from + bytes.size() < out.part.all) {
        const auto end = bytes.lastIndexOf('\n');
        // a line of millions of letters is no program
        if (end < 0) {
            out.kind = FileText::Kind::TooLarge;
            return out;
        }
        bytes.truncate(end + 1);
    }
    out.part.to = out.part.from + bytes.size();
    takeProgramBytes(out, bytes);
    describeFile(path, out);
    return out;
}

FileOutcome writeWhole(const QString& path, const QByteArray& bytes, FileProgress& progress,
                       const std::atomic<bool>& stop) {
    FilePart all;
    return writePart(path, bytes, all, progress, stop);
}

FileOutcome writePart(const QString& path, const QByteArray& bytes, FilePart& of,
                      FileProgress& progress, const std::atomic<bool>& stop) {
    // a link stays one
    const QString canonical = QFileInfo(path).canonicalFilePath(),
                  target = canonical.isEmpty() ? path : canonical;
    const QFileInfo info(target);
    const QByteArray part = QFile::encodeName(info.absolutePath() + "/." + info.fileName() +
                                              QString(".part%1").arg(::getpid()));
    struct stat before {};
    const bool existed = ::stat(QFile::encodeName(target).constData(), &before) == 0;
    // protected: renaming over it would go around that
    if (existed && ::access(QFile::encodeName(target).constData(), W_OK) != 0)
        return failedFile(path);
    QFile rest(target);
    if (!of.whole() && (!rest.open(QIODevice::ReadOnly) || before.st_size != of.all ||
                        writtenNs(before) != of.written_ns))
        return failedFile(info.filePath(), ESTALE);
    progress.all = of.from + bytes.size() + (of.all - of.to);
    const int fd = ::open(part.constData(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd < 0) return failedFile(path);
    const auto giveUp = [&](FileOutcome why) {
        ::close(fd);
        ::unlink(part.constData());
        return why;
    };
    // In pieces; what it says ends the writing.
    const auto put = [&](const char* from, qint64 count) -> std::optional<FileOutcome> {
        for (qint64 at = 0; at < count;) {
            if (hang()) hang()();
            if (stop) return FileOutcome{FileOutcome::Kind::Stopped, info.fileName(), 0};
            const auto wrote =
                ::write(fd, from + at, static_cast<std::size_t>(std::min(kPiece, count - at)));
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote <= 0) return failedFile(path);
            at += wrote;
            progress.done += wrote;
        }
        return std::nullopt;
    };
    const auto copy = [&](qint64 from, qint64 to) -> std::optional<FileOutcome> {
        if (from < to && !rest.seek(from)) return failedFile(path);
        while (from < to) {
            const QByteArray piece = rest.read(std::min(kPiece, to - from));
            if (piece.isEmpty()) return failedFile(path);
            if (const auto ended = put(piece.constData(), piece.size())) return ended;
            from += piece.size();
        }
        return std::nullopt;
    };
    auto ended = copy(0, of.from);
    if (!ended) ended = put(bytes.constData(), bytes.size());
    if (!ended) ended = copy(of.to, of.all);
    if (ended) return giveUp(*ended);
    if (existed) (void)::fchmod(fd, before.st_mode & 07777);
    if (::fsync(fd) != 0) return giveUp(failedFile(path));
    if (stop) return giveUp({FileOutcome::Kind::Stopped, info.fileName(), 0});
    struct stat after {};
    const bool told = ::fstat(fd, &after) == 0;
    if (::close(fd) != 0 ||
        std::rename(part.constData(), QFile::encodeName(target).constData()) != 0) {
        const FileOutcome why = failedFile(path);
        ::unlink(part.constData());
        return why;
    }
    of.to = of.from + bytes.size();
    if (told) {
        of.all = after.st_size;
        of.written_ns = writtenNs(after);
    }
    return {FileOutcome::Kind::Done, info.fileName(), 1};
}

}  // namespace polyturn::hmi
