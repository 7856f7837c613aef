// The transformation that a program has switched on between its coordinates and the axes (fanuc
// G12.1, G7.1; sinumerik TRANSMIT, TRACYL, TRAANG; fagor G46). Core goes on as before: its machine
// coordinates are then path coordinates of the roles' axes (ipc/kinematics), a rotary axis among
// them counts millimetres, and everything from frames to nose-radius compensation works in the
// plane that the programmer sees. Only TransformSink, behind compensation, knows both sides.
#pragma once
#include "channels/sink.hpp"
#include "ipc/kinematics/kinematics.hpp"

namespace polyturn::channels {

// where the linear axis of the polar plane may be
enum class PoleSide : std::uint8_t { Both, Positive, Negative };

struct Transformation {
    Kinematics kinematics{};     // axis: indices in the channel; no route
    bool degrees = false;        // cylinder: the rotary axis is programmed by its angle
    std::int8_t virtual_y = -1;  // slot that replaces Y while it is on; -1 none
    bool named_y = false;        // and is programmed and shown as Y
    // polar: the rotary centre lies at the linear axis' machine zero, not at the workpiece's
    bool about_machine_zero = false;
    // Polar: the rotary axis counts as 0 at its position when the plane is switched on, and so does
    // the virtual axis (fanuc, nct G12.1). Its coordinate is preset by so many degrees until the
    // plane is off again.
    bool counts_from_here = false;
    double preset_deg = 0.0;
    PoleSide side = PoleSide::Both;
    bool active() const { return kind_of(kinematics) != KinematicsKind::None; }
    bool uses(unsigned place) const {
        for (std::size_t r = 0; r < role_count(kind_of(kinematics)); ++r)
            if (kinematics.axis[r] == place) return true;
        return false;
    }
    // The axis that is rotary without it.
    int rotary_place() const {
        switch (kind_of(kinematics)) {
            case KinematicsKind::Polar:
                return kinematics.axis[1];
            case KinematicsKind::Cylinder:
                return kinematics.axis[0];
            default:
                return -1;
        }
    }
    double degrees_per_mm() const { return 180.0 / 3.14159265358979323846 / kinematics.value[0]; }
};

// By axis index, in address coordinates (before RouteSink): path coordinates of the roles from
// those of the axes, and back.
void places_to_path(const Transformation& t, AxisValues& values);
bool places_to_axes(const Transformation& t, const Branch& branch, AxisValues& values);

}  // namespace polyturn::channels
