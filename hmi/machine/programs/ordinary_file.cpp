#include "hmi/machine/programs/ordinary_file.hpp"

#include <cerrno>

#include "ipc/model/files/regular_file.hpp"

namespace polyturn::hmi {

int openOrdinary(const QString& path) {
    errno = 0;
    auto door =
        text::RegularFile::open(QFile::encodeName(path).toStdString(), text::kLargestProgram);
    if (door) return door->release();
    if (door.diagnosis().alarm == Alarm::FileTooLarge)
        errno = EFBIG;
    else if (door.diagnosis().alarm == Alarm::FileKind || errno == 0)
        errno = EINVAL;
    return -1;
}

bool openOrdinary(QFile& file, const QString& path) {
    file.close();
    const int fd = openOrdinary(path);
    return fd >= 0 && file.open(fd, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle);
}

}  // namespace polyturn::hmi
