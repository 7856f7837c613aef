// What is known of a record by its kind: when it acts, and whether it writes to the store.
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/positioning_step.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

// Motion: driven; Standing: holds the path until it is done; Instant: between two moves;
// ByContents: one of these two.
enum class When : std::uint8_t { Motion, Standing, Instant, ByContents };

struct KindRow {
    RecordKind kind;
    When when;
    bool writes_store = false;  // without stopping the path
};
inline constexpr auto kKindRows = std::to_array<KindRow>({
    {RecordKind::None, When::Standing},
    {RecordKind::Line, When::Motion},
    {RecordKind::Arc, When::Motion},
    {RecordKind::Curve, When::Motion},
    {RecordKind::Dwell, When::Standing},
    {RecordKind::Aux, When::Standing},
    {RecordKind::SpindleMode, When::ByContents},
    {RecordKind::SpindleSpeed, When::Instant},
    {RecordKind::Wait, When::Standing},  // a flying one is let pass where its partners are there
    {RecordKind::Barrier, When::Standing},
    {RecordKind::Variable, When::Instant, true},
    {RecordKind::Offset, When::Instant, true},
    {RecordKind::Message, When::Instant},
    {RecordKind::Stop, When::Standing},
    {RecordKind::Part, When::Instant},
    {RecordKind::Interrupts, When::Instant},
    {RecordKind::Marker, When::Instant},
    {RecordKind::Flag, When::ByContents},
    {RecordKind::PositioningAxis, When::ByContents},
    {RecordKind::Await, When::Standing},
    {RecordKind::Torque, When::Standing},
    {RecordKind::Home, When::Standing},
    {RecordKind::ToolData, When::Instant, true},
    {RecordKind::Parameter, When::Standing},
    {RecordKind::LifeGroup, When::Instant, true},
});
inline constexpr std::size_t kRecordKinds = static_cast<std::size_t>(RecordKind::LifeGroup) + 1;
constexpr bool kinds_in_order() noexcept {
    for (std::size_t i = 0; i < kKindRows.size(); ++i)
        if (static_cast<std::size_t>(kKindRows[i].kind) != i) return false;
    return kKindRows.size() == kRecordKinds;
}
static_assert(kinds_in_order(), "each kind of record has its row");

// Of a record that was not judged: as of one that stops the path.
constexpr const KindRow& row_of(const PathRecord& r) noexcept {
    return kKindRows[r.kind < kRecordKinds ? r.kind : 0];
}
constexpr When when_of(RecordKind kind) noexcept {
    return kKindRows[static_cast<std::size_t>(kind)].when;
}
constexpr bool is_motion(const PathRecord& r) noexcept { return row_of(r).when == When::Motion; }
constexpr bool writes_store(const PathRecord& r) noexcept { return row_of(r).writes_store; }
bool stops_path(const PathRecord& r) noexcept;
// An M01 whose key is off when the machine comes to it: no stop, no report. Switching the key while
// the machine is at the M01 has no effect any more.
constexpr bool is_optional_stop(const PathRecord& r) noexcept {
    return static_cast<RecordKind>(r.kind) == RecordKind::Stop &&
           static_cast<StopReason>(r.code) == StopReason::M01;
}
inline std::string_view text_of(const PathRecord& r) noexcept {
    return {r.text.data(), ::strnlen(r.text.data(), r.text.size())};
}

}  // namespace polyturn::kernel
