// Angular axis control (fanuc_lathe 10.5): the X slide is inclined, programs are written and
// positions are shown at right angles.
//
//        X slide  /|        real X = X / cos(a)         X a radius
//                / |        real Z = Z - X * tan(a)
//               /a | X
//   ------------+--+----> Z
#pragma once
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/table.hpp"

namespace polyturn {

struct AngularAxes {
    bool on = false;
    unsigned angular = 0, square = 1;  // places in the channel
    double cosine = 1.0, tangent = 0.0, radians = 0.0;
    // NOZAGC: Z keeps the correction that it had, whatever X does
    bool uncorrected = false;
    double kept = 0.0;  // that correction, mm

    template <class Values>
    void to_machine(Values& values) const {
        const double x = values[angular];
        values[square] -= uncorrected ? kept : x * tangent;
        values[angular] = x / cosine;
    }
    double x_of(double real) const { return real * cosine; }
    double z_of(double real_x, double real_z) const {
        return real_z + (uncorrected ? kept : real_x * cosine * tangent);
    }
};

// F8200 and on; x and z are the places of the basic axes of the channel's planes (-1: none), which
// F8211 and F8212 may replace.
// `usable` is false for an angle that no slide can have.
AngularAxes angular_axes(const params::Table& table, unsigned channel, unsigned axis_count, int x,
                         int z, bool& usable);

}  // namespace polyturn
