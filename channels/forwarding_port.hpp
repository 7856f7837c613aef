// A port in front of another one: asks it everything. A port in between overrides the few
// questions that it answers itself.
#pragma once
#include "channels/port.hpp"

namespace polyturn::channels {

class ForwardingPort : public Port {
public:
    explicit ForwardingPort(Port& next) : next_(&next) {}
    std::optional<double> axis_command(unsigned a) override { return next_->axis_command(a); }
    std::optional<double> axis_taken_over(unsigned a) override { return next_->axis_taken_over(a); }
    std::optional<double> axis_measured(unsigned a) override { return next_->axis_measured(a); }
    std::optional<double> axis_position(unsigned a) override { return next_->axis_position(a); }
    double axis_added(unsigned a) override { return next_->axis_added(a); }
    std::optional<double> axis_at_skip(unsigned a) override { return next_->axis_at_skip(a); }
    bool block_skip(unsigned number) override { return next_->block_skip(number); }
    bool optional_stop() override { return next_->optional_stop(); }
    bool single_block() override { return next_->single_block(); }
    double interface_value(std::int32_t variable) override {
        return next_->interface_value(variable);
    }
    std::optional<double> given_variable(std::string_view name) override {
        return next_->given_variable(name);
    }
    bool measuring_input(std::string_view name, const MachineView& view,
                         const std::array<double, kChannelAxes>& machine) override {
        return next_->measuring_input(name, view, machine);
    }
    CalendarTime clock() override { return next_->clock(); }
    double running_ms() override { return next_->running_ms(); }
    double lamp_ms() override { return next_->lamp_ms(); }
    bool angular_correction_off() override { return next_->angular_correction_off(); }
    bool print(const MachineView& view, std::string_view bytes, bool control) override {
        return next_->print(view, bytes, control);
    }
    bool keep(std::string_view name, std::string_view text) override {
        return next_->keep(name, text);
    }
    std::string kept(std::string_view name) override { return next_->kept(name); }
    double* shared_variables() override { return next_->shared_variables(); }
    bool second_geometry(unsigned axis) override { return next_->second_geometry(axis); }
    bool second_limits() override { return next_->second_limits(); }
    bool axis_referenced(unsigned machine_axis) override {
        return next_->axis_referenced(machine_axis);
    }
    StrokeFlags stroke_flags(unsigned machine_axis) override {
        return next_->stroke_flags(machine_axis);
    }
    double feed_override() override { return next_->feed_override(); }
    double spindle_override(unsigned spindle) override { return next_->spindle_override(spindle); }
    std::optional<double> spindle_speed(unsigned spindle) override {
        return next_->spindle_speed(spindle);
    }
    std::optional<double> spindle_turns(unsigned spindle) override {
        return next_->spindle_turns(spindle);
    }
    unsigned selected_spindle() override { return next_->selected_spindle(); }
    unsigned synchronous_master(unsigned machine_axis) override {
        return next_->synchronous_master(machine_axis);
    }
    bool diameter_inverted(unsigned machine_axis) override {
        return next_->diameter_inverted(machine_axis);
    }
    std::optional<ToolAtWork> tool_at_work() override { return next_->tool_at_work(); }
    const ToolTable* tool_table() override { return next_->tool_table(); }
    const ToolEdgeTable* tool_edges() override { return next_->tool_edges(); }
    DialogueAnswers dialogue_answers() override { return next_->dialogue_answers(); }
    Turning started_by_others(unsigned spindle) override {
        return next_->started_by_others(spindle);
    }
    bool program_alarm_is_sure() override { return next_->program_alarm_is_sure(); }

protected:
    Port* next_;
};

}  // namespace polyturn::channels
