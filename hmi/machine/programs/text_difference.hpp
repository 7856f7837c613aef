// What two programs differ in, line by line, as they stand side by side.
#pragma once
#include <QString>
#include <QStringList>
#include <atomic>
#include <vector>

namespace polyturn::hmi {

struct PairedLine {
    int left = -1, right = -1;  // lines from 0; -1: there is none on this side
    bool same = false;
};
struct Difference {
    QStringList left, right;
    std::vector<PairedLine> lines;
    int places = 0;      // where they differ: runs of lines that are not the same
    bool rough = false;  // very different: blocks are not matched line by line
    QString fault;       // one of them cannot be read
};
// The shortest edit script from one to the other (library dtl: Wu, Manber, Myers 1990), within
// bounds; blanks at the end of a line do not count.
Difference differenceOf(QStringList left, QStringList right, const std::atomic<bool>& stop);
Difference compareFiles(const QString& left, const QString& right, const std::atomic<bool>& stop);

}  // namespace polyturn::hmi
