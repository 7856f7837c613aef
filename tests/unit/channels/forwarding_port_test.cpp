// A port between the interpreter and the machine asks the machine everything that it does not
// answer itself.
#include "channels/forwarding_port.hpp"

#include <gtest/gtest.h>

#include <string>

namespace polyturn::channels {
namespace {

struct Machine final : Port {
    std::optional<double> axis_command(unsigned a) override { return a + 1.0; }
    std::optional<double> axis_taken_over(unsigned) override { return std::nullopt; }
    std::optional<double> axis_measured(unsigned a) override { return a + 2.0; }
    std::optional<double> axis_position(unsigned a) override { return a + 3.0; }
    double axis_added(unsigned a) override { return a + 4.0; }
    std::optional<double> axis_at_skip(unsigned a) override { return a + 5.0; }
    bool block_skip(unsigned number) override { return number == 3; }
    bool optional_stop() override { return true; }
    bool single_block() override { return true; }
    double interface_value(std::int32_t variable) override { return variable; }
    std::optional<double> given_variable(std::string_view) override { return 7.0; }
    CalendarTime clock() override { return {2026, 1, 2, 3, 4, 5}; }
    double running_ms() override { return 8.0; }
    double lamp_ms() override { return 9.0; }
    bool angular_correction_off() override { return true; }
    bool keep(std::string_view name, std::string_view text) override {
        kept_ = std::string(name) + "=" + std::string(text);
        return false;
    }
    std::string kept(std::string_view) override { return kept_; }
    bool second_geometry(unsigned axis) override { return axis == 1; }
    bool axis_referenced(unsigned) override { return false; }
    StrokeFlags stroke_flags(unsigned) override { return {.first_off = true}; }
    double feed_override() override { return 0.5; }
    double spindle_override(unsigned spindle) override { return spindle * 0.1; }
    std::optional<double> spindle_speed(unsigned) override { return 900.0; }
    unsigned selected_spindle() override { return 2; }
    unsigned synchronous_master(unsigned) override { return 4; }
    bool diameter_inverted(unsigned) override { return true; }
    std::optional<ToolAtWork> tool_at_work() override { return ToolAtWork{11, 12, 13}; }
    Turning started_by_others(unsigned) override { return Turning::Watched; }
    std::string kept_;
};

TEST(ForwardingPort, AsksTheNextOneEverything) {
    Machine machine;
    ForwardingPort between(machine);
    Port& port = between;
    EXPECT_EQ(port.axis_command(1), 2.0);
    EXPECT_EQ(port.axis_taken_over(1), std::nullopt);
    EXPECT_EQ(port.axis_measured(1), 3.0);
    EXPECT_EQ(port.axis_position(1), 4.0);
    EXPECT_EQ(port.axis_added(1), 5.0);
    EXPECT_EQ(port.axis_at_skip(1), 6.0);
    EXPECT_TRUE(port.block_skip(3) && !port.block_skip(2) && port.optional_stop() &&
                port.single_block());
    EXPECT_EQ(port.interface_value(1005), 1005);
    EXPECT_EQ(port.given_variable("#1"), 7.0);
    EXPECT_EQ(port.clock().day, 2);
    EXPECT_EQ(port.running_ms(), 8.0);
    EXPECT_EQ(port.lamp_ms(), 9.0);
    EXPECT_TRUE(port.angular_correction_off());
    EXPECT_FALSE(port.keep("a", "b"));
    EXPECT_EQ(port.kept("a"), "a=b");
    EXPECT_TRUE(port.second_geometry(1) && !port.axis_referenced(0) &&
                port.stroke_flags(0).first_off && port.diameter_inverted(0));
    EXPECT_EQ(port.feed_override(), 0.5);
    EXPECT_EQ(port.spindle_override(2), 0.2);
    EXPECT_EQ(port.spindle_speed(1), 900.0);
    EXPECT_EQ(port.selected_spindle(), 2u);
    EXPECT_EQ(port.synchronous_master(0), 4u);
    EXPECT_EQ(port.tool_at_work()->radius_offset, 13);
    EXPECT_EQ(port.started_by_others(1), Port::Turning::Watched);
}

}  // namespace
}  // namespace polyturn::channels
