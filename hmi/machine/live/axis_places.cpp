#include "hmi/machine/live/axis_places.hpp"

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {

AxisPlaces::AxisPlaces(const Live& live, unsigned channel, std::size_t place)
    : axis(live.config().axis(live.config().channel(channel).axes[place])),
      now(live.status().axes[live.config().channel(channel).axes[place] - 1u]),
      unit(live.unit(axis)),
      live_(live),
      channel_(channel),
      place_(static_cast<unsigned>(place)) {
    turns = axis.on_spindle && live.nc(signals::sn_axis(axis.on_spindle)) == 0;
    referenced = (now.flags & kReferenced) != 0 || axis.on_spindle;
    moves = (now.flags & kMoving) != 0;
    goes = live.view(channel).moves[place];
    known_ = !turns && live.workpiece(channel, place_, now.act, workpiece_);
}

QString AxisPlaces::name() const { return fromView(axis.name_text()); }
QString AxisPlaces::spindle() const { return word("turns as spindle S%1").arg(axis.on_spindle); }
QString AxisPlaces::workpiece() const {
    return known_ ? unit.text(shownPlace(axis, workpiece_)) : QString::fromUtf8("–");
}
QString AxisPlaces::machine() const { return unit.text(shownPlace(axis, now.act)); }
QString AxisPlaces::machineOrNone() const { return referenced ? machine() : word("no ref."); }
QString AxisPlaces::toGo() const { return unit.text(shown(axis, live_.toGo(channel_, place_))); }
QString AxisPlaces::lag() const { return unit.text(shown(axis, now.error)); }

}  // namespace polyturn::hmi
