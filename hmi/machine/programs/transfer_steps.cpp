#include "hmi/machine/programs/transfer_steps.hpp"

#include <algorithm>

#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {
namespace {

constexpr long kClamp = 10, kOpen = 11;  // M codes of the chuck

template <class Handle>
long code(const params::Table& table, Handle parameter, unsigned object) {
    return static_cast<long>(params::get(table, parameter, object));
}

// Which spindles, slide and turrets take part.
struct Parties {
    unsigned main = 0, counter = 0;      // spindles
    unsigned giving = 0, receiving = 0;  // channels
    unsigned slide = 0;                  // axis whose torque is limited; 0: none
};

bool givesSpindle(const MachineConfig& config, const params::Table& table, unsigned channel,
                  unsigned spindle) {
    return config.channel(channel).default_spindle == spindle ||
           code(table, params::pt_m_spindle, channel) > 0;
}

Parties partiesOf(const MachineConfig& config, const params::Table& table,
                  const std::vector<unsigned>& channels) {
    Parties out;
    for (unsigned s = 1; s <= config.last_spindle && !out.counter; ++s)
        if (config.spindle(s).exists() && code(table, params::pt_spindle_master, s) > 0) {
            out.counter = s;
            out.main = static_cast<unsigned>(code(table, params::pt_spindle_master, s));
        }
    if (!out.counter && config.last_spindle >= 2 && config.spindle(2).exists() &&
        std::any_of(channels.begin(), channels.end(),
                    [&](unsigned channel) { return givesSpindle(config, table, channel, 2); })) {
        out.counter = 2;
        out.main = 1;
    }
    if (!out.counter || channels.empty()) return {};
    for (unsigned a = 1; a <= config.last_axis && !out.slide; ++a)
        if (config.axis(a).exists() && code(table, params::pt_m_torque, a) > 0) out.slide = a;
    if (out.slide) out.receiving = config.axis(out.slide).channel;
    for (const unsigned channel : channels)
        if (!out.receiving && config.channel(channel).default_spindle == out.counter)
            out.receiving = channel;
    if (!out.receiving) out.receiving = channels.size() > 1 ? channels[1] : channels[0];
    for (const unsigned channel : channels)
        if (!out.giving && channel != out.receiving) out.giving = channel;
    if (!out.giving) out.giving = out.receiving;
    return out;
}

}  // namespace

std::vector<TransferStep> transferSteps(const MachineConfig& config, const params::Table& table,
                                        const std::vector<unsigned>& channels) {
    const Parties who = partiesOf(config, table, channels);
    std::vector<TransferStep> out;
    if (!who.counter) return out;
    const long choice = code(table, params::pt_m_spindle, who.receiving),
               follow = code(table, params::pt_m_follow, who.counter),
               torque = who.slide ? code(table, params::pt_m_torque, who.slide) : 0;
    const bool alone = who.giving == who.receiving;
    const auto choose = [&](const char* title, unsigned spindle) {
        if (choice > 0)
            out.push_back({title, who.receiving, choice + static_cast<long>(spindle) - 1, 0});
    };
    const auto counter = [&](const char* title, long number) {
        out.push_back({title, who.receiving, number, who.counter});
    };
    const auto main = [&](const char* title, long number) {
        out.push_back({title, who.giving, number, who.main});
    };
    const char *toCounter = WORD("Plain S means the counter spindle"),
               *toMain = WORD("Plain S means the main spindle");

    choose(toCounter, who.counter);
    counter(WORD("Its chuck opens"), kOpen);
    // with the phase; the code names its spindle itself
    if (follow > 0) out.push_back({WORD("It follows the main spindle"), who.receiving, follow + 1});
    if (torque > 0) out.push_back({WORD("Little torque for the slide"), who.receiving, torque, 0});
    out.push_back({WORD("Jog against the part"), who.receiving});
    counter(WORD("Its chuck clamps"), kClamp);
    if (torque > 0) out.push_back({WORD("Full torque"), who.receiving, torque + 1, 0});
    if (alone) choose(toMain, who.main);
    main(WORD("The main chuck opens"), kOpen);
    out.push_back({WORD("Jog: pull the part out"), who.receiving});
    main(WORD("The main chuck clamps"), kClamp);
    if (follow > 0) out.push_back({WORD("The counter spindle is free"), who.receiving, follow + 2});
    if (!alone) choose(toMain, who.main);
    return out;
}

}  // namespace polyturn::hmi
