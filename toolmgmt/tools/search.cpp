#include "toolmgmt/tools/search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::toolmgmt {
namespace p = params;
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();
// magazine number of S1; below it are chains, matrices and turrets (part 2, 30.2)
constexpr std::int32_t kFirstSpindlePlace = 10;

std::string_view name_of(const ToolRow& row) {
    return {row.name.data(), ::strnlen(row.name.data(), row.name.size())};
}

bool searched(const p::Table& t, unsigned channel, std::int32_t magazine) {
    if (magazine <= 0) return false;
    if (magazine >= kFirstSpindlePlace) return magazine / 10 == tool_spindle(t, channel);
    for (unsigned l = 1; l <= kMaxChannels; ++l)
        if (turret_of(t, l).magazine == magazine) return l == channel;
    return magazine <= 4 &&
           p::bit(t, p::n2901_search_config, channel, static_cast<unsigned>(magazine) + 1);
}

// Less is chosen first; equal ones by the data number.
double rank(const StoreValues& values, const ToolPlaceTable& places, const ToolQuestion& question,
            const ToolRow& row) {
    const p::Table& t = values.parameters;
    switch (static_cast<int>(p::get(t, p::pt_tool_search, question.channel))) {
        case 1:
            return row.state & kToolActive ? -1.0 : row.duplo;
        case 2:
            return row.duplo;
        case 3:
            return row.state & kToolActive ? 0.0 : 1.0;
        case 4: {
            const std::int32_t now = values.tools.in_channel[question.channel - 1];
            const ToolRow* at = values.tool(now);
            const ToolPlace* from = at ? find_place(places, at->magazine, at->pot) : nullptr;
            const ToolPlace* to = find_place(places, row.magazine, row.pot);
            return from && to && from->magazine == to->magazine
                       ? std::fabs(travel_between(places, *from, *to))
                       : 0.0;
        }
        default:
            break;
    }
    if (p::bit(t, p::n2901_search_config, question.channel, 0)) {
        const auto column = static_cast<std::size_t>(p::get(t, p::n2904_custom_life_column_no));
        return column >= 1 && column <= row.custom.size() ? row.custom[column - 1] : 0.0;
    }
    return life_left(row);
}

ToolAnswer refused(Alarm alarm, const std::string& text) {
    ToolAnswer out{};
    out.alarm = static_cast<std::int32_t>(alarm);
    std::copy_n(text.begin(), std::min(text.size(), out.text.size() - 1), out.text.begin());
    return out;
}

ToolAnswer found(const StoreValues& values, const ToolQuestion& question, std::int32_t number) {
    const ToolRow& row = *values.tool(number);
    ToolAnswer out{};
    out.alarm = -1;
    out.tool = number;
    out.magazine = row.magazine;
    out.pot = row.pot;
    out.offset = row.h_cell;
    out.radius_offset = row.d_cell;
    out.group = row.group;
    out.spindle_place = turret_of(values.parameters, question.channel).magazine == 0;
    out.life_kind = row.life_kind;
    out.left = life_left(row);
    out.group_left = group_left(values, row);
    out.warning = row.warning;
    const std::string_view name = name_of(row);
    std::copy_n(name.begin(), std::min(name.size(), out.text.size() - 1), out.text.begin());
    return out;
}

std::string called(const ToolQuestion& question) {
    const std::string channel = " in channel L" + std::to_string(question.channel);
    if (!question.name.empty()) return "T \"" + std::string(question.name) + "\"" + channel;
    return (question.by == ToolCallBy::Group ? "group " : "T") + shortest_text(question.value) +
           channel;
}

// Nothing stands there: the place is brought into position and no tool works.
ToolAnswer empty_place(std::int32_t magazine, std::int32_t pot) {
    ToolAnswer out{};
    out.alarm = -1;
    out.magazine = magazine;
    out.pot = pot;
    out.left = out.group_left = kEver;
    return out;
}

}  // namespace

bool managed(const p::Table& t) { return p::bit(t, p::n2900_tool_m_config, 0); }

bool usable(const ToolRow& row) {
    if (!(row.state & kToolEnabled) || (row.state & (kToolLocked | kToolBroken | kToolWorn)))
        return false;
    return life_left(row) > 0;
}

double life_left(const ToolRow& row) {
    if (row.life <= 0 || static_cast<LifeKind>(row.life_kind) == LifeKind::None) return kEver;
    return row.life - row.counter;
}

bool sisters(const ToolRow& a, const ToolRow& b) {
    if (!a.used || !b.used) return false;
    if (a.type_number != 0 || b.type_number != 0) return a.type_number == b.type_number;
    return !name_of(a).empty() && name_of(a) == name_of(b);
}

double group_left(const StoreValues& values, const ToolRow& row) {
    double sum = 0;
    for (const ToolRow& other : values.tools.rows)
        if (&other == &row || sisters(row, other)) sum += life_left(other);
    return sum;
}

bool reaches(const p::Table& t, unsigned channel, const ToolRow& row) {
    if (row.unit != 0 && row.unit != static_cast<std::int32_t>(p::get(t, p::pt_tool_unit, channel)))
        return false;
    return searched(t, channel, row.magazine);
}

ToolAnswer find_tool(const StoreValues& values, const ToolPlaceTable& places,
                     const ToolQuestion& asked) {
    const p::Table& t = values.parameters;
    ToolQuestion question = asked;
    const auto whole = static_cast<std::int64_t>(std::llround(question.value));
    if (question.by == ToolCallBy::Place || question.by == ToolCallBy::Location) {
        const bool location = question.by == ToolCallBy::Location;
        const auto magazine = location ? turret_of(t, question.channel).magazine
                                       : static_cast<std::int32_t>(whole / 10'000);
        const auto pot = static_cast<std::int32_t>(location ? whole : whole % 10'000);
        if (location && whole == 0) return empty_place(0, 0);
        const ToolPlace* place = find_place(places, magazine, pot);
        // Where no magazine is described (N2905 to N2921) the PLC alone knows its places.
        const bool described = places.count != 0 && places.places[0].magazine < kFirstSpindlePlace;
        if (!place && !location && !described) return empty_place(magazine, pot);
        if (!place) return refused(Alarm::ToolPlaceUnknown, place_name(magazine, pot));
        if (place->tool == 0) return empty_place(magazine, pot);
        if (!location) return found(values, question, place->tool);
        question.by = ToolCallBy::Name;
        question.name = name_of(*values.tool(place->tool));
        if (question.name.empty()) return found(values, question, place->tool);
    }
    if (question.name.empty() && whole == 0) return empty_place(0, 0);
    if (question.by == ToolCallBy::Forced && question.name.empty()) {
        const ToolRow* row = values.tool(whole);
        if (!row || !row->used) return refused(Alarm::ToolMissing, called(question));
        return found(values, question, static_cast<std::int32_t>(whole));
    }
    if (question.by == ToolCallBy::Substitute) {
        const ToolRow* row = values.tool(whole);
        if (!row || !row->used || !reaches(t, question.channel, *row))
            return refused(Alarm::ToolNotFound, called(question));
        if (usable(*row)) return found(values, question, static_cast<std::int32_t>(whole));
        for (std::size_t i = 0; i < kTools; ++i)
            if (const ToolRow& other = values.tools.rows[i];
                &other != row && sisters(*row, other) && usable(other) &&
                reaches(t, question.channel, other))
                return found(values, question, static_cast<std::int32_t>(i + 1));
        return refused(Alarm::ToolsUsedUp, called(question));
    }
    std::int32_t best = 0;
    double best_rank = 0;
    std::int32_t after_active = 0;  // duplo of the active one that may not be used any more
    bool any = false, typed = false;
    const bool next_duplo = static_cast<int>(p::get(t, p::pt_tool_search, question.channel)) == 1;
    // What is meant first: whether the channel reaches a tool takes longer to say.
    const auto meant = [&](const ToolRow& row) {
        if (!question.name.empty()) return name_of(row) == question.name;
        return question.by == ToolCallBy::Group ? row.group == whole : row.type_number == whole;
    };
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        // one of another channel tells too what T means on this machine
        typed = typed || (row.used && row.type_number != 0);
        if (!row.used || !meant(row) || !reaches(t, question.channel, row)) continue;
        any = true;
        if (!usable(row) && question.by != ToolCallBy::Forced && (row.state & kToolActive))
            after_active = row.duplo;
    }
    for (std::size_t i = 0; i < kTools && any; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (!row.used || !meant(row) || !reaches(t, question.channel, row) ||
            (!usable(row) && question.by != ToolCallBy::Forced))
            continue;
        double one =
            question.by == ToolCallBy::Group ? row.duplo : rank(values, places, question, row);
        // those before it come last
        if (next_duplo && question.by != ToolCallBy::Group && one >= 0 && row.duplo <= after_active)
            one += 10'000;
        if (best == 0 || one < best_rank) {
            best = static_cast<std::int32_t>(i + 1);
            best_rank = one;
        }
    }
    if (best) return found(values, question, best);
    if (any) return refused(Alarm::ToolsUsedUp, called(question));
    // Where nobody works with type numbers, T is the station of the turret; a station in which
    // nothing stands is no tool, and the turret does not come round with it.
    const TurretOf turret = turret_of(t, question.channel);
    if (question.name.empty() && question.by == ToolCallBy::Type && turret.magazine && !typed)
        if (const ToolPlace* place =
                find_place(places, turret.magazine, static_cast<std::int32_t>(whole))) {
            if (place->tool == 0) return refused(Alarm::ToolNotFound, called(question));
            return usable(*values.tool(place->tool))
                       ? found(values, question, place->tool)
                       : refused(Alarm::ToolsUsedUp, called(question));
        }
    return refused(Alarm::ToolNotFound, called(question));
}

}  // namespace polyturn::toolmgmt
