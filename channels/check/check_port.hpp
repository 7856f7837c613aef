// The port of check mode: there is no machine, so a barrier is reached at once and setup answers
// what a program asks.
#pragma once
#include "channels/machine_view.hpp"
#include "channels/port.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::channels {

class CheckPort final : public Port {
public:
    // `alone`: no other channel's program belongs to the check, so nobody else can have started a
    // spindle.
    CheckPort(const text::Setup& setup, unsigned channel, bool alone)
        : setup_(&setup), own_(&setup.channel(channel)), alone_(alone) {}

    std::optional<double> axis_command(unsigned) override { return std::nullopt; }
    std::optional<double> axis_measured(unsigned) override { return std::nullopt; }
    std::optional<double> axis_at_skip(unsigned machine_axis) override {
        return skipped_.at(machine_axis);
    }
    // The program delivered a skip move: the sensors of the setup say where it ends.
    void skip_move(const Move& move, const MachineView& view);
    bool block_skip(unsigned number) override;
    bool optional_stop() override { return own_->keys.optional_stop; }
    bool single_block() override { return own_->keys.single_block; }
    double interface_value(std::int32_t variable) override;
    bool measuring_input(std::string_view name, const MachineView& view,
                         const std::array<double, kChannelAxes>& machine) override;
    std::optional<double> given_variable(std::string_view name) override;
    CalendarTime clock() override;
    double running_ms() override { return 0.0; }
    double lamp_ms() override { return 0.0; }
    StrokeFlags stroke_flags(unsigned) override { return {}; }
    double* shared_variables() override { return shared_; }
    void share(double* cells) { shared_ = cells; }
    Turning started_by_others(unsigned spindle) override {
        if (alone_) return Turning::No;
        return spindle >= 1 && spindle <= kMaxSpindles && (turning_ >> (spindle - 1) & 1u)
                   ? Turning::Watched
                   : Turning::Unknown;
    }
    // A program that has read positions which follow an axis of another channel: where they
    // stand is not counted here.
    bool program_alarm_is_sure() override { return alone_ || !follows_ || !looked_; }
    void axes_follow(bool follow) { follows_ = follow; }
    void looked_at_machine() { looked_ = true; }
    // The spindles that other channels have started for certain, as of the last wait; bit 0 is
    // spindle 1.
    void others_turn(std::uint32_t spindles) { turning_ = spindles; }

private:
    const text::Setup* setup_;
    const text::ChannelSetup* own_;
    bool alone_;
    double* shared_ = nullptr;
    std::uint32_t turning_ = 0;
    bool follows_ = false, looked_ = false;
    std::array<std::optional<double>, kMaxAxes> skipped_{};
};

}  // namespace polyturn::channels
