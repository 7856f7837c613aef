// A job (cli.md 6): which program runs in which channel, on what stock, with which zeros and tools.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::text {

struct JobProgram {
    std::string file;      // resolved against the job's folder
    std::string language;  // empty: the machine says
};

struct JobStock {  // true millimetres
    std::string spindle = "S1";
    double diameter = 0.0, bore = 0.0, length = 0.0;
    double face = 0.0;  // stock in front of the workpiece zero
};

struct JobTool {
    unsigned channel = 0;
    int station = 0;
    std::string name;
};

struct Job {
    std::string file, name;
    std::map<unsigned, JobProgram> programs;  // by channel
    std::optional<JobStock> stock;
    // channel -> system -> axis -> value
    std::map<unsigned, std::map<std::string, AxisValues>> zeros;
    std::vector<JobTool> tools;
    unsigned parts_wanted = 0;  // 0: not said
    // resolved; empty: the job names none. An option of the command line wins.
    std::string setup, machine;
};

Job parse_job(std::string_view content, std::string_view filename,
              std::vector<Diagnosis>& diagnoses);
Result<Job> load_job(const std::string& path);

// "shaft.job.toml": a job rather than a program.
bool is_job_file(std::string_view path);

}  // namespace polyturn::text
