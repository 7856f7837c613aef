#include "channels/process/run_port.hpp"

#include <ctime>

#include "ipc/image/positioning_step.hpp"
#include "ipc/model/machine/named_inputs.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/path/stroke_flags.hpp"

namespace polyturn::channels {

RunPort::RunPort(const KernelSegment& kernel, unsigned channel)
    : kernel_(&kernel),
      channel_(channel),
      status_(std::make_unique<MachineStatus>()),
      plc_(std::make_unique<PlcOutputs>()) {}

void RunPort::look() {
    tools_read_ = edges_read_ = false;
    // A reader that is overtaken 64 times tries again: the picture must be whole, and the kernel
    // never waits for it.
    while (!kernel_->status.read(*status_)) {}
    while (!kernel_->plc_seen.read(*plc_)) {}
}

std::optional<double> RunPort::axis_command(unsigned machine_axis) {
    return pretended_ ? pretended_(machine_axis) : status_->axes[machine_axis].own;
}
std::optional<double> RunPort::axis_taken_over(unsigned machine_axis) {
    return !pretended_ && status_->axes[machine_axis].flags & kPositioningOfProgram
               ? std::nullopt
               : axis_command(machine_axis);
}
std::optional<double> RunPort::axis_measured(unsigned machine_axis) {
    if (pretended_) return pretended_(machine_axis);
    return status_->axes[machine_axis].act - axis_added(machine_axis);
}
std::optional<double> RunPort::axis_position(unsigned machine_axis) {
    if (pretended_) return pretended_(machine_axis);
    return status_->axes[machine_axis].flags & kMoving ? axis_measured(machine_axis)
                                                       : axis_command(machine_axis);
}
double RunPort::axis_added(unsigned machine_axis) {
    return status_->axes[machine_axis].cmd - status_->axes[machine_axis].own;
}
// Where the axis was when the signal came; it has braked since.
std::optional<double> RunPort::axis_at_skip(unsigned machine_axis) {
    if (!own().skipped || pretended_) return std::nullopt;
    return status_->axes[machine_axis].skip - axis_added(machine_axis);
}

bool RunPort::block_skip(unsigned number) {
    return number >= 1 && number <= 10 && (own().keys & (kKeyBlockSkip1 << (number - 1))) != 0;
}
bool RunPort::optional_stop() { return (own().keys & kKeyOptionalStop) != 0; }
bool RunPort::single_block() { return (own().keys & kKeySingleBlock) != 0; }

// #1000.. are the machine's inputs, #1100.. its outputs, one bit each.
double RunPort::interface_value(std::int32_t variable) {
    if (variable == 1132 || variable == 1133) {  // what programs have written so far
        PlcInputs inputs;
        while (!kernel_->plc_inputs.read(inputs)) {}
        return inputs.signal[(variable == 1132 ? signals::cn_uout : signals::cn_uoutw)(channel_)];
    }
    if (const auto given = given_variable("#" + std::to_string(variable))) return *given;
    if (variable >= 1000 && variable < 1000 + static_cast<std::int32_t>(kInputs) &&
        variable < 1100) {
        PlcInputs inputs;
        while (!kernel_->plc_inputs.read(inputs)) {}
        // a wire of the machine, or what the PLC says
        const auto bit = static_cast<unsigned>(variable - 1000);
        const bool told =
            bit < 32 &&
            (static_cast<std::uint32_t>(plc_->signal[PlcSignal{signals::cp_uin}(channel_)]) >> bit &
             1u) != 0;
        return inputs.input[bit] != 0 || told;
    }
    if (variable >= 1100 && variable < 1200)
        return plc_->output[static_cast<std::size_t>(variable - 1100)];
    return 0;
}

bool RunPort::measuring_input(std::string_view name, const MachineView&,
                              const std::array<double, kChannelAxes>&) {
    const auto number = input_by_name(name, channel_);
    if (!number) return false;
    PlcInputs inputs;
    while (!kernel_->plc_inputs.read(inputs)) {}
    return inputs.input[*number] != 0;
}

std::optional<double> RunPort::given_variable(std::string_view name) {
    if (!setup_) return std::nullopt;
    for (const text::SetupVariable& variable : setup_->channel(channel_).variables)
        if (variable.name == name && !variable.is_text) return variable.value;
    return std::nullopt;
}

// The setup's clock goes on with the machine's time, so that a virtual run reads the same every
// time.
CalendarTime RunPort::clock() {
    std::tm at{};
    if (setup_ && setup_->clock) {
        const text::Clock& c = *setup_->clock;
        at.tm_year = c.year - 1900;
        at.tm_mon = c.month - 1;
        at.tm_mday = c.day;
        at.tm_hour = c.hour;
        at.tm_min = c.minute;
        at.tm_sec = c.second + static_cast<int>(running_ms() / 1000);
        at.tm_isdst = -1;
        timegm(&at);  // brings seconds beyond 59 into minutes, hours, days
    } else {
        // Goes on with the machine's time too, from what the computer's clock says at the first
        // question.
        const double running_s = running_ms() / 1000;
        if (!clock_began_) clock_began_ = static_cast<double>(std::time(nullptr)) - running_s;
        const auto now = static_cast<std::time_t>(*clock_began_ + running_s);
        localtime_r(&now, &at);
    }
    return {at.tm_year + 1900, at.tm_mon + 1, at.tm_mday, at.tm_hour, at.tm_min, at.tm_sec};
}

double RunPort::running_ms() {
    // P3: constant since the kernel's segment was published
    return static_cast<double>(status_->tick) *
           static_cast<double>(kernel_->tick_ns.load(std::memory_order_relaxed)) * 1e-6;
}

bool RunPort::angular_correction_off() { return plc_->signal[signals::nozagc(channel_)] != 0; }

bool RunPort::diameter_inverted(unsigned machine_axis) {
    return plc_->signal[signals::ap_diarad(machine_axis + 1)] != 0;
}

unsigned RunPort::synchronous_master(unsigned machine_axis) {
    return static_cast<unsigned>(status_->axes[machine_axis].master);
}

StrokeFlags RunPort::stroke_flags(unsigned machine_axis) {
    StrokeFlags flags = polyturn::stroke_flags(
        [&](std::uint32_t slot) { return plc_->signal[slot] != 0; }, channel_, machine_axis + 1);
    // What a superimposed master will have added when the block begins, only the kernel knows then
    // (nct part 2, 22.5).
    flags.first_off = flags.first_off || status_->axes[machine_axis].added_master != 0;
    return flags;
}

bool RunPort::second_geometry(unsigned axis) {
    if (!plc_->signal[PlcSignal{signals::cp_sgoen}(channel_)]) return false;
    const PlcSignal select = axis == 0   ? signals::cp_sgox
                             : axis == 1 ? signals::cp_sgoy
                                         : signals::cp_sgoz;
    return plc_->signal[select(channel_)] != 0;
}

bool RunPort::second_limits() { return plc_->signal[signals::actlim2(channel_)] != 0; }

void RunPort::print_positioning(const std::string& program, std::string_view device) {
    print_.close();  // a reset during output ends it
    print_path_ = !device.empty()   ? std::string(device)
                  : program.empty() ? std::string()
                                    : program + ".L" + std::to_string(channel_) + ".print";
}

// The signs around a transmission open and close it; a file grows from program to program and holds
// no signs, a device gets them.
bool RunPort::print(const MachineView&, std::string_view bytes, bool control) {
    constexpr int kTimeoutMs = 300;
    if (print_path_.empty()) return false;
    const bool device = ByteStream::is_socket(print_path_);
    if (control && bytes == "\x12" &&
        !print_.open(print_path_, ByteStream::Open::ToAppend, kTimeoutMs))
        return false;
    const bool good =
        !print_.is_open() ? control : (control && !device) || print_.write(bytes, kTimeoutMs);
    if (control && bytes != "\x12") print_.close();
    return good;
}

unsigned RunPort::selected_spindle() {
    const std::int32_t number = plc_->signal[PlcSignal{signals::cp_ssel}(channel_)];
    return number > 0 && number <= static_cast<std::int32_t>(kMaxSpindles)
               ? static_cast<unsigned>(number)
               : 0u;
}

// A program that is only interpreted (restart at a block) calls none of the tools it passes; which
// one it would be the kernel has asked.
std::optional<Port::ToolAtWork> RunPort::tool_at_work() {
    return ToolAtWork{own().tool, own().tool_offset, own().tool_radius_offset};
}

// What the kernel has reported to the store up to this barrier is in the table: two virtual runs
// read the same.
void RunPort::await_store() const {
    constexpr int kMostMs = 200;  // a store that has died is no reason to stop
    // P1: the image was published before the tail was moved
    for (int ms = 0; ms < kMostMs && store_->persist_tail.tail.load(std::memory_order_acquire) <
                                         kernel_->persist.head.load(std::memory_order_acquire);
         ++ms)
        sleep_ms(1);
}

const ToolTable* RunPort::tool_table() {
    if (!store_) return nullptr;
    if (!tools_read_) await_store();
    if (!tools_) tools_ = std::make_unique<ToolTable>();
    while (!tools_read_) tools_read_ = store_->tools.read(*tools_);
    return tools_.get();
}

const ToolEdgeTable* RunPort::tool_edges() {
    if (!store_) return nullptr;
    if (!edges_read_) await_store();
    if (!edges_) edges_ = std::make_unique<ToolEdgeTable>();
    while (!edges_read_) edges_read_ = store_->edges.read(*edges_);
    return edges_.get();
}

Port::Turning RunPort::started_by_others(unsigned) { return Turning::Watched; }

}  // namespace polyturn::channels
