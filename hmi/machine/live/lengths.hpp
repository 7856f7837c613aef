// In which unit lengths are shown and entered: millimetres, or inches where the measuring devices
// of the channel count inches (N0104 #0 IND, nct_parameters_part1 1.3 and 3.3). What the machine
// holds stays in millimetres and degrees: only here, at the eyes and at the fingers, is it another
// number. Parameters are the exception: they are held in the unit that their row says
// (ipc/params/unit.hpp).
#pragma once
#include <QString>

#include "ipc/model/machine/machine_config.hpp"

namespace polyturn::hmi {

struct LengthUnit {
    enum class Kind : std::uint8_t { Millimetre, Inch, Degree } kind = Kind::Millimetre;
    // of a position in it: an inch has one more than a millimetre
    unsigned decimals = 3;

    bool inch() const { return kind == Kind::Inch; }
    double size() const { return inch() ? 25.4 : 1.0; }  // of one of it, as it is held
    double of(double held) const { return held / size(); }
    double held(double shown) const { return shown * size(); }
    // The decimals of something that in millimetres has so many; of a whole number none.
    unsigned digits(unsigned ofMillimetres) const {
        return ofMillimetres == 0 ? 0 : ofMillimetres + (inch() ? 1 : 0);
    }
    QString text(double held) const;
    QString text(double held, unsigned ofMillimetres) const;
    QString name() const;  // mm, inch, °
    // «mm, radius»: where X is one, whatever it shows elsewhere
    QString radius() const;
    QString diameter() const;
    QString perMinute() const;
    QString perRevolution() const;
    // a feed as it changes: as many digits as an eye can follow
    QString speed(double perMinute) const;
    double surface(double metresPerMinute) const {
        return inch() ? metresPerMinute / 0.3048 : metresPerMinute;
    }
    QString surfaceName() const;  // m/min, ft/min
    // for unitWord(), in recorded data
    const char* nameKey() const { return inch() ? "inch" : kind == Kind::Degree ? "deg" : "mm"; }
    const char* perMinuteKey() const {
        return inch() ? "inch/min" : kind == Kind::Degree ? "deg/min" : "mm/min";
    }
};

LengthUnit lengthUnit(const MachineConfig& machine, unsigned channel);
// What the controller says in millimetres («at most 1 mm»), in the unit that screens take; in
// millimetres as it is.
QString retoldLengths(const QString& text, const LengthUnit& unit);
// Every number of a text multiplied: an outline «X -60:0 Z -20:5» in the other unit.
QString scaledNumbers(const QString& text, double factor);
// of a turning axis degrees
LengthUnit lengthUnit(const MachineConfig& machine, const AxisConfig& axis);
// One unit for what belongs to no channel (tools of a magazine, stock): inches only where all
// channels count them.
LengthUnit commonUnit(const MachineConfig& machine);

}  // namespace polyturn::hmi
