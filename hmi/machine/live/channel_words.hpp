// A channel's state and the reason of a stop, in words and signs of the display language.
#pragma once
#include "hmi/machine/live/alarm_log.hpp"
#include "hmi/machine/live/tone.hpp"

namespace polyturn::hmi {

StateWords stateWords(const ChannelStatus& status);
QString modeWord(std::uint32_t mode);

// The most important state now: the active alarm, what the channel waits for, what a start still
// needs, why it is stopped.
struct Plight {
    enum class Kind : std::uint8_t { None, Alarm, Waits, Needs, Stands, Told } kind = Kind::None;
    QString text;
};
Plight plight(const Live& live, const AlarmLog& alarms, unsigned channel);
// «Waits at M503 for L2, 12 s»; empty: it does not wait
QString waitWords(const Live& live, unsigned channel);
bool storeHasLost(const Live& live);  // no start until a backup is restored, or a maker confirms
QStringList startNeeds(const Live& live, unsigned channel);  // each with what to do
// a start would begin something, and nothing is selected or entered: the kernel says so
bool lacksProgram(const Live& live, unsigned channel);
bool works(const ChannelStatus& status);  // a program runs, or is to go on

// Machine groups (N0000): of the channels that there are, in order; those of one group, 0 of all.
std::vector<unsigned> groupsOf(const Live& live);
std::vector<unsigned> channelsOf(const Live& live, unsigned group);
unsigned groupOf(const Live& live, unsigned channel);  // 0: the machine has only one
// What one start of a group (0: of all channels) would do, as the kernel does it
// (Machine::start_channels).
struct StartPlan {
    // passed: nothing is selected, so they are left alone
    std::vector<unsigned> goOn, begin, passed;
    // the programs that would begin: another one makes another question
    QString subject;
};
StartPlan startPlan(const Live& live, unsigned group);
QString channelList(const std::vector<unsigned>& channels);  // «L1 L3»

QString timeText(double seconds);  // 1:02:03, 2:03
// always with hours: of counters, where 1:15 could be either
QString hoursText(double seconds);
QString lengthText(double value, unsigned decimals);
// As displays show an axis: X as a diameter on a diameter axis.
double shown(const AxisConfig& axis, double trueValue);
// The same of a position, not of a travel: a turning axis is somewhere within its turn, however
// often it has turned.
double shownPlace(const AxisConfig& axis, double trueValue);
// As the offset tables hold it: a diameter where offsets of the axis are diameters.
double inTable(const AxisConfig& axis, double trueValue);
unsigned decimalsOf(const MachineConfig& machine, const AxisConfig& axis);
QString channelTitle(const Live& live, unsigned channel);  // «L1», or with its name

// What the store calls «L1 offset 3 wear X» and «L1 G54 Z», as the tables of offsets and zeros do.
QString cellTitle(const QString& what);
QString zeroTitle(const QString& name);  // of a system of zeros, as a user reads it

}  // namespace polyturn::hmi
