// Files as the screen of programs handles them: the content of a folder, places (USB, network,
// configured ones), transfer with a checksum, protection. All of it may take as long as a network
// takes: it is called from workers (machine/aside.hpp) only.
#pragma once
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QString>
#include <QStringList>
#include <atomic>
#include <cerrno>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "ipc/diagnosis/languages.hpp"

namespace polyturn::hmi {

struct FileEntry {
    QString name;
    bool up = false, folder = false, job = false, readOnly = false;
    int level = 0;  // who may change it: 0 everybody, 2 setter, 3 maker
    qint64 size = 0;
    QDateTime changed;
    QString language = {};  // of a program, as the job beside it says
    QString ofJob = {};     // of a program: the first job beside it that has it
    // of a job: of its channels for which it names one
    std::map<unsigned, Dialect> languages = {};
};
struct FolderList {
    QString folder;
    std::vector<FileEntry> entries;  // «Up», folders, jobs, the rest
    bool readable = true;
};
FolderList listFolder(const QString& folder);

// The folder above (the nearest that exists) first, then folders and the files with these endings;
// nothing is asked of the disk later on.
std::vector<QFileInfo> folderInfos(const QString& folder, const QStringList& patterns,
                                   QDir::SortFlags sort);
inline bool isAbove(const QFileInfo& entry, const QString& folder) {
    return (folder + "/")
        .startsWith(entry.absoluteFilePath() == "/" ? QString("/")
                                                    : entry.absoluteFilePath() + "/");
}

struct Place {
    QString name, path;
    enum class Kind : std::uint8_t { Configured, Removable, Network } kind = Kind::Configured;
};
// Mounted file systems that come from outside (`mounts`: as /proc/self/mounts) and the configured
// ones: lines NAME=PATH of the files.
std::vector<Place> places(const QString& mounts, const QStringList& configured);
// where they are configured, the last one is the operator's own
QStringList placeFiles();
// path empty: it goes
bool keepPlace(const QString& file, const QString& name, const QString& path);

struct FileProgress {
    // P3: numbers to look at, they announce nothing
    std::atomic<qint64> done{0}, all{0};
    std::atomic<int> files{0};
};
struct FileOutcome {
    // Differs: the checksum
    enum class Kind : std::uint8_t { Done, Stopped, Failed, Differs } kind = Kind::Done;
    QString what;  // the file, and why
    int files = 0;
    bool ok() const { return kind == Kind::Done; }
    // `what` in the language of the screens: workers write it in English
    QString told() const;
};
FileOutcome failedFile(const QString& path, int error = errno);
// A file or a folder with all that is in it. Each file is written beside its place, read back and
// compared by SHA-256, then renamed: what breaks off leaves the file that was there before.
// `written`: for tests, called with the name of the file before it is read back.
FileOutcome transfer(const QString& from, const QString& to, FileProgress& progress,
                     const std::atomic<bool>& stop,
                     const std::function<void(const QString&)>& written = {});
// nothing is touched when something in it is protected beyond `level`
FileOutcome removeAll(const QString& path, int level, const std::atomic<bool>& stop);
FileOutcome rename(const QString& path, const QString& name);
FileOutcome makeFolder(const QString& path);
// A program that is not there yet; one that is there stays as it is.
FileOutcome makeProgram(const QString& path, const QByteArray& text);
// of a file that every screen and every request can name
bool mayBeName(const QString& name);
// what a new one begins with
QByteArray emptyProgram(const QString& name, const QString& language);
// Read-only for everybody through the operating system; above it a level, which holds for the
// screens.
FileOutcome protect(const QString& path, bool readOnly, int level);
int levelOf(const QString& path);

}  // namespace polyturn::hmi
