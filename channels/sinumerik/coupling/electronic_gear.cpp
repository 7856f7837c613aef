// Electronic gear: an axis follows up to five others by ratios (sinumerik_part3 7.19). What follows
// is computed as for TRAILON; a gear that is switched on with positions brings its axis to the
// place that belongs to where its leaders stand.
#include "channels/sinumerik/coupling/electronic_gear.hpp"

#include <algorithm>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::string_view kGearChange[] = {"NOC", "FINE", "COARSE", "IPOSTOP"};
constexpr std::string_view kGearApproach[] = {"NTGT", "NTGP", "ACN", "ACP", "DCT", "DCP"};

bool among(std::span<const std::string_view> words, const std::string& text) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

bool gear_is_on(const Execution& x, std::size_t follows) {
    return std::any_of(x.modal.trails.begin(), x.modal.trails.end(),
                       [follows](const Trail& one) { return one.gear && one.follows == follows; });
}

// A position as an argument says it: in the program's unit, of a diameter where the axis counts in
// diameters.
double from_said(const Execution& x, std::size_t place, double value) {
    const double mm = x.core.view().axes[place].rotary ? value : value * unit(x);
    return counts_diameter(x, static_cast<unsigned>(place), false) ? mm / 2 : mm;
}

}  // namespace

// EGDEF(follower, leader, type, ...): 0 couples the leader's actual value, 1 its setpoint; programs
// see no difference.
bool p_gear_define(Execution& x, Call& c) {
    std::size_t follows = 0;
    if (!axis_argument(x, c, 0, "EGDEF", follows)) return false;
    if (c.arguments.size() % 2 == 0 || c.arguments.size() < 3)
        return fail(x, Alarm::ArgumentCountIllegal, "EGDEF",
                    static_cast<double>(c.arguments.size()));
    AxisSet leaders = 0;
    for (std::size_t k = 1; k < c.arguments.size(); k += 2) {
        std::size_t leads = 0;
        if (!axis_argument(x, c, k, "EGDEF", leads)) return false;
        const double type = c.has(k + 1) && c.value(k + 1).is_number() ? c.number(k + 1) : -1;
        if (leads == follows || (type != 0 && type != 1))
            return fail(x, Alarm::FunctionArgument, "EGDEF",
                        static_cast<double>(leads == follows ? k + 1 : k + 2));
        leaders |= 1u << leads;
    }
    if (gear_is_on(x, follows)) return fail(x, Alarm::CodesContradict, "EGDEF, EGON");
    x.modal.gear_leaders[follows] = leaders;
    return true;
}

// EGON(follower, change, (leader, numerator, denominator)...), EGONSYN with the positions that
// belong together, EGONSYNE with an approach besides, which is that of the shorter way here.
bool p_gear_on(Execution& x, Call& c) {
    const std::string name(x.block.procedures.front().first->name);
    const bool by_positions = name != "EGON";
    std::size_t follows = 0;
    if (!axis_argument(x, c, 0, name, follows)) return false;
    const auto wrong = [&](std::size_t k) {
        return fail(x, Alarm::FunctionArgument, name, static_cast<double>(k + 1));
    };
    if (x.modal.gear_leaders[follows] == 0)
        return fail(x, Alarm::CodesContradict, name + ", EGDEF");
    if (x.core.compensating())
        return fail(x, Alarm::AxisExchangeIllegal, axis_name(x, static_cast<int>(follows)));
    const auto word_at = [&](std::size_t k, std::span<const std::string_view> words) {
        return c.has(k) && c.value(k).type == Type::String && among(words, upper(c.value(k).text));
    };
    if (!word_at(1, kGearChange)) return wrong(1);
    if (name == "EGONSYNE" && !word_at(3, kGearApproach)) return wrong(3);
    const std::size_t first = name == "EGON"      ? 2
                              : name == "EGONSYN" ? 3
                                                  : 4,
                      group = by_positions ? 4 : 3;
    if (c.arguments.size() < first + group || (c.arguments.size() - first) % group != 0)
        return fail(x, Alarm::ArgumentCountIllegal, name, static_cast<double>(c.arguments.size()));
    for (std::size_t k = 2; k < c.arguments.size(); ++k)
        if (!c.has(k)) return wrong(k);
    std::vector<Trail> made;
    AxisValues target = x.core.path.programmed;
    if (by_positions) target[follows] = from_said(x, follows, c.number(2));
    for (std::size_t k = first; k < c.arguments.size(); k += group) {
        std::size_t leads = 0;
        if (!axis_argument(x, c, k, name, leads)) return false;
        if (!(x.modal.gear_leaders[follows] >> leads & 1u)) return wrong(k);
        const std::size_t ratio = by_positions ? k + 2 : k + 1;
        if (c.number(ratio + 1) == 0) return wrong(ratio + 1);
        Trail one{follows, leads, c.number(ratio) / c.number(ratio + 1)};
        one.gear = true;
        if (by_positions)
            target[follows] +=
                one.factor * (x.core.path.programmed[leads] - from_said(x, leads, c.number(k + 1)));
        made.push_back(one);
    }
    std::erase_if(x.modal.trails,
                  [&](const Trail& one) { return one.gear && one.follows == follows; });
    for (const Trail& one : made)
        if (leads_itself(x, follows, one.leads))
            return fail(x, Alarm::CodesContradict,
                        name + "(" + axis_name(x, static_cast<int>(follows)) + "," +
                            axis_name(x, static_cast<int>(one.leads)) + ")");
    x.modal.trails.insert(x.modal.trails.end(), made.begin(), made.end());
    return !by_positions || x.core.rapid(target);
}

// EGOFS(follower, leaders...): those named, or all; EGOFC(follower): all; EGDEL(follower): forgets
// the definition of one that is off.
bool p_gear_off(Execution& x, Call& c) {
    const std::string name(x.block.procedures.front().first->name);
    std::size_t follows = 0;
    if (!axis_argument(x, c, 0, name, follows)) return false;
    AxisSet released = c.arguments.size() > 1 ? 0 : ~AxisSet{0};
    for (std::size_t k = 1; k < c.arguments.size(); ++k) {
        std::size_t leads = 0;
        if (!axis_argument(x, c, k, name, leads)) return false;
        released |= 1u << leads;
    }
    if (name == "EGDEL") {
        if (gear_is_on(x, follows)) return fail(x, Alarm::CodesContradict, "EGDEL, EGON");
        x.modal.gear_leaders[follows] = 0;
        return true;
    }
    std::erase_if(x.modal.trails, [&](const Trail& one) {
        return one.gear && one.follows == follows && (released >> one.leads & 1u);
    });
    return true;
}

}  // namespace polyturn::channels::sinumerik
