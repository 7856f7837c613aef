#include "hmi/machine/programs/file_work.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTextStream>
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "hmi/machine/programs/ordinary_file.hpp"
#include "hmi/text/display_languages.hpp"
#include "ipc/diagnosis/os_errors.hpp"
#include "ipc/model/files/job.hpp"
#include "ipc/model/files/replace_file.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kPiece = 1 << 18;
const QString kLevels = QStringLiteral(".polyturn-levels");  // lines LEVEL NAME, beside the files

QByteArray path8(const QString& path) { return QFile::encodeName(path); }

std::vector<std::pair<QString, int>> levelsIn(const QString& folder) {
    std::vector<std::pair<QString, int>> out;
    QFile file;
    if (!openOrdinary(file, QDir(folder).filePath(kLevels))) return out;
    for (const QString& line : QString::fromUtf8(file.read(1 << 20)).split('\n'))
        if (const int space = static_cast<int>(line.indexOf(' ')); space > 0)
            out.emplace_back(line.mid(space + 1), line.left(space).toInt());
    return out;
}

bool keepLevel(const QString& path, int level) {
    const QFileInfo info(path);
    const QString list = QDir(info.absolutePath()).filePath(kLevels);
    QByteArray lines;
    for (const auto& [name, has] : levelsIn(info.absolutePath()))
        if (name != info.fileName()) lines += QByteArray::number(has) + ' ' + name.toUtf8() + '\n';
    if (level > 0) lines += QByteArray::number(level) + ' ' + info.fileName().toUtf8() + '\n';
    if (lines.isEmpty()) return !QFile::exists(list) || QFile::remove(list);
    return text::replace_file(path8(list).toStdString(), lines.toStdString()).ok();
}

struct Handle {
    int fd;
    ~Handle() {
        if (fd >= 0) ::close(fd);
    }
};

// Counts all bytes below a path.
void measure(const QString& path, FileProgress& progress, const std::atomic<bool>& stop) {
    const QFileInfo info(path);
    if (!info.isDir()) return void(progress.all += info.size() * 2);  // written, then read back
    for (const QFileInfo& one :
         QDir(path).entryInfoList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot))
        if (!stop) measure(one.absoluteFilePath(), progress, stop);
}

FileOutcome transferFile(const QString& from, const QString& to, FileProgress& progress,
                         const std::atomic<bool>& stop,
                         const std::function<void(const QString&)>& written) {
    const QFileInfo target(to);
    const QString part =
        target.absolutePath() + "/." + target.fileName() + QString(".part%1").arg(::getpid());
    const auto giveUp = [&](FileOutcome why) {
        ::unlink(path8(part).constData());
        return why;
    };
    const Handle in{openOrdinary(from)};
    if (in.fd < 0) return failedFile(from);
    struct stat about {};
    ::fstat(in.fd, &about);
    QCryptographicHash sent(QCryptographicHash::Sha256), arrived(QCryptographicHash::Sha256);
    QByteArray piece(kPiece, Qt::Uninitialized);
    {
        const Handle out{
            ::open(path8(part).constData(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
        if (out.fd < 0) return failedFile(to);
        for (;;) {
            if (stop) return giveUp({FileOutcome::Kind::Stopped, target.fileName(), 0});
            const auto got = ::read(in.fd, piece.data(), kPiece);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) return giveUp(failedFile(from));
            if (got == 0) break;
            sent.addData(QByteArrayView(piece.constData(), got));
            for (ssize_t at = 0; at < got;) {
                const auto wrote =
                    ::write(out.fd, piece.constData() + at, static_cast<std::size_t>(got - at));
                if (wrote < 0 && errno == EINTR) continue;
                if (wrote <= 0) return giveUp(failedFile(to));
                at += wrote;
            }
            progress.done += got;
        }
        const timespec times[2] = {about.st_atim, about.st_mtim};
        ::futimens(out.fd, times);
        if (::fsync(out.fd) != 0) return giveUp(failedFile(to));
        // what is read back comes from the medium, where the system allows it
        ::posix_fadvise(out.fd, 0, 0, POSIX_FADV_DONTNEED);
    }
    if (written) written(part);
    {
        const Handle back{::open(path8(part).constData(), O_RDONLY | O_CLOEXEC)};
        if (back.fd < 0) return giveUp(failedFile(to));
        for (;;) {
            if (stop) return giveUp({FileOutcome::Kind::Stopped, target.fileName(), 0});
            const auto got = ::read(back.fd, piece.data(), kPiece);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) return giveUp(failedFile(to));
            if (got == 0) break;
            arrived.addData(QByteArrayView(piece.constData(), got));
            progress.done += got;
        }
    }
    if (sent.result() != arrived.result())
        return giveUp({FileOutcome::Kind::Differs, target.fileName(), 0});
    if (std::rename(path8(part).constData(), path8(to).constData()) != 0)
        return giveUp(failedFile(to));
    const Handle folder{
        ::open(path8(target.absolutePath()).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (folder.fd >= 0) ::fsync(folder.fd);
    ++progress.files;
    return {FileOutcome::Kind::Done, target.fileName(), 1};
}

FileOutcome transferAny(const QString& from, const QString& to, FileProgress& progress,
                        const std::atomic<bool>& stop,
                        const std::function<void(const QString&)>& written) {
    const QFileInfo info(from);
    if (!info.isDir()) return transferFile(from, to, progress, stop, written);
    if (!QDir().mkpath(to)) return failedFile(to);
    FileOutcome out{FileOutcome::Kind::Done, QFileInfo(to).fileName(), 0};
    for (const QFileInfo& one : QDir(from).entryInfoList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
        if (stop) return {FileOutcome::Kind::Stopped, one.fileName(), out.files};
        const FileOutcome done = transferAny(
            one.absoluteFilePath(), QDir(to).filePath(one.fileName()), progress, stop, written);
        out.files += done.files;
        if (!done.ok()) return {done.kind, done.what, out.files};
    }
    return out;
}

// The first thing below a path that may not be changed; empty: all may.
QString protectedIn(const QString& path, int level, const std::atomic<bool>& stop) {
    const QFileInfo info(path);
    struct stat about {};
    if (::stat(path8(path).constData(), &about) == 0 && S_ISREG(about.st_mode) &&
        !(about.st_mode & S_IWUSR))
        return info.fileName();
    if (levelOf(path) > level) return info.fileName();
    if (!info.isDir() || info.isSymLink()) return {};
    for (const QFileInfo& one :
         QDir(path).entryInfoList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)) {
        if (stop) return one.fileName();
        if (const QString found = protectedIn(one.absoluteFilePath(), level, stop);
            !found.isEmpty())
            return found;
    }
    return {};
}

// The block device's place in the tree of buses says so.
bool onUsb(const QString& device) {
    return QFileInfo("/sys/class/block/" + device.section('/', -1))
        .canonicalFilePath()
        .contains("/usb");
}

}  // namespace

FileOutcome failedFile(const QString& path, int error) {
    return {FileOutcome::Kind::Failed,
            QFileInfo(path).fileName() + ": " +
                QString::fromStdString(os_error(error, DisplayLanguage::English)),
            0};
}

QString FileOutcome::told() const {
    return kind == Kind::Failed ? QString::fromStdString(os_errors_in(what.toStdString(), spoken()))
                                : what;
}

FolderList listFolder(const QString& folder) {
    FolderList out;
    const QDir dir(folder);
    out.folder = dir.absolutePath();
    out.readable = dir.exists() && dir.isReadable();
    FileEntry up;
    up.name = "..";
    up.up = up.folder = true;
    if (!dir.isRoot()) out.entries.push_back(up);
    const auto levels = levelsIn(out.folder);
    std::vector<FileEntry> folders, jobs, rest;
    // no programs there, and keys that delete are at hand
    static const QStringList kOfTheSystem{"dev", "proc", "sys"};
    for (const QFileInfo& one :
         dir.entryInfoList(QDir::AllDirs | QDir::Files | QDir::NoDotAndDotDot, QDir::Name)) {
        if (dir.isRoot() && kOfTheSystem.contains(one.fileName())) continue;
        FileEntry entry{one.fileName(), false, one.isDir(), false,
                        false,          0,     one.size(),  one.lastModified()};
        entry.job = !entry.folder && text::is_job_file(one.filePath().toStdString());
        struct stat about {};
        entry.readOnly = !entry.folder &&
                         ::stat(path8(one.absoluteFilePath()).constData(), &about) == 0 &&
                         !(about.st_mode & S_IWUSR);
        for (const auto& [name, level] : levels)
            if (name == entry.name) entry.level = level;
        (entry.folder ? folders : entry.job ? jobs : rest).push_back(std::move(entry));
    }
    for (FileEntry& one : jobs)
        if (const auto job = text::load_job(dir.filePath(one.name).toStdString()))
            for (const auto& [channel, program] : job->programs) {
                if (const Dialect named = dialect_of(program.language); named != Dialect::Polyturn)
                    one.languages[channel] = named;
                for (FileEntry& file : rest) {
                    if (dir.filePath(file.name) !=
                        QFileInfo(QString::fromStdString(program.file)).absoluteFilePath())
                        continue;
                    if (!program.language.empty())
                        file.language = QString::fromStdString(program.language);
                    if (file.ofJob.isEmpty()) file.ofJob = dir.filePath(one.name);
                }
            }
    for (auto* part : {&folders, &jobs, &rest})
        for (FileEntry& one : *part) out.entries.push_back(std::move(one));
    return out;
}

std::vector<QFileInfo> folderInfos(const QString& folder, const QStringList& patterns,
                                   QDir::SortFlags sort) {
    std::vector<QFileInfo> out;
    const QDir dir(folder);
    if (!dir.isRoot()) {
        QFileInfo above(QFileInfo(folder).absolutePath());
        while (!above.isDir() && above.absoluteFilePath() != "/")
            above = QFileInfo(above.absolutePath());
        out.push_back(above);
    }
    for (const QFileInfo& one :
         dir.entryInfoList(patterns, QDir::Files | QDir::AllDirs | QDir::NoDotAndDotDot, sort))
        out.push_back(one);
    // kept in it from now on
    for (const QFileInfo& one : out) {
        (void)one.isDir();
        (void)one.isFile();
        (void)one.size();
    }
    return out;
}

QStringList placeFiles() {
    return {"/etc/polyturn/places",
            QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                "/polyturn/places"};
}

std::vector<Place> places(const QString& mounts, const QStringList& configured) {
    std::vector<Place> out;
    for (const QString& name : configured) {
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly)) continue;
        for (const QString& line : QString::fromUtf8(file.read(1 << 16)).split('\n')) {
            const QString words = line.section(';', 0, 0).trimmed();
            const int at = static_cast<int>(words.indexOf('='));
            if (at > 0 && words.mid(at + 1).startsWith('/'))
                out.push_back({words.left(at).trimmed(), words.mid(at + 1).trimmed(),
                               Place::Kind::Configured});
        }
    }
    static const QStringList kNetwork{"nfs",   "nfs4",       "cifs",        "smb3",
                                      "smbfs", "fuse.sshfs", "9p",          "afs",
                                      "ncpfs", "davfs",      "fuse.davfs2", "fuse.rclone"};
    for (const QString& line : mounts.split('\n')) {
        const QStringList words = line.split(' ');
        if (words.size() < 3) continue;
        QString path = words[1];
        for (const auto& [code, text] : {std::pair{"\\040", " "}, {"\\011", "\t"}, {"\\134", "\\"}})
            path.replace(code, text);
        const bool network = kNetwork.contains(words[2]);
        // Where desktops mount sticks; below /mnt only what hangs on a USB port: fixed disks are
        // mounted there as well.
        const bool removable =
            !network && (path.startsWith("/media/") || path.startsWith("/run/media/") ||
                         (path.startsWith("/mnt/") && onUsb(words[0])));
        // A stick that is mounted during a look is listed here twice: as the place that waits
        // for a look, and as what was found there.
        const bool known = std::any_of(out.begin(), out.end(), [&](const Place& one) {
            return one.kind != Place::Kind::Configured && one.path == path;
        });
        if ((network || removable) && !known)
            out.push_back({network ? words[0] : path.section('/', -1), path,
                           network ? Place::Kind::Network : Place::Kind::Removable});
    }
    return out;
}

bool keepPlace(const QString& name_of_file, const QString& name, const QString& path) {
    QFile file(name_of_file);
    QStringList lines;
    if (file.open(QIODevice::ReadOnly)) {
        lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
        file.close();
    }
    lines.erase(std::remove_if(
                    lines.begin(), lines.end(),
                    [&](const QString& line) { return line.section('=', 0, 0).trimmed() == name; }),
                lines.end());
    if (!path.isEmpty()) lines << name + "=" + path;
    QDir().mkpath(QFileInfo(name_of_file).absolutePath());
    return text::replace_file(path8(name_of_file).toStdString(),
                              (lines.join('\n') + '\n').toStdString())
        .ok();
}

FileOutcome transfer(const QString& from, const QString& to, FileProgress& progress,
                     const std::atomic<bool>& stop,
                     const std::function<void(const QString&)>& written) {
    const QString source = QFileInfo(from).absoluteFilePath(),
                  target = QFileInfo(to).absoluteFilePath();
    if (!QFileInfo::exists(source)) return failedFile(from, ENOENT);
    // a folder into itself would never end
    if (source == target || target.startsWith(source + "/")) return failedFile(to, EINVAL);
    measure(source, progress, stop);
    return transferAny(source, target, progress, stop, written);
}

FileOutcome removeAll(const QString& path, int level, const std::atomic<bool>& stop) {
    if (const QString found = protectedIn(path, level, stop); !found.isEmpty())
        return {stop ? FileOutcome::Kind::Stopped : FileOutcome::Kind::Failed,
                found + ": " + QString::fromStdString(os_error(EPERM, DisplayLanguage::English)),
                0};
    const QFileInfo info(path);
    const bool good = info.isDir() && !info.isSymLink() ? QDir(path).removeRecursively()
                                                        : ::unlink(path8(path).constData()) == 0;
    if (!good) return failedFile(path);
    keepLevel(path, 0);
    return {FileOutcome::Kind::Done, info.fileName(), 1};
}

FileOutcome rename(const QString& path, const QString& name) {
    const QFileInfo info(path);
    const QString to = QDir(info.absolutePath()).filePath(name);
    if (name.isEmpty() || name.contains('/') || name == "." || name == "..")
        return failedFile(name, EINVAL);
    if (QFileInfo::exists(to)) return failedFile(to, EEXIST);
    const int level = levelOf(path);
    if (std::rename(path8(path).constData(), path8(to).constData()) != 0) return failedFile(path);
    if (level) {
        keepLevel(path, 0);
        keepLevel(to, level);
    }
    return {FileOutcome::Kind::Done, name, 1};
}

FileOutcome makeFolder(const QString& path) {
    if (::mkdir(path8(path).constData(), 0777) != 0) return failedFile(path);
    return {FileOutcome::Kind::Done, QFileInfo(path).fileName(), 1};
}

FileOutcome makeProgram(const QString& path, const QByteArray& text) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return failedFile(path, QFileInfo::exists(path) ? EEXIST : errno);
    if (file.write(text) != text.size() || !file.flush()) {
        const int why = errno;
        file.remove();
        return failedFile(path, why);
    }
    return {FileOutcome::Kind::Done, QFileInfo(path).fileName(), 1};
}

// No sign that cannot be seen, none that separates names (folders, what screens keep), none that
// other systems refuse.
bool mayBeName(const QString& name) {
    constexpr int kMost = 100;
    if (name.isEmpty() || name.size() > kMost || name != name.trimmed() || name.startsWith('.') ||
        name.endsWith('.'))
        return false;
    return std::all_of(name.begin(), name.end(), [](QChar c) {
        return c.isPrint() && !QStringView(u"/\\|:*?\"<>=").contains(c);
    });
}

// Fanuc and nct name a program by its O number.
QByteArray emptyProgram(const QString& name, const QString& language) {
    static const QRegularExpression kNumber("^[Oo]?(\\d{1,8})(?:\\.|$)");
    const auto number = kNumber.match(name);
    const bool numbered = (language == "fanuc" || language == "nct") && number.hasMatch();
    return (numbered ? "O" + number.captured(1).toUtf8() + "\n" : QByteArray()) + "\nM30\n";
}

FileOutcome protect(const QString& path, bool readOnly, int level) {
    struct stat about {};
    if (::stat(path8(path).constData(), &about) != 0) return failedFile(path);
    const mode_t writing = S_IWUSR | S_IWGRP | S_IWOTH;
    const mode_t mode = readOnly ? about.st_mode & ~writing : about.st_mode | S_IWUSR;
    if (::chmod(path8(path).constData(), mode & 07777) != 0) return failedFile(path);
    ::stat(path8(path).constData(), &about);
    // a file system without such a flag
    if (((about.st_mode & S_IWUSR) == 0) != readOnly) return failedFile(path, ENOTSUP);
    if (levelOf(path) != level && !keepLevel(path, level)) return failedFile(path);
    return {FileOutcome::Kind::Done, QFileInfo(path).fileName(), 1};
}

int levelOf(const QString& path) {
    const QFileInfo info(path);
    for (const auto& [name, level] : levelsIn(info.absolutePath()))
        if (name == info.fileName()) return level;
    return 0;
}

}  // namespace polyturn::hmi
