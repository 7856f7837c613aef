#include "hmi/machine/job_beside.hpp"

#include <QDir>
#include <QFileInfo>

#include "ipc/text/job.hpp"

namespace polyturn::hmi {

JobBeside jobBeside(const QString& program, const JobBeside& known) {
    const QDir dir = QFileInfo(program).absoluteDir();
    JobBeside out{program, {}, {}, known.read};
    for (const QFileInfo& one : dir.entryInfoList({"*.job.toml"}, QDir::Files, QDir::Name)) out.files.push_back({one.fileName(), one.size(), one.lastModified()});
    if (known.program == program && known.files == out.files) return out.job = known.job, out;
    for (const auto& [name, size, when] : out.files) {
        ++out.read;
        if (const auto job = text::load_job(dir.filePath(name).toStdString()))
            for (const auto& [channel, one] : job->programs)
                if (QFileInfo(QString::fromStdString(one.file)).absoluteFilePath() == program) return out.job = dir.filePath(name), out;
    }
    return out;
}

}  // namespace polyturn::hmi
