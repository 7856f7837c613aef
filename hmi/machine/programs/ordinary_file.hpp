// A file whose name comes from outside the screens, opened through the one door for files
// (ipc/model/files/regular_file.hpp): a pipe or a device of that name would hold the thread that reads it
// for ever.
#pragma once
#include <QFile>

namespace polyturn::hmi {

// For reading; false: no ordinary file, or one that cannot be read. `file` is closed before.
bool openOrdinary(QFile& file, const QString& path);
// Its descriptor, which the caller closes; -1 with errno.
int openOrdinary(const QString& path);

}  // namespace polyturn::hmi
