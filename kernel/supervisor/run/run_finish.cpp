// The end of a run: what is still held back, the summary, report and picture; then the processes.
#include <fmt/format.h>

#include <fstream>

#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/plot/plot.hpp"
#include "kernel/supervisor/run/report.hpp"
#include "kernel/supervisor/run/run_session.hpp"

namespace polyturn::supervisor {

void RunSession::finish() {
    if (!kernel_dead_) {
        drain_trace(INT64_MAX);
        MachineStatus status;
        if (controller_->kernel().status.read(status))
            for (const auto& [number, track] : tracks_) {
                const ChannelStatus& channel = status.channels[number - 1];
                record_.channels[number] = {channel.cycle_s, channel.cutting_s, channel.rapid_s,
                                            channel.waiting_s, channel.blocks};
            }
    }
    // Cut short by a signal or the kernel's death: until now. In a long block nothing may have been
    // heard for minutes.
    if (!ending())
        // P3: only the number counts (the order is stronger than needed)
        log_tick_ = std::max(
            log_tick_,
            static_cast<std::int64_t>(controller_->kernel().tick.load(std::memory_order_acquire)));
    if (!ending() && log_tick_ > origin_)
        end_s_ = std::max(end_s_, static_cast<double>(log_tick_ - origin_) * tick_s_);
    joiner_.finish(sink_);
    record_.seconds = end_s_;
    std::string channels = "[";
    for (const auto& [number, times] : record_.channels) {
        if (channels.size() > 1) channels += ',';
        channels += fmt::format("{{\"ch\":{},\"seconds\":", number);
        append_json_number(channels, times.cycle_s);
        channels += ",\"cutting\":";
        append_json_number(channels, times.cutting_s);
        channels += ",\"rapid\":";
        append_json_number(channels, times.rapid_s);
        channels += ",\"waiting\":";
        append_json_number(channels, times.waiting_s);
        channels += fmt::format(",\"blocks\":{}}}", times.blocks);
    }
    channels += ']';
    output_.write(std::move(EventText("summary")
                                .number("seconds", end_s_)
                                .raw("channels", channels)
                                .number("alarms", static_cast<double>(alarms_)))
                      .line());
    output_.flush();
    write_pictures();
    controller_->stop(3'000);
    if (trace_file_ && !trace_file_->close()) {
        print_diagnosis(Diagnosis{Alarm::OutputFile, {}, {}, options_.trace_file},
                        Dialect::Polyturn);
        stopped_short_ = true;
    }
    controller_.reset();
}

void RunSession::write_pictures() {
    if (options_.report) {
        output_.write(report_text(record_, plan_));
        output_.flush();
    }
    if (options_.plot_file.empty()) return;
    const std::string picture = plot_text(record_, plan_);
    std::ofstream file(options_.plot_file, std::ios::binary | std::ios::trunc);
    file << picture;
    file.close();
    if (file) return;
    print_diagnosis(Diagnosis{Alarm::OutputFile, {}, {}, options_.plot_file}, Dialect::Polyturn);
    stopped_short_ = true;
}

}  // namespace polyturn::supervisor
