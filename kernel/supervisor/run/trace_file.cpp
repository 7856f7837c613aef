#include "kernel/supervisor/run/trace_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

namespace polyturn::supervisor {

namespace {
void append(std::string& out, double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, end.ptr);
}
}  // namespace

Result<std::unique_ptr<TraceFile>> TraceFile::create(const std::string& path,
                                                     const MachineConfig& machine) {
    const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd < 0)
        return Diagnosis{
            Alarm::OutputFile, {}, {}, fmt::format("{} ({})", path, std::strerror(errno))};
    return std::unique_ptr<TraceFile>(new TraceFile(fd, machine));
}

TraceFile::TraceFile(int fd, const MachineConfig& machine) : fd_(fd), output_(fd) {
    std::string head = "t";
    for (std::size_t i = 0; i < machine.last_axis; ++i)
        if (machine.axes[i].exists()) {
            axes_.push_back(i);
            head += fmt::format(",A{}.cmd,A{}.act", i + 1, i + 1);
        }
    for (std::size_t i = 0; i < machine.last_spindle; ++i)
        if (machine.spindles[i].exists()) {
            spindles_.push_back(i);
            head += fmt::format(",S{}.speed,S{}.angle", i + 1, i + 1);
        }
    for (std::size_t i = 0; i < machine.last_channel; ++i)
        if (machine.channels[i].exists()) {
            channels_.push_back(i);
            head += fmt::format(",L{}.state", i + 1);
        }
    output_.write(head + "\n");
}

TraceFile::~TraceFile() { close(); }

void TraceFile::write(const TraceSample& sample, double t_s) {
    line_.clear();
    char buffer[32];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, t_s, std::chars_format::fixed, 6);
    line_.append(buffer, end.ptr);
    for (const std::size_t i : axes_) {
        line_ += ',';
        append(line_, sample.cmd[i]);
        line_ += ',';
        append(line_, sample.act[i]);
    }
    for (const std::size_t i : spindles_) {
        line_ += ',';
        append(line_, sample.speed[i]);
        line_ += ',';
        append(line_, sample.angle[i]);
    }
    for (const std::size_t i : channels_) {
        line_ += ',';
        line_ += std::to_string(static_cast<unsigned>(sample.state[i]));
    }
    line_ += '\n';
    output_.write(line_);
}

bool TraceFile::close() {
    if (fd_ < 0) return !output_.broken();
    output_.flush();
    const bool good = ::close(fd_) == 0 && !output_.broken();
    fd_ = -1;
    return good;
}

}  // namespace polyturn::supervisor
