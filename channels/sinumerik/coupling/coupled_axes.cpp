// TRAILON, TRAILOF: an axis follows another one by a factor (sinumerik_part3 7.3); LEADON, LEADOF:
// by a curve table (7.4), whose bends break its way. Straight moves, arcs and curves take it along
// (an arc is then driven through its points); a thread of the leading axis is refused while it
// leads.
#include "channels/sinumerik/coupling/coupled_axes.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Tables count as the program writes positions.
double shown_by_table(const Execution& x, std::size_t place, double mm) {
    return counts_diameter(x, static_cast<unsigned>(place), false) ? mm * 2 : mm;
}

}  // namespace

bool p_trail(Execution& x, Call& c) {
    const std::string_view name = x.block.procedures.front().first->name;
    std::size_t follows = 0, leads = 0;
    if (!axis_argument(x, c, 0, name, follows)) return false;
    const bool has_leader = c.has(1);
    if (has_leader && !axis_argument(x, c, 1, name, leads)) return false;
    std::vector<Trail>& trails = x.modal.trails;
    const bool by_table = name.starts_with("LEAD");
    const auto is_meant = [&](const Trail& one) {
        return one.follows == follows && (!has_leader || one.leads == leads) &&
               (one.table != nullptr) == by_table && !one.gear;
    };
    if (name == "TRAILOF" || name == "LEADOF") {
        std::erase_if(trails, is_meant);
        return true;
    }
    if (!has_leader) return fail(x, Alarm::AxisArgumentMissing, std::string(name));
    if (x.core.compensating())
        return fail(x, Alarm::AxisExchangeIllegal, axis_name(x, static_cast<int>(follows)));
    if (leads_itself(x, follows, leads))
        return fail(x, Alarm::CodesContradict,
                    std::string(name) + "(" + axis_name(x, static_cast<int>(follows)) + "," +
                        axis_name(x, static_cast<int>(leads)) + ")");
    Trail made{follows, leads, c.number(2, 1.0)};
    if (by_table) {
        const auto found = x.curve_tables.find(static_cast<int>(c.number(2)));
        if (found == x.curve_tables.end()) return fail(x, Alarm::FunctionArgument, "LEADON", 3);
        made.number = found->first;
        made.table = std::make_shared<const CurveTable>(found->second);
        // one master value at a time
        std::erase_if(trails,
                      [&](const Trail& one) { return one.table && one.follows == follows; });
    }
    std::erase_if(trails, is_meant);
    trails.push_back(std::move(made));
    return true;
}

// Nothing may lead itself, by whatever way.
bool leads_itself(const Execution& x, std::size_t follows, std::size_t leads) {
    AxisSet reached = 1u << leads;
    for (bool again = true; again;) {
        again = false;
        for (const Trail& one : x.modal.trails)
            if ((reached >> one.follows & 1u) && !(reached >> one.leads & 1u)) {
                reached |= 1u << one.leads;
                again = true;
            }
    }
    return (reached >> follows & 1u) != 0;
}

bool is_coupled(const Execution& x, int table) {
    return std::any_of(x.modal.trails.begin(), x.modal.trails.end(),
                       [table](const Trail& one) { return one.table && one.number == table; });
}

// What the axes that follow have to do for this target. Leaders come before those that follow them,
// however deep.
AxisValues trailed(const Execution& x, AxisValues target) {
    const AxisValues own = target;
    const AxisValues& now = x.core.path.programmed;
    for (std::size_t depth = 0; depth < x.modal.trails.size(); ++depth) {
        AxisValues next = own;
        for (const Trail& one : x.modal.trails) {
            if (one.table)
                next[one.follows] =
                    one.table->at(shown_by_table(x, one.leads, target[one.leads])).value /
                    shown_by_table(x, one.follows, 1.0);
            else
                next[one.follows] += one.factor * (target[one.leads] - now[one.leads]);
        }
        if (next == target) break;
        target = next;
    }
    return target;
}

// Where the way to `wanted` (without followers) bends because a table does, from its beginning on.
bool bends_on_the_way(Execution& x, const AxisValues& wanted, std::vector<AxisValues>& bends) {
    constexpr double kNoWay = 1e-9, kMostPoints = 20'000;
    const AxisValues from = x.core.path.programmed;
    std::vector<double> shares;
    for (const Trail& one : x.modal.trails) {
        const double begin = shown_by_table(x, one.leads, from[one.leads]),
                     way = shown_by_table(x, one.leads, wanted[one.leads]) - begin;
        if (!one.table || std::fabs(way) < kNoWay) continue;
        const double length = one.table->length(), low = std::fmin(begin, begin + way),
                     high = std::fmax(begin, begin + way);
        const double first = one.table->points.front().lead;
        const double rounds = one.table->periodic == 0 ? 0 : std::floor((low - first) / length),
                     most = one.table->periodic == 0 ? 0 : std::ceil((high - first) / length);
        if ((most - rounds + 1) * static_cast<double>(one.table->points.size()) > kMostPoints)
            return fail(x, Alarm::FunctionArgument,
                        "LEADON: " + axis_name(x, static_cast<int>(one.leads)), way);
        for (double round = rounds; round <= most; ++round)
            for (const CurveTable::Point& point : one.table->points)
                if (const double share = (point.lead + round * length - begin) / way;
                    share > kNoWay && share < 1 - kNoWay)
                    shares.push_back(share);
    }
    std::ranges::sort(shares);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        if (k > 0 && shares[k] - shares[k - 1] < kNoWay) continue;
        AxisValues point = from;
        for (std::size_t i = 0; i < point.size(); ++i)
            point[i] += shares[k] * (wanted[i] - from[i]);
        bends.push_back(trailed(x, point));
    }
    return true;
}

// A coupling whose leading axis takes part in a move to `target`; nullptr none.
const Trail* leads(const Execution& x, const AxisValues& target) {
    for (const Trail& one : x.modal.trails)
        if (target[one.leads] != x.core.path.programmed[one.leads]) return &one;
    return nullptr;
}

// A thread: an axis that leads may not take part.
bool leads_nobody(Execution& x, const AxisValues& target) {
    const Trail* one = leads(x, target);
    if (!one) return true;
    return fail(x, Alarm::NotBuilt,
                std::string(one->table  ? "LEADON: "
                            : one->gear ? "EGON: "
                                        : "TRAILON: ") +
                    axis_name(x, static_cast<int>(one->leads)) + " G33");
}

}  // namespace polyturn::channels::sinumerik
