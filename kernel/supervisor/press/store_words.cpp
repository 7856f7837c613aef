#include "kernel/supervisor/press/store_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "ipc/image/commands.hpp"
#include "ipc/requests/store_requests.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/params/param_file.hpp"
#include "kernel/supervisor/press/press_targets.hpp"
#include "kernel/supervisor/press/press_words.hpp"

namespace polyturn::supervisor {

namespace {

constexpr std::string_view kTables[] = {"geometry", "wear", "second"};  // order of OffsetTable
constexpr std::string_view kFields = "XYZRT";                           // order of OffsetField
// mm or degrees: longer than any lathe
constexpr double kLargest = 100'000;
constexpr std::string_view kShape = "offset L1 3 wear X=0.05 or zero L1 G54 Z=-150";

Diagnosis wrong(std::string detail) {
    return Diagnosis{Alarm::PressArgument, {}, {}, std::move(detail)};
}

std::string_view text_of(const Command& c) {
    return {c.text.data(), ::strnlen(c.text.data(), c.text.size())};
}

}  // namespace

Result<Command> parse_store_value(std::string_view name, std::string_view value,
                                  const MachineConfig& machine) {
    const auto parts = words_of(name);
    const auto number = number_of(value);
    if (number && std::abs(*number) > kLargest)
        return wrong(fmt::format("{}={}: out of range (at most {:g})", name, value, kLargest));
    if (parts.size() < 4 || !number)
        return wrong(fmt::format("'{}={}' is not of the form: {}", name, value, kShape));
    Command command{};
    command.kind = static_cast<std::uint32_t>(CommandKind::StoreValue);
    command.value = *number;
    const auto channel = parts[1][0] == 'L' ? number_of(parts[1].substr(1)) : std::nullopt;
    if (!channel || *channel < 1 || *channel > static_cast<double>(kMaxChannels) ||
        *channel != std::floor(*channel) ||
        !machine.channel(static_cast<std::size_t>(*channel)).exists())
        return wrong(fmt::format("the machine has no channel {}", parts[1]));
    command.channel = static_cast<std::uint32_t>(*channel);
    if (parts[0] == "zero" && parts.size() == 4) {
        if (!work_zero_row(parts[2]))
            return wrong(fmt::format("there is no zero offset {}", parts[2]));
        if (!find_axis(machine, command.channel, parts[3]))
            return wrong(fmt::format("channel {} has no axis {}", parts[1], parts[3]));
        command.object = static_cast<std::uint32_t>(StoreRequestKind::WorkZero);
        if (!put_text(command, fmt::format("{} {}", parts[2], parts[3])))
            return wrong(std::string(parts[2]));
        return command;
    }
    const auto offset = number_of(parts[2]);
    const auto table = std::find(std::begin(kTables), std::end(kTables), parts[3]);
    const auto field = parts.size() == 5 && parts[4].size() == 1 ? kFields.find(parts[4][0])
                                                                 : std::string_view::npos;
    if (parts[0] != "offset" || !offset || table == std::end(kTables) ||
        field == std::string_view::npos)
        return wrong(fmt::format("'{}={}' is not of the form: {}", name, value, kShape));
    const int most = machine.channel(command.channel).offset_count;
    if (*offset < 1 || *offset > most || *offset != std::floor(*offset))
        return wrong(fmt::format("channel {} has the offsets 1 to {} (N1400)", parts[1], most));
    if (field == 4 && (*number < 0 || *number > 9 || *number != std::floor(*number)))
        return wrong("tip directions are 0 to 9");
    command.object = static_cast<std::uint32_t>(StoreRequestKind::OffsetValue);
    command.flags =
        static_cast<std::uint32_t>(*offset) << 16 |
        static_cast<std::uint32_t>((table - std::begin(kTables)) * 256 + static_cast<long>(field));
    return command;
}

StoreRequest store_request_of(const Command& c) {
    StoreRequest request = store_request(static_cast<StoreRequestKind>(c.object), c.channel,
                                         static_cast<std::int32_t>(c.flags >> 16),
                                         static_cast<std::int32_t>(c.flags & 0xFFFFu), c.value);
    put_name(request, text_of(c));
    return request;
}

}  // namespace polyturn::supervisor
