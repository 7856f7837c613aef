// The job that a program belongs to: the first one in its folder that names it.
#pragma once
#include <QDateTime>
#include <QString>
#include <tuple>
#include <vector>

namespace polyturn::hmi {

struct JobOfProgram {
    QString program, job;  // job: its path; empty: none names the program
    // jobs in the folder when it was looked: name, size, time
    std::vector<std::tuple<QString, qint64, QDateTime>> files;
    int read = 0;  // files in all, since the first look
};
// Reads only where `known` does not hold any more: a check comes with every pause of who types.
JobOfProgram jobOfProgram(const QString& program, const JobOfProgram& known);

}  // namespace polyturn::hmi
