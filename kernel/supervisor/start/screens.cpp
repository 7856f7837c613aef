#include "kernel/supervisor/start/screens.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "ipc/model/files/machine_path.hpp"
#include "kernel/supervisor/check/job_plan.hpp"

namespace polyturn::supervisor {

namespace {

constexpr const char* kProgram = "polyturn-hmi";
constexpr int kTimeoutMs = 2'000;  // for closing its window

bool has_display() {
    for (const char* name : {"WAYLAND_DISPLAY", "DISPLAY"})
        if (const char* value = std::getenv(name); value && *value) return true;
    return false;
}

}  // namespace

void Screens::open(const std::string& instance) {
    std::error_code none;
    if (!has_display() ||
        !std::filesystem::exists(std::filesystem::path(text::program_folder()) / kProgram, none))
        return;
    auto child = Child::start(kProgram, {"--instance", instance});
    if (child)
        child_ = std::move(*child);
    else
        print_diagnosis(child.diagnosis(), Dialect::Polyturn);
}

void Screens::close() {
    if (!child_.running()) return;
    child_.signal(SIGTERM);
    child_.end_within(kTimeoutMs);
}

}  // namespace polyturn::supervisor
