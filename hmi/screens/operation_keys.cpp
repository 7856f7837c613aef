#include "hmi/screens/operation_keys.hpp"

#include <algorithm>

#include "hmi/machine/channel_words.hpp"

namespace polyturn::hmi {
namespace {

bool there(const Desk& desk) { return desk.live.connected() && !desk.live.channels().empty(); }
QString nameOf(unsigned channel) { return QString("L%1").arg(channel); }
// How a request names them; all of them it does not name.
QString whom(unsigned group) { return group ? QString(" T%1").arg(group) : QString(); }

}  // namespace

// A start from the first block where the program has been broken off is what nobody wants who has only forgotten that: it asks.
SoftKey startKey(Desk& desk) {
    const QString name = nameOf(desk.channel);
    const ChannelStatus& status = desk.live.channel(desk.channel);
    const bool anew = status.broken_off != 0 && !works(status) && static_cast<ChannelMode>(status.mode) == ChannelMode::Auto;
    return {word("Start %1").arg(name), [&desk, name] { desk.requests.press("cycle_start " + name); }, Sign::Run, there(desk), false, false,
            anew ? word("Begins anew, stood in line %1: press again").arg(status.broken_off) : QString(), {}, anew ? name : QString()};
}

SoftKey holdKey(Desk& desk) {
    const QString name = nameOf(desk.channel);
    return {word("Hold %1").arg(name), [&desk, name] { desk.requests.press("feed_hold " + name); }, Sign::Hold, there(desk)};
}

SoftKey resetKey(Desk& desk) {
    const QString name = nameOf(desk.channel);
    return {word("Reset %1").arg(name), [&desk, name] { desk.requests.press("reset " + name); }, Sign::Reset, there(desk), false, true,
            works(desk.live.channel(desk.channel)) ? word("Ends the program: press again") : QString()};
}

SoftKey singleBlockKey(Desk& desk) {
    const QString name = nameOf(desk.channel);
    const bool on = (desk.live.channel(desk.channel).keys & kKeySingleBlock) != 0;
    return {word("Single block %1").arg(name), [&desk, name, on] { desk.requests.press(QString("single_block %1=%2").arg(name, on ? "off" : "on")); }, Sign::Stop, there(desk), on};
}

// One that goes on needs no question, one that begins does.
SoftKey startGroupKey(Desk& desk, unsigned group) {
    const StartPlan plan = startPlan(desk.live, group);
    const QString question = plan.begin.empty() ? QString() : group ? word("Starts the whole group: press again") : word("Starts all channels: press again");
    return {group ? word("Start group %1").arg(group) : word("Start all"), [&desk, group] { startGroup(desk, group); }, Sign::Run, there(desk), false, false, question, {}, plan.subject};
}

SoftKey holdGroupKey(Desk& desk, unsigned group) {
    return {group ? word("Hold group %1").arg(group) : word("Hold all"), [&desk, group] { desk.requests.press("feed_hold" + whom(group)); }, Sign::Hold, there(desk)};
}

SoftKey resetGroupKey(Desk& desk, unsigned group) {
    const auto channels = channelsOf(desk.live, group);
    const bool any = std::any_of(channels.begin(), channels.end(), [&](unsigned one) { return works(desk.live.channel(one)); });
    const QString question = !any ? QString() : group ? word("Ends the programs of the group: press again") : word("Ends all programs: press again");
    return {group ? word("Reset group %1").arg(group) : word("Reset all"), [&desk, group] { desk.requests.press("reset" + whom(group)); }, Sign::Reset, there(desk), false, true, question};
}

SoftKey singleBlockGroupKey(Desk& desk, unsigned group) {
    const auto channels = channelsOf(desk.live, group);
    const bool on = there(desk) && std::all_of(channels.begin(), channels.end(), [&](unsigned one) { return (desk.live.channel(one).keys & kKeySingleBlock) != 0; });
    return {group ? word("Single block group %1").arg(group) : word("Single block all"),
            [&desk, channels, on] {
                QStringList each;
                for (const unsigned one : channels) each << QString("%1=%2").arg(nameOf(one), on ? "off" : "on");
                desk.requests.press("single_block " + each.join(' '));
            },
            Sign::Stop, there(desk), on};
}

}  // namespace polyturn::hmi
