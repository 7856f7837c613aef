#include "hmi/screens/overview/operation_keys.hpp"

#include <algorithm>

#include "hmi/machine/live/channel_words.hpp"

namespace polyturn::hmi {
namespace {

bool there(const Context& context) {
    return context.live.connected() && !context.live.channels().empty();
}
QString nameOf(unsigned channel) { return QString("L%1").arg(channel); }
// How a request names them; all of them it does not name.
QString whom(unsigned group) { return group ? QString(" T%1").arg(group) : QString(); }

}  // namespace

// A start from the first block where the program has been broken off is what nobody wants who has
// only forgotten that: it asks.
SoftKey startKey(Context& context) {
    const QString name = nameOf(context.channel);
    const ChannelStatus& status = context.live.channel(context.channel);
    const bool anew = status.broken_off != 0 && !works(status) &&
                      static_cast<ChannelMode>(status.mode) == ChannelMode::Auto;
    return {word("Start %1").arg(name),
            [&context, name] { context.requests.press("cycle_start " + name); },
            Sign::Run,
            there(context),
            false,
            false,
            anew ? word("Begins anew, stood in line %1: press again").arg(status.broken_off)
                 : QString(),
            {},
            anew ? name : QString()};
}

SoftKey holdKey(Context& context) {
    const QString name = nameOf(context.channel);
    return {word("Hold %1").arg(name),
            [&context, name] { context.requests.press("feed_hold " + name); }, Sign::Hold,
            there(context)};
}

SoftKey resetKey(Context& context) {
    const QString name = nameOf(context.channel);
    return {word("Reset %1").arg(name),
            [&context, name] { context.requests.press("reset " + name); },
            Sign::Reset,
            there(context),
            false,
            true,
            works(context.live.channel(context.channel)) ? word("Ends the program: press again")
                                                         : QString()};
}

SoftKey singleBlockKey(Context& context) {
    const QString name = nameOf(context.channel);
    const bool on = (context.live.channel(context.channel).keys & kKeySingleBlock) != 0;
    return {word("Single block %1").arg(name),
            [&context, name, on] {
                context.requests.press(QString("single_block %1=%2").arg(name, on ? "off" : "on"));
            },
            Sign::Stop, there(context), on};
}

// One that goes on needs no question, one that begins does.
SoftKey startGroupKey(Context& context, unsigned group) {
    const StartPlan plan = startPlan(context.live, group);
    const QString question = plan.begin.empty() ? QString()
                             : group            ? word("Starts the whole group: press again")
                                                : word("Starts all channels: press again");
    return {group ? word("Start group %1").arg(group) : word("Start all"),
            [&context, group] { startGroup(context, group); },
            Sign::Run,
            there(context),
            false,
            false,
            question,
            {},
            plan.subject};
}

SoftKey holdGroupKey(Context& context, unsigned group) {
    return {group ? word("Hold group %1").arg(group) : word("Hold all"),
            [&context, group] { context.requests.press("feed_hold" + whom(group)); }, Sign::Hold,
            there(context)};
}

SoftKey resetGroupKey(Context& context, unsigned group) {
    const auto channels = channelsOf(context.live, group);
    const bool any = std::any_of(channels.begin(), channels.end(),
                                 [&](unsigned one) { return works(context.live.channel(one)); });
    const QString question = !any    ? QString()
                             : group ? word("Ends the programs of the group: press again")
                                     : word("Ends all programs: press again");
    return {group ? word("Reset group %1").arg(group) : word("Reset all"),
            [&context, group] { context.requests.press("reset" + whom(group)); },
            Sign::Reset,
            there(context),
            false,
            true,
            question};
}

SoftKey singleBlockGroupKey(Context& context, unsigned group) {
    const auto channels = channelsOf(context.live, group);
    const bool on =
        there(context) && std::all_of(channels.begin(), channels.end(), [&](unsigned one) {
            return (context.live.channel(one).keys & kKeySingleBlock) != 0;
        });
    return {group ? word("Single block group %1").arg(group) : word("Single block all"),
            [&context, channels, on] {
                QStringList each;
                for (const unsigned one : channels)
                    each << QString("%1=%2").arg(nameOf(one), on ? "off" : "on");
                context.requests.press("single_block " + each.join(' '));
            },
            Sign::Stop, there(context), on};
}

}  // namespace polyturn::hmi
