#include "toolmgmt/tools/places.hpp"

#include <algorithm>
#include <cmath>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::toolmgmt {
namespace p = params;
namespace {

constexpr std::int32_t kMagazines = 4;
constexpr double kApart = 2.0;  // half places from one place to the next

double global(const p::Table& t, const char* number) {
    const p::Row* row = p::find(number);
    return row ? t.numbers[row->first_slot] : 0.0;
}

std::string numbered(int first, int n) {
    char text[8];
    std::snprintf(text, sizeof text, "N%04d", (first + n) % 10000);
    return text;
}

void add(ToolPlaceTable& out, const StoreValues& values, std::int32_t magazine, std::int32_t pot,
         PlaceKind kind, double row, double column, bool half) {
    if (out.count == kToolPlaces) return;
    ToolPlace& place = out.places[out.count++];
    place = {};
    place.magazine = magazine;
    place.pot = pot;
    place.kind = static_cast<std::uint32_t>(kind);
    place.row = row;
    place.column = column;
    if (half) place.state |= kPlaceHalf;
    const auto cell = [&](const char* name) {
        const Cell* found = values.cell({Kind::Place, magazine, pot, 0, name});
        return found ? found->number : 0.0;
    };
    if (cell("locked") != 0.0) place.state |= kPlaceLocked;
    place.place_type = static_cast<std::int32_t>(cell("place_type"));
}

// Length of the ring in half places; 0: no ring.
double ring_of(const ToolPlaceTable& places, const ToolPlace& of) {
    if (of.kind == static_cast<std::uint32_t>(PlaceKind::Matrix)) return 0.0;
    double full = 0;
    for (std::size_t i = 0; i < places.count; ++i)
        if (places.places[i].magazine == of.magazine && !(places.places[i].state & kPlaceHalf))
            ++full;
    return full * kApart;
}

bool overlap(const ToolRow& a, const ToolPlace& at, const ToolRow& b, const ToolPlace& other,
             double ring) {
    enum { Left, Right, Up, Down };
    const auto beside = [&](double d) {  // b lies d to the right of a
        return d > 0   ? a.size[Right] + b.size[Left] > d
               : d < 0 ? a.size[Left] + b.size[Right] > -d
                       : true;
    };
    const double d = other.column - at.column;
    if (ring > 0) {
        const double forward = std::fmod(d + ring, ring);
        return forward == 0 || beside(forward) || beside(forward - ring);
    }
    const double down = other.row - at.row;
    const bool rows = down > 0   ? a.size[Down] + b.size[Up] > down
                      : down < 0 ? a.size[Up] + b.size[Down] > -down
                                 : true;
    return rows && beside(d);
}

}  // namespace

TurretOf turret_of(const p::Table& t, unsigned channel) {
    TurretOf out;
    out.magazine = static_cast<std::int32_t>(p::get(t, p::pt_turret_magazine, channel));
    out.stations = static_cast<std::int32_t>(p::get(t, p::pt_turret_stations, channel));
    out.half = p::get(t, p::pt_turret_half, channel) != 0;
    return out;
}

std::int32_t tool_spindle(const p::Table& t, unsigned channel) {
    if (const auto driven = static_cast<std::int32_t>(p::get(t, p::pt_driven_spindle, channel)))
        return driven;
    return static_cast<std::int32_t>(p::get(t, p::n0604_default_spindle, channel));
}

void derive_places(const StoreValues& values, ToolPlaceTable& out) {
    const p::Table& t = values.parameters;
    out.count = 0;
    for (std::int32_t m = 1; m <= kMagazines; ++m) {
        const auto first = static_cast<std::int32_t>(global(t, numbered(2906, m - 1).c_str()));
        const bool matrix = p::bit(t, p::n2905_magazine_config, static_cast<unsigned>(m - 1));
        if (matrix) {
            const auto rows =
                static_cast<std::int32_t>(global(t, numbered(2914, 2 * (m - 1)).c_str()));
            const auto columns =
                static_cast<std::int32_t>(global(t, numbered(2915, 2 * (m - 1)).c_str()));
            for (std::int32_t r = 0; r < std::min(rows, 1000); ++r)
                for (std::int32_t c = 0; c < std::min(columns, 1000); ++c)
                    add(out, values, m, first + r * columns + c, PlaceKind::Matrix, r * kApart,
                        c * kApart, false);
            continue;
        }
        TurretOf turret;
        for (unsigned l = 1; l <= kMaxChannels && !turret.magazine; ++l)
            if (const TurretOf one = turret_of(t, l); one.magazine == m) turret = one;
        auto pots = static_cast<std::int32_t>(global(t, numbered(2910, m - 1).c_str()));
        if (turret.magazine && pots == 0) pots = turret.stations;
        const bool half = turret.magazine && turret.half;
        const std::int32_t full = half ? (pots + 1) / 2 : pots;
        for (std::int32_t i = 0; i < std::min(pots, 2000); ++i)
            add(out, values, m, first + i, turret.magazine ? PlaceKind::Turret : PlaceKind::Chain,
                0, i < full ? i * kApart : (i - full) * kApart + 1, i >= full);
    }
    for (std::uint32_t s = 1; s <= kMaxSpindles; ++s) {
        if (!p::bit(t, p::n0607_spindle_config, s, 0)) continue;  // there is no such spindle
        if (p::bit(t, p::n2922_spindle_magazines, s, 0))
            add(out, values, static_cast<std::int32_t>(10 * s), 1, PlaceKind::Spindle, 0, 0, false);
        if (p::bit(t, p::n2922_spindle_magazines, s, 1))
            add(out, values, static_cast<std::int32_t>(10 * s + 1), 1, PlaceKind::Arm, 0, 0, false);
    }
    std::sort(out.places.begin(), out.places.begin() + static_cast<std::ptrdiff_t>(out.count),
              [](const ToolPlace& a, const ToolPlace& b) {
                  return a.magazine != b.magazine ? a.magazine < b.magazine : a.pot < b.pot;
              });
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (!row.used || row.magazine == 0) continue;
        if (const ToolPlace* place = find_place(out, row.magazine, row.pot))
            const_cast<ToolPlace*>(place)->tool = static_cast<std::int32_t>(i + 1);
    }
}

const ToolPlace* find_place(const ToolPlaceTable& places, std::int32_t magazine, std::int32_t pot) {
    const ToolPlace* const end = places.places.data() + places.count;
    const ToolPlace* const at = std::lower_bound(
        places.places.data(), end, std::pair(magazine, pot),
        [](const ToolPlace& one, const std::pair<std::int32_t, std::int32_t>& wanted) {
            return one.magazine != wanted.first ? one.magazine < wanted.first
                                                : one.pot < wanted.second;
        });
    return at != end && at->magazine == magazine && at->pot == pot ? at : nullptr;
}

std::string place_name(std::int32_t magazine, std::int32_t pot) {
    if (magazine >= 10 && magazine % 10 == 0) return "spindle S" + std::to_string(magazine / 10);
    if (magazine >= 10 && magazine % 10 == 1)
        return "change arm of S" + std::to_string(magazine / 10);
    return "magazine " + std::to_string(magazine) + " pot " + std::to_string(pot);
}

Result<void> place_fits(const StoreValues& values, const ToolPlaceTable& places,
                        std::int32_t number, const ToolPlace& place) {
    const ToolRow& tool = *values.tool(number);
    const std::string name = place_name(place.magazine, place.pot);
    if (place.state & kPlaceLocked)
        return Diagnosis{Alarm::ToolPlaceTaken, {}, {}, name + " is locked"};
    if (place.tool != 0 && place.tool != number)
        return Diagnosis{
            Alarm::ToolPlaceTaken, {}, {}, name + " holds tool " + std::to_string(place.tool)};
    if (tool.place_type != 0 && place.place_type != 0 && tool.place_type != place.place_type)
        return Diagnosis{Alarm::ToolPlaceSmall,
                         {},
                         {},
                         "tool " + std::to_string(number) + " needs places of kind " +
                             std::to_string(tool.place_type) + ", " + name + " is of kind " +
                             std::to_string(place.place_type)};
    if (place.kind >= static_cast<std::uint32_t>(PlaceKind::Spindle)) return {};
    const double ring = ring_of(places, place);
    if (ring > 0 && tool.size[0] + tool.size[1] > ring)
        return Diagnosis{Alarm::ToolPlaceSmall,
                         {},
                         {},
                         "tool " + std::to_string(number) + " needs " +
                             shortest_text(tool.size[0] + tool.size[1]) +
                             " half places, the magazine has " + shortest_text(ring)};
    for (std::size_t i = 0; i < places.count; ++i) {
        const ToolPlace& other = places.places[i];
        if (other.magazine != place.magazine || other.pot == place.pot || other.tool == 0 ||
            other.tool == number)
            continue;
        if (overlap(tool, place, *values.tool(other.tool), other, ring))
            return Diagnosis{Alarm::ToolPlaceSmall,
                             {},
                             {},
                             "tool " + std::to_string(number) + " in " + name +
                                 " would touch tool " + std::to_string(other.tool) + " in " +
                                 place_name(other.magazine, other.pot)};
    }
    return {};
}

double travel_between(const ToolPlaceTable& places, const ToolPlace& from, const ToolPlace& to) {
    const double ring = ring_of(places, from);
    if (ring <= 0)
        return (std::fabs(to.column - from.column) + std::fabs(to.row - from.row)) / kApart;
    const double forward = std::fmod(to.column - from.column + ring, ring);
    return (2 * forward <= ring ? forward : forward - ring) / kApart;
}

const ToolPlace* nearest_free(const StoreValues& values, const ToolPlaceTable& places,
                              std::int32_t tool, std::int32_t magazine, std::int32_t from) {
    const ToolPlace* start = find_place(places, magazine, from);
    const ToolPlace* best = nullptr;
    double best_way = 0;
    for (std::size_t i = 0; i < places.count; ++i) {
        const ToolPlace& place = places.places[i];
        if (place.magazine != magazine) continue;
        if (!start) start = &place;  // nobody said from where: from the first place
        if (place.tool != 0 || !place_fits(values, places, tool, place)) continue;
        const double way = std::fabs(travel_between(places, *start, place));
        if (!best || way < best_way) {
            best = &place;
            best_way = way;
        }
    }
    return best;
}

}  // namespace polyturn::toolmgmt
