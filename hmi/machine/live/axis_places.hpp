// An axis of a channel as every screen shows it: where it is in the coordinates of workpiece and
// machine, what is left of the block, how far it lags behind. Each text is made when it is asked
// for: small cards show two of the four.
#pragma once
#include <QString>

#include "hmi/machine/live/lengths.hpp"
#include "hmi/machine/live/live.hpp"

namespace polyturn::hmi {

class AxisPlaces {
public:
    // place: among the channel's axes, from 0
    AxisPlaces(const Live& live, unsigned channel, std::size_t place);

    const AxisConfig& axis;
    const AxisStatus& now;
    LengthUnit unit;
    bool turns = false;       // its drive belongs to the spindle just now: the axis is nowhere
    bool referenced = false;  // or that of a spindle, whose encoder knows its place
    bool moves = false, goes = false;  // now; in the block under way

    QString name() const;
    QString spindle() const;  // «turns as spindle S1»
    bool known() const { return known_; }
    QString workpiece() const;  // «–»: the workpiece's coordinates are not known
    // also of one without reference: what it counts since it was switched on
    QString machine() const;
    QString machineOrNone() const;  // «no ref.»
    QString toGo() const;
    QString lag() const;  // following error

private:
    const Live& live_;
    unsigned channel_, place_;
    bool known_ = false;
    double workpiece_ = 0;
};

}  // namespace polyturn::hmi
