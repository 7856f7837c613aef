#include "hmi/machine/lengths.hpp"

#include <algorithm>

#include "hmi/machine/channel_words.hpp"
#include "hmi/text/tongues.hpp"

namespace polyturn::hmi {
namespace {

LengthUnit unitWith(bool inch, unsigned decimals) {
    LengthUnit out{inch ? LengthUnit::Kind::Inch : LengthUnit::Kind::Millimetre, 3};
    out.decimals = out.digits(std::clamp(decimals, 1u, 6u));
    return out;
}

}  // namespace

QString LengthUnit::text(double held) const { return lengthText(of(held), decimals); }
QString LengthUnit::text(double held, unsigned ofMillimetres) const { return lengthText(of(held), digits(ofMillimetres)); }
QString LengthUnit::name() const { return kind == Kind::Degree ? QString(QChar(0xB0)) : unitWord(nameKey()); }
QString LengthUnit::radius() const { return inch() ? word("inch, radius") : word("mm, radius"); }
QString LengthUnit::diameter() const { return inch() ? word("inch, diameter") : word("mm, diameter"); }
QString LengthUnit::perMinute() const { return unitWord(perMinuteKey()); }
QString LengthUnit::perRevolution() const { return unitWord(inch() ? "inch/rev" : "mm/rev"); }
QString LengthUnit::surfaceName() const { return unitWord(inch() ? "ft/min" : "m/min"); }
QString LengthUnit::speed(double perMinute) const { return QString::number(of(perMinute), 'f', inch() ? 1 : 0); }

LengthUnit lengthUnit(const MachineConfig& machine, unsigned channel) {
    if (channel < 1 || channel > kMaxChannels) return {};
    const ChannelConfig& config = machine.channel(channel);
    return unitWith(config.inch, config.decimals());
}

LengthUnit lengthUnit(const MachineConfig& machine, const AxisConfig& axis) {
    LengthUnit out = lengthUnit(machine, axis.channel);
    if (axis.rotary) out = {LengthUnit::Kind::Degree, out.inch() ? out.decimals - 1 : out.decimals};
    return out;
}

LengthUnit commonUnit(const MachineConfig& machine) {
    bool any = false, all = true;
    for (unsigned channel = 1; channel <= machine.last_channel; ++channel)
        if (machine.channel(channel).exists()) any = true, all = all && machine.channel(channel).inch;
    return unitWith(any && all, 3);
}

}  // namespace polyturn::hmi
