// Angular axis control (fanuc_lathe 10.5; formulas: ipc/model/machine/angular_axes.hpp) between the
// program and the machine.
//
// Interpreter, cycles and compensation work at right angles; this sink and this port stand between
// them and the machine. The path stays at right angles too; the kernel finds the axes at every tick
// (ipc/kinematics), so arcs stay round.
#pragma once
#include "channels/forwarding_port.hpp"
#include "channels/forwarding_sink.hpp"
#include "channels/machine_view.hpp"
#include "channels/port.hpp"
#include "ipc/model/machine/angular_axes.hpp"

namespace polyturn::channels::fanuc {

// Those of the channel that the view shows.
AngularAxes angular_axes(const MachineView& view, bool& usable);

class AngularSink final : public ForwardingSink {
public:
    AngularSink(Sink& next, Port& port, const MachineView& view, const AngularAxes& axes)
        : ForwardingSink(&next), port_(&port), view_(&view), axes_(axes) {
        kinematics_.kind = static_cast<std::uint32_t>(KinematicsKind::Inclined);
        kinematics_.axis[0] = static_cast<std::uint8_t>(axes.angular);
        kinematics_.axis[1] = static_cast<std::uint8_t>(axes.square);
        kinematics_.value[0] = axes.radians;
        kinematics_.sign.fill(1.0);
    }
    void move(const Move& m, const BlockContext& at) override;
    void follow(const AngularAxes& axes);  // at a barrier

private:
    Port* port_;
    const MachineView* view_;
    AngularAxes axes_;
    Kinematics kinematics_{};
    bool begun_ = false;
};

// Positions of the machine as the program means them.
class AngularPort final : public ForwardingPort {
public:
    AngularPort(Port& next, const MachineView& view, const AngularAxes& axes)
        : ForwardingPort(next), view_(&view), axes_(axes) {}
    std::optional<double> axis_command(unsigned a) override {
        return turned(a, [this](unsigned k) { return next_->axis_command(k); });
    }
    std::optional<double> axis_taken_over(unsigned a) override {
        return turned(a, [this](unsigned k) { return next_->axis_taken_over(k); });
    }
    std::optional<double> axis_measured(unsigned a) override {
        return turned(a, [this](unsigned k) { return next_->axis_measured(k); });
    }
    std::optional<double> axis_position(unsigned a) override {
        return turned(a, [this](unsigned k) { return next_->axis_position(k); });
    }
    void follow(const AngularAxes& axes) { axes_ = axes; }  // at a barrier
    std::optional<double> axis_at_skip(unsigned a) override {
        return turned(a, [this](unsigned k) { return next_->axis_at_skip(k); });
    }

private:
    template <class Read>
    std::optional<double> turned(unsigned machine_axis, Read&& read) {
        const unsigned x = view_->axes[axes_.angular].machine_axis,
                       z = view_->axes[axes_.square].machine_axis;
        const auto own = read(machine_axis);
        if (!own || (machine_axis != x && machine_axis != z)) return own;
        if (machine_axis == x) return axes_.x_of(*own);
        const auto other = read(x);
        return other ? std::optional<double>(axes_.z_of(*other, *own)) : std::nullopt;
    }
    const MachineView* view_;
    AngularAxes axes_;
};

}  // namespace polyturn::channels::fanuc
