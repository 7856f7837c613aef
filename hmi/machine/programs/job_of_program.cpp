#include "hmi/machine/programs/job_of_program.hpp"

#include <QDir>
#include <QFileInfo>

#include "ipc/model/files/job.hpp"

namespace polyturn::hmi {

JobOfProgram jobOfProgram(const QString& program, const JobOfProgram& known) {
    const QDir dir = QFileInfo(program).absoluteDir();
    JobOfProgram out{program, {}, {}, known.read};
    for (const QFileInfo& one : dir.entryInfoList({"*.job.toml"}, QDir::Files, QDir::Name))
        out.files.push_back({one.fileName(), one.size(), one.lastModified()});
    if (known.program == program && known.files == out.files) {
        out.job = known.job;
        return out;
    }
    for (const auto& [name, size, when] : out.files) {
        ++out.read;
        if (const auto job = text::load_job(dir.filePath(name).toStdString()))
            for (const auto& [channel, one] : job->programs)
                if (QFileInfo(QString::fromStdString(one.file)).absoluteFilePath() == program) {
                    out.job = dir.filePath(name);
                    return out;
                }
    }
    return out;
}

}  // namespace polyturn::hmi
