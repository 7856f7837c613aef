// Lines of the programs that run, for the screens: read once, and again when the file has changed.
#pragma once
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <map>
#include <string>

namespace polyturn::hmi {

class ProgramText {
public:
    // From 1; empty beyond the end, or when the file cannot be read.
    QString line(const std::string& path, std::uint32_t number);
    int count(const std::string& path);
    bool readable(const std::string& path);

private:
    struct File {
        QStringList lines;
        QDateTime changed;
        qint64 lookedMs = 0;
        bool readable = false;
    };
    File& file(const std::string& path);
    std::map<std::string, File> files_;
};

}  // namespace polyturn::hmi
