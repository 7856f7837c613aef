#include "toolmgmt/apply_request.hpp"

#include <bit>
#include <cmath>
#include <string_view>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/requests/counters.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/param_file.hpp"

namespace polyturn::toolmgmt {
namespace {

Diagnosis refused(std::string why) {
    return Diagnosis{Alarm::StoreRequestBad, {}, {}, std::move(why)};
}

std::string_view name_of(const StoreRequest& request) {
    return {request.name.data(), ::strnlen(request.name.data(), request.name.size())};
}

// Bits, because an empty variable (NaN) equals nothing.
bool differs(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) != std::bit_cast<std::uint64_t>(b);
}

Result<Applied> set_number(StoreValues& values, const Key& key, double value) {
    double* at = number_at(values, key);
    if (!at) return refused(describe(key) + " does not exist");
    Applied applied;
    value += 0.0;  // -0 becomes 0: the disk knows no other
    if (differs(*at, value)) applied.changes.push_back({key, *at, value, {}, {}, false});
    *at = value;
    return applied;
}

bool channel_exists(const StoreRequest& request, const MachineConfig& machine) {
    return request.channel >= 1 && request.channel <= kMaxChannels &&
           machine.channel(request.channel).exists();
}

Diagnosis no_channel(const StoreRequest& request) {
    return refused("channel L" + std::to_string(request.channel) + " does not exist");
}

Result<Applied> set_offset(const StoreRequest& request, Origin origin, const MachineConfig& machine,
                           StoreValues& values) {
    if (!channel_exists(request, machine)) return no_channel(request);
    const ChannelConfig& channel = machine.channel(request.channel);
    const Key key{Kind::Offset,
                  offset_owner(values.parameters, machine, request.channel, request.number),
                  request.number,
                  request.field,
                  {}};
    if (!std::isfinite(request.value)) return refused(describe(key) + ": not a number");
    const auto table = static_cast<OffsetTable>(request.field / 256);
    const auto field = static_cast<OffsetField>(request.field % 256);
    if (field == OffsetField::T &&
        (request.value < 0 || request.value > 9 || request.value != std::trunc(request.value)))
        return refused(describe(key) + "=" + shortest_text(request.value) +
                       ": tip directions are 0 to 9");
    if (origin == Origin::Operator) {
        if (request.number > channel.offset_count)
            return refused("offset " + std::to_string(request.number) + ": channel L" +
                           std::to_string(request.channel) + " has " +
                           std::to_string(channel.offset_count) + " (N1400)");
        // N1415: 0 stands for one millimetre, or 0.394 inch (part 1, 15.1).
        const double stated =
            params::get(values.parameters, params::n1415_max_amount_of_wear_comp, channel.number) *
            channel.length_unit_mm();
        const double most = stated > 0                       ? stated
                            : channel.length_unit_mm() > 1.0 ? 0.394 * channel.length_unit_mm()
                                                             : 1.0;
        if (table == OffsetTable::Wear && field != OffsetField::T && std::abs(request.value) > most)
            return refused(describe(key) + "=" + shortest_text(request.value) + ": wear is " +
                           shortest_text(most) + " mm at the most (N1415)");
        const double step = params::get(values.parameters, params::pt_wear_step, channel.number) *
                            channel.length_unit_mm();
        const double* now = number_at(values, key);
        if (table == OffsetTable::Wear && field != OffsetField::T && step > 0 && now &&
            std::abs(request.value - *now) > step * (1 + 1e-9))
            return refused(describe(key) + "=" + shortest_text(request.value) +
                           ": one entry changes wear by " + shortest_text(step) +
                           " mm at the most (PT_WEAR_STEP)");
    }
    return set_number(values, key, request.value);
}

// "G54 X", "shift Z": the zero's name and an axis of the channel.
Result<Key> zero_by_name(std::string_view name, const StoreRequest& request,
                         const MachineConfig& machine) {
    const std::size_t blank = name.rfind(' ');
    if (blank == std::string_view::npos)
        return refused("\"" + std::string(name) + "\": write zero and axis, as in G54 X");
    const auto row = work_zero_row(name.substr(0, blank));
    if (!row) return refused("there is no zero offset " + std::string(name.substr(0, blank)));
    const AxisConfig* axis = find_axis(machine, request.channel, name.substr(blank + 1));
    if (!axis)
        return refused("channel L" + std::to_string(request.channel) + " has no axis " +
                       std::string(name.substr(blank + 1)));
    return Key{Kind::WorkZero,
               static_cast<std::int32_t>(request.channel),
               static_cast<std::int32_t>(*row),
               axis->slot,
               {}};
}

Result<Applied> set_work_zero(const StoreRequest& request, const MachineConfig& machine,
                              StoreValues& values) {
    if (!channel_exists(request, machine)) return no_channel(request);
    if (!std::isfinite(request.value)) return refused("zero offset: not a number");
    if (const std::string_view name = name_of(request); !name.empty()) {
        const Result<Key> key = zero_by_name(name, request, machine);
        return key ? set_number(values, *key, request.value) : Result<Applied>(key.diagnosis());
    }
    Result<Applied> done = set_number(values,
                                      {Kind::WorkZero,
                                       static_cast<std::int32_t>(request.channel),
                                       request.number,
                                       request.field & ~kVolatile,
                                       {}},
                                      request.value);
    if (done) done->until_power_off = (request.field & kVolatile) != 0;
    return done;
}

Result<Applied> set_variable(const StoreRequest& request, const MachineConfig& machine,
                             StoreValues& values) {
    if (!channel_exists(request, machine)) return no_channel(request);
    if (std::isinf(request.value)) return refused("variable: not a number");
    std::int32_t index = request.number;
    if (const std::string_view name = name_of(request); !name.empty()) {
        if (const auto kept = kept_variable(name))
            index = static_cast<std::int32_t>(*kept);
        else if (index < 500)
            // #100 and the like live only as long as the channel
            return Applied{};
    }
    return set_number(values,
                      {Kind::Variable, static_cast<std::int32_t>(request.channel), index, 0, {}},
                      request.value);
}

// The values of one parameter, all instances and elements.
struct RowValues {
    std::vector<double> numbers;
    std::vector<std::string> texts;
};

RowValues values_of(const params::Table& table, const params::Row& row) {
    const std::size_t count = std::size_t{params::instances(row.scope)} * row.array;
    RowValues out;
    for (std::size_t slot = row.first_slot; slot < row.first_slot + count; ++slot) {
        if (row.type == params::Type::Text)
            out.texts.emplace_back(params::text_at(table, slot));
        else
            out.numbers.push_back(table.numbers[slot]);
    }
    return out;
}

std::vector<Change> differences(const params::Row& row, const RowValues& before,
                                const RowValues& after) {
    std::vector<Change> changes;
    const auto key = [&](std::size_t i) {
        return Key{Kind::Parameter, static_cast<std::int32_t>(i / row.array + 1),
                   static_cast<std::int32_t>(i % row.array), 0, std::string(row.number)};
    };
    for (std::size_t i = 0; i < after.numbers.size(); ++i)
        if (differs(before.numbers[i], after.numbers[i]))
            changes.push_back({key(i), before.numbers[i], after.numbers[i], {}, {}, false});
    for (std::size_t i = 0; i < after.texts.size(); ++i)
        if (before.texts[i] != after.texts[i])
            changes.push_back({key(i), 0, 0, before.texts[i], after.texts[i], true});
    return changes;
}

Result<Applied> set_parameter(const StoreRequest& request, StoreValues& values) {
    const std::string_view line = name_of(request);
    if (line.empty()) return refused("parameter line is empty");
    const Result<params::Assignment> assignment = params::parse_assignment(line);
    if (!assignment) return assignment.diagnosis();
    const params::Row& row = *assignment->row;
    const RowValues before = values_of(values.parameters, row);
    if (const Result<void> done = params::apply(values.parameters, {&*assignment, 1}); !done)
        return done.diagnosis();
    Applied applied{differences(row, before, values_of(values.parameters, row)), {}};
    // An operator set what the machine counts: counting goes on from there.
    for (std::int32_t number = 0; number <= kPowerOnTime; ++number) {
        const auto slot = static_cast<std::uint32_t>(counter_slot(number));
        if (slot < row.first_slot ||
            slot >= row.first_slot + params::instances(row.scope) * row.array)
            continue;
        if (const Result<Applied> counter = set_number(values, {Kind::Counter, 0, number, 0, {}},
                                                       values.parameters.numbers[slot]);
            counter)
            applied.changes.insert(applied.changes.end(), counter->changes.begin(),
                                   counter->changes.end());
    }
    return applied;
}

Result<Applied> query(const StoreRequest& request, const StoreValues& values) {
    const Result<params::Target> target = params::parse_target(name_of(request));
    if (!target) return target.diagnosis();
    return Applied{{}, params::value_text(values.parameters, *target)};
}

// A counter is a parameter too (N2306 ...): both show it.
Result<Applied> set_counter(StoreValues& values, std::int32_t number, double value) {
    Result<Applied> applied = set_number(values, {Kind::Counter, 0, number, 0, {}}, value);
    if (const std::int64_t slot = counter_slot(number); applied && slot >= 0)
        values.parameters.numbers[static_cast<std::size_t>(slot)] = value;
    return applied;
}

Result<Applied> set_plain(const StoreRequest& request, StoreValues& values) {
    if (!std::isfinite(request.value)) return refused("not a number");
    if (static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::Counter)
        return set_counter(values, request.number, request.value);
    return set_number(values, {Kind::Position, request.number, 0, 0, {}}, request.value);
}

}  // namespace

std::int32_t offset_owner(const params::Table& table, const MachineConfig& machine,
                          std::int64_t channel, std::int64_t number) {
    const auto own = static_cast<std::int32_t>(channel);
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) || number < 1) return own;
    const ChannelKind kind = machine.channel(static_cast<std::size_t>(channel)).kind;
    const auto common = kind == ChannelKind::Mill
                            ? params::get(table, params::n1401_no_of_common_tool_offsets_m)
                            : params::get(table, params::n1412_no_of_common_tool_offsets_t);
    if (number > common) return own;
    for (std::int32_t first = 1; first < own; ++first)
        if (const ChannelConfig& other = machine.channel(static_cast<std::size_t>(first));
            other.exists() && other.kind == kind)
            return first;
    return own;
}

std::optional<Diagnosis> level_refusal(const StoreRequest& request) {
    static constexpr const char* kNames[] = {"none", "operator", "setter", "maker"};
    UserLevel least = UserLevel::None;
    std::string what;
    switch (static_cast<StoreRequestKind>(request.kind)) {
        case StoreRequestKind::Parameter:
            if (const Result<params::Assignment> assignment =
                    params::parse_assignment(name_of(request))) {
                least = static_cast<UserLevel>(
                    static_cast<std::uint32_t>(assignment->row->protection) + 1);
                what = assignment->row->number;
            }
            break;
        case StoreRequestKind::OffsetValue:
            least = static_cast<OffsetTable>(request.field / 256) == OffsetTable::Wear
                        ? UserLevel::Operator
                        : UserLevel::Setter;
            what = "offset";
            break;
        case StoreRequestKind::WorkZero:
            least = UserLevel::Setter;
            what = "zero";
            break;
        case StoreRequestKind::Variable:
            least = UserLevel::Operator;
            what = "variable";
            break;
        default:
            break;
    }
    if (static_cast<UserLevel>(request.level) >= least) return {};
    return Diagnosis{
        Alarm::LevelTooLow, {}, {}, what + " (" + kNames[static_cast<std::size_t>(least)] + ")"};
}

Result<Applied> apply_request(const StoreRequest& request, Origin origin,
                              const MachineConfig& machine, StoreValues& values) {
    switch (static_cast<StoreRequestKind>(request.kind)) {
        case StoreRequestKind::Parameter:
            return set_parameter(request, values);
        case StoreRequestKind::Query:
            return query(request, values);
        case StoreRequestKind::OffsetValue:
            return set_offset(request, origin, machine, values);
        case StoreRequestKind::WorkZero:
            return set_work_zero(request, machine, values);
        case StoreRequestKind::Variable:
            return set_variable(request, machine, values);
        case StoreRequestKind::Counter:
        case StoreRequestKind::LastPosition:
            return set_plain(request, values);
        case StoreRequestKind::Flush:
            return Applied{};
        case StoreRequestKind::ToolCall:
        case StoreRequestKind::ToolInPlace:
        case StoreRequestKind::ToolChanged:
        case StoreRequestKind::ToolLife:
        case StoreRequestKind::ToolValue:
        case StoreRequestKind::EdgeValue:
        case StoreRequestKind::LifeGroup:
        case StoreRequestKind::Operation:
        case StoreRequestKind::None:
            break;
    }
    return refused("unknown kind " + std::to_string(request.kind));
}

}  // namespace polyturn::toolmgmt
