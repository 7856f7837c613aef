// Lines of the programs that run, for the screens: read beside them (a program may lie on a
// network), and again when the file has changed.
#pragma once
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <map>
#include <string>

#include "hmi/machine/live/aside.hpp"

namespace polyturn::hmi {

class ProgramText {
public:
    // From 1; empty beyond the end, when the file cannot be read, and while it is being read.
    QString line(const std::string& path, std::uint32_t number);
    int count(const std::string& path);
    bool readable(const std::string& path);

private:
    struct Text {
        QStringList lines;
        QDateTime changed;
        bool readable = false, same = false;  // same: as it was read before
    };
    struct File {
        Text text;
        Aside<Text> reader;
        qint64 lookedMs = 0;
    };
    static Text read(const std::string& path, bool readBefore, const QDateTime& changed);
    const Text& text(const std::string& path);
    std::map<std::string, File> files_;
};

}  // namespace polyturn::hmi
