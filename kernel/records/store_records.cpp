#include "kernel/records/store_records.hpp"

#include "kernel/channel/program/production.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {

void tool_data(Channel& c, const PathRecord& r) noexcept {
    const bool edge = r.plane[0] != 0;
    // of no tool: pieces of those that took part
    if (r.mask == 0) {
        if (ToolClient::managed(c.core)) (void)c.core.tools.pieces(c.core, c.index, r.value);
        return;
    }
    (void)c.core.store.ask_tool(
        edge ? StoreRequestKind::EdgeValue : StoreRequestKind::ToolValue, c.number,
        static_cast<std::int32_t>(r.mask), edge ? r.plane[0] * 100 + r.code : r.code, r.value,
        edge ? std::string_view{} : text_of(r), c.core.tick, c.core.config.answer_ticks);
}

void life_group(Channel& c, const PathRecord& r) noexcept {
    (void)c.core.store.ask_tool(StoreRequestKind::LifeGroup, c.number,
                                static_cast<std::int32_t>(r.mask), r.code + 16 * r.plane[0],
                                r.value, text_of(r), c.core.tick, c.core.config.answer_ticks);
}

void variable_or_offset(Channel& c, const PathRecord& r) noexcept {
    if (static_cast<RecordKind>(r.kind) == RecordKind::Variable &&
        part_counter(c, text_of(r), r.value))
        return;
    const StoreRequest q = request_of_record(c.number, r);
    const auto kind = static_cast<StoreRequestKind>(q.kind);
    const std::string_view name(q.name.data(), ::strnlen(q.name.data(), q.name.size()));
    // A tool's life may be its wear: then the operator is notified.
    if (kind == StoreRequestKind::OffsetValue && ToolClient::managed(c.core))
        (void)c.core.store.ask_tool(kind, q.channel, q.number, q.field, q.value, name, c.core.tick,
                                    c.core.config.answer_ticks);
    else
        (void)c.core.store.write(kind, q.channel, q.number, q.field, q.value, name);
}

bool parameter_record(Channel& c, const PathRecord& r) noexcept {
    return c.core.store.ask_parameter(text_of(r), c.core.tick, c.core.config.answer_ticks);
}

}  // namespace polyturn::kernel
