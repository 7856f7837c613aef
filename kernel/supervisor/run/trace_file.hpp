// The trace of a run as CSV (cli.md 4): a line each so many ticks with every axis, spindle and
// channel that exists.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "kernel/supervisor/base/output.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

class TraceFile {
public:
    ~TraceFile();
    static Result<std::unique_ptr<TraceFile>> create(const std::string& path,
                                                     const MachineConfig& machine);
    // t_s: since cycle start. Values are written so that they read back exactly: limits are judged
    // on their differences.
    void write(const TraceSample& sample, double t_s);
    bool close();  // false when the disk did not take everything

private:
    TraceFile(int fd, const MachineConfig& machine);
    int fd_;
    Output output_;
    std::vector<std::size_t> axes_, spindles_, channels_;  // indices from 0
    std::string line_;
};

}  // namespace polyturn::supervisor
