// The port of a running channel: answers from the machine's picture as of the tick at which the
// barrier was reached.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "channels/hold/kept_text.hpp"
#include "channels/port.hpp"
#include "channels/text/byte_stream.hpp"
#include "ipc/image/segments.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::channels {

class RunPort : public Port {
public:
    RunPort(const KernelSegment& kernel, unsigned channel);
    void configure(const MachineConfig& machine, const text::Setup* setup) {
        machine_ = &machine;
        setup_ = setup;
    }
    void look();  // takes the picture: at cycle start and when a barrier has been reached
    // While a program is only interpreted (restart at a block) its axes are where it has sent them,
    // not at their actual positions.
    void pretend(std::function<double(unsigned machine_axis)> position) {
        pretended_ = std::move(position);
    }

    std::optional<double> axis_command(unsigned machine_axis) override;
    std::optional<double> axis_taken_over(unsigned machine_axis) override;
    std::optional<double> axis_measured(unsigned machine_axis) override;
    std::optional<double> axis_position(unsigned machine_axis) override;
    double axis_added(unsigned machine_axis) override;
    std::optional<double> axis_at_skip(unsigned machine_axis) override;
    bool block_skip(unsigned number) override;
    bool optional_stop() override;
    bool single_block() override;
    double interface_value(std::int32_t variable) override;
    bool measuring_input(std::string_view name, const MachineView&,
                         const std::array<double, kChannelAxes>&) override;
    std::optional<double> given_variable(std::string_view name) override;
    CalendarTime clock() override;
    double running_ms() override;
    double lamp_ms() override { return own().lit_s * 1e3; }
    bool angular_correction_off() override;
    bool axis_referenced(unsigned machine_axis) override {
        return pretended_ ||
               (status_->axes[machine_axis].flags & (kReferenced | kExists)) != kExists;
    }
    StrokeFlags stroke_flags(unsigned machine_axis) override;
    bool diameter_inverted(unsigned machine_axis) override;
    unsigned synchronous_master(unsigned machine_axis) override;
    bool second_geometry(unsigned axis) override;
    bool second_limits() override;
    double feed_override() override { return own().feed_override; }
    double spindle_override(unsigned spindle) override {
        return status_->spindles[spindle - 1].override;
    }
    std::optional<double> spindle_speed(unsigned spindle) override {
        return std::abs(status_->spindles[spindle - 1].speed);
    }
    std::optional<double> spindle_turns(unsigned spindle) override {
        return status_->spindles[spindle - 1].speed;
    }
    unsigned selected_spindle() override;
    std::optional<ToolAtWork> tool_at_work() override;
    const ToolTable* tool_table() override;
    const ToolEdgeTable* tool_edges() override;
    bool tools_kept() const { return store_ != nullptr; }
    // null: there is no tool management
    void tools_from(const StoreSegment* store) { store_ = store; }
    // What the program prints goes to `device` (PT_PRINT_TO), or into a file beside it:
    // <program>.L<channel>.print; without a program (MDI) nowhere.
    void print_positioning(const std::string& program, std::string_view device);
    bool print(const MachineView& view, std::string_view bytes, bool control) override;
    void keep_in(std::string folder) { kept_ = KeptText(std::move(folder), channel_); }
    // a search only reads
    bool keep(std::string_view name, std::string_view text) override {
        return pretended_ || kept_.put(name, text);
    }
    std::string kept(std::string_view name) override { return kept_.get(name); }
    DialogueAnswers dialogue_answers() override { return std::exchange(answers_, {}); }
    // filled by the events that come while the program is stopped
    DialogueAnswers& answers() { return answers_; }
    Turning started_by_others(unsigned spindle) override;
    const MachineStatus& picture() const { return *status_; }

private:
    void await_store() const;
    const ChannelStatus& own() const { return status_->channels[channel_ - 1]; }
    const KernelSegment* kernel_;
    unsigned channel_;
    const StoreSegment* store_ = nullptr;
    std::unique_ptr<ToolTable> tools_;  // read on demand
    std::unique_ptr<ToolEdgeTable> edges_;
    bool tools_read_ = false, edges_read_ = false;
    const MachineConfig* machine_ = nullptr;
    const text::Setup* setup_ = nullptr;
    std::unique_ptr<MachineStatus> status_;
    std::unique_ptr<PlcOutputs> plc_;
    KeptText kept_{{}, 0};
    std::string print_path_;
    // what the computer's clock said when the machine's time began, seconds
    std::optional<double> clock_began_;
    ByteStream print_;
    std::function<double(unsigned)> pretended_;
    DialogueAnswers answers_;
};

}  // namespace polyturn::channels
