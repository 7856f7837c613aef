#include "kernel/tools/tool_client.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "ipc/image/store_changes.hpp"
#include "kernel/tick/core.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::kernel {
namespace p = params;
namespace {
constexpr double kSendEveryS = 1.0;
constexpr double kSecondsPerMinute = 60.0, kMmPerMetre = 1000.0;

// A number that another process has written: one that is no alarm's (the store died at it, or is
// another version) must not be looked up.
Alarm known_alarm(std::int32_t number) noexcept {
    return number >= 0 && number < kAlarmCount ? static_cast<Alarm>(number) : Alarm::ToolsUnserved;
}
}  // namespace

bool ToolClient::managed(const Core& core) noexcept {
    return p::bit(core.table, p::n2900_tool_m_config, 0);
}

void ToolClient::start(KernelSegment& image, const StoreSegment& store) {
    store_ = &store;
    // answers to a dead kernel's questions
    // P2: they are passed over unread
    image.tool_tail.tail.store(store.tool_answers.head.load(std::memory_order_acquire),
                               std::memory_order_release);
    const auto tools = std::make_unique<ToolTable>();
    if (!store.tools.read(*tools)) return;
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        const std::int32_t number = tools->in_channel[l];
        if (number < 1 || number > static_cast<std::int32_t>(kTools)) continue;
        const ToolRow& row = tools->rows[static_cast<std::size_t>(number - 1)];
        Working& now = context_[l].now;
        now.tool = number;
        now.kind = static_cast<LifeKind>(row.life_kind);
        now.warning = row.warning;
        now.name = row.name;
        now.offset = row.h_cell;
        now.radius_offset = row.d_cell;
        if (row.life > 0 && now.kind != LifeKind::None) {
            now.left = row.life - row.counter;
            now.group_left = 0;
            for (const ToolRow& other : tools->rows)
                if (other.used && other.type_number == row.type_number &&
                    (row.type_number != 0 || &other == &row))
                    now.group_left +=
                        other.life > 0 && static_cast<LifeKind>(other.life_kind) != LifeKind::None
                            ? other.life - other.counter
                            : std::numeric_limits<double>::infinity();
        }
    }
}

// A successor of the store goes on in the same ring, or begins a new one. What was asked and not
// answered is asked again.
void ToolClient::rebind(KernelSegment& image, const StoreSegment& store) noexcept {
    // P3: of the head the number alone counts. P4: own tail
    if (store.tool_answers.head.load(std::memory_order_acquire) <
        image.tool_tail.tail.load(std::memory_order_relaxed))
        // P2: nothing of the new ring was taken
        image.tool_tail.tail.store(0, std::memory_order_release);
    store_ = &store;
    for (Context& context : context_)
        if (context.call == Call::Asked) context.call = Call::None;
}

bool ToolClient::ask(Core& core, unsigned index, const PathRecord& r) noexcept {
    Context& context = context_[index];
    if (!flush(core, index)) return false;  // which tool is called depends on tool life
    const std::string_view name =
        r.plane[1] ? std::string_view(r.text.data(), ::strnlen(r.text.data(), r.text.size()))
                   : std::string_view{};
    if (!core.store.ask_tool(StoreRequestKind::ToolCall, index + 1, 0,
                             static_cast<std::int32_t>(r.plane[0]), r.value, name, core.tick,
                             core.config.answer_ticks))
        return false;
    context.call = Call::Asked;
    context.id = core.store.id();
    context.asked_at = core.tick;
    return true;
}

void ToolClient::take_answers(Core& core) noexcept {
    if (!store_) return;
    const auto& ring = store_->tool_answers;
    auto& taken = core.image.tool_tail.tail;
    // P1: the answers before head are complete. P4: own tail
    const auto head = ring.head.load(std::memory_order_acquire);
    auto index = taken.load(std::memory_order_relaxed);
    for (; index < head; ++index) {
        const ToolAnswer& answer = ring.slot(index);
        if (answer.alarm == kStoreWhole) {
            core.store_unfit = false;
            continue;
        }
        if (answer.alarm == kStoreMessage || answer.alarm == kStoreUnfit) {
            if (answer.alarm == kStoreUnfit) core.store_unfit = true;
            core.alarm(known_alarm(answer.tool), 0,
                       {answer.text.data(), ::strnlen(answer.text.data(), answer.text.size())});
            continue;
        }
        if (answer.channel < 1 || answer.channel > kMaxChannels) continue;
        Context& context = context_[answer.channel - 1];
        if (answer.alarm == kToolChanges) {
            if (core.virtual_time && answer.id > core.store.last_answer()) break;
            if (answer.tool != context.now.tool || answer.tool == 0) continue;
            const bool same = context.now.kind == static_cast<LifeKind>(answer.life_kind);
            if (!same) context.counted = 0;
            context.now.offset = answer.offset;
            context.now.radius_offset = answer.radius_offset;
            context.now.left = answer.left - context.counted;
            context.now.group_left = answer.group_left - context.counted;
            context.now.warning = answer.warning;
            context.now.kind = static_cast<LifeKind>(answer.life_kind);
            context.near = context.near && context.now.left < context.now.warning;
            context.over = context.over && context.now.left <= 0;
            look(core, answer.channel - 1);
            continue;
        }
        if (context.call != Call::Asked || answer.id != context.id) continue;
        // Never earlier than its tick: a fast store must not make another run of the same program.
        if (core.virtual_time && core.tick < context.asked_at + core.config.answer_ticks) break;
        context.answer = answer;
        if (answer.alarm >= 0)
            context.answer.alarm = static_cast<std::int32_t>(known_alarm(answer.alarm));
        context.call = answer.alarm >= 0 ? Call::Refused : Call::Answered;
    }
    // P2: they were read
    taken.store(index, std::memory_order_release);
}

void ToolClient::show(Core& core, unsigned index) noexcept {
    const ToolAnswer& answer = context_[index].answer;
    core.signals.set_nc(signals::cn_mgzno(index + 1), answer.magazine);
    core.signals.set_nc(signals::cn_potno(index + 1), answer.pot);
    core.signals.set_nc(signals::cn_toolno(index + 1), answer.tool);
}

void ToolClient::publish(unsigned index, ChannelStatus& out) const noexcept {
    const Context& context = context_[index];
    out.tool = context.passed.any ? context.passed.tool : context.now.tool;
    out.tool_offset = context.passed.any ? context.passed.offset : context.now.offset;
    out.tool_radius_offset =
        context.passed.any ? context.passed.radius_offset : context.now.radius_offset;
}

void ToolClient::pass(const Core& core, unsigned index, bool changes) noexcept {
    Context& context = context_[index];
    const bool by_t = p::bit(core.table, p::n2901_search_config, index + 1, 1);  // TLC
    if (changes) {
        if (context.passed_next.any) {
            context.passed = context.passed_next;
            context.passed_next = {};
        }
        return;
    }
    (context.answer.spindle_place && !by_t ? context.passed_next : context.passed) = {
        true, context.answer.tool, context.answer.offset, context.answer.radius_offset};
}

bool ToolClient::differs(unsigned index) const noexcept {
    const Context& context = context_[index];
    if (!context.passed.any && !context.passed_next.any) return false;
    return !(context.passed.any && context.passed.tool == context.answer.tool) &&
           !(context.passed_next.any && context.passed_next.tool == context.answer.tool);
}

bool ToolClient::in_place(Core& core, unsigned index) noexcept {
    Context& context = context_[index];
    const bool by_t = p::bit(core.table, p::n2901_search_config, index + 1, 1);  // TLC
    const std::int32_t how = !context.answer.spindle_place ? 1 : by_t ? 2 : 0;
    if (how != 0 && !flush(core, index)) return false;
    if (!core.store.write(StoreRequestKind::ToolInPlace, index + 1, context.answer.tool, how, 0.0,
                          {}))
        return false;
    context.next = how == 0;
    if (how != 0) work(core, index, context.answer);
    return true;
}

bool ToolClient::changed(Core& core, unsigned index) noexcept {
    Context& context = context_[index];
    if (!context.next) return true;
    if (!flush(core, index)) return false;
    if (!core.store.write(StoreRequestKind::ToolChanged, index + 1, context.answer.tool, 0, 0.0,
                          {}))
        return false;
    context.next = false;
    work(core, index, context.answer);
    return true;
}

void ToolClient::work(Core& core, unsigned index, const ToolAnswer& answer) noexcept {
    Context& context = context_[index];
    context.now = {};
    context.now.tool = answer.tool;
    context.now.offset = answer.offset;
    context.now.radius_offset = answer.radius_offset;
    if (answer.tool != 0) {
        context.now.kind = static_cast<LifeKind>(answer.life_kind);
        context.now.left = answer.left;
        context.now.group_left = answer.group_left;
        context.now.warning = answer.warning;
        std::copy_n(answer.text.begin(), context.now.name.size() - 1, context.now.name.begin());
    }
    context.near = context.over = false;
    end_search(index);
    // the store counts it itself
    if (context.now.kind == LifeKind::Uses) {
        context.now.left -= 1;
        context.now.group_left -= 1;
    }
    look(core, index);
}

// False: more tools than a part can have.
bool ToolClient::use_in_part(unsigned index, std::int32_t tool) noexcept {
    Context& context = context_[index];
    const auto end = context.used.begin() + static_cast<std::ptrdiff_t>(context.used_count);
    if (std::find(context.used.begin(), end, tool) != end) return true;
    if (context.used_count == kPerPart) return false;
    context.used[context.used_count++] = tool;
    return true;
}

void ToolClient::use(Core& core, unsigned index, LifeKind kind, double amount) noexcept {
    Context& context = context_[index];
    if (context.now.tool == 0 || context.now.kind != kind) return;
    context.counted += amount;
    context.now.left -= amount;
    context.now.group_left -= amount;
    look(core, index);
}

// Warning and end of life: flags, and a message each once for a tool.
void ToolClient::look(Core& core, unsigned index) noexcept {
    Context& context = context_[index];
    const bool of_group = p::bit(core.table, p::n2900_tool_m_config, 1);  // TLN
    const bool near = (of_group ? context.now.group_left : context.now.left) < context.now.warning;
    const bool over = context.now.left <= 0;
    const std::uint32_t number = index + 1;
    core.signals.set_nc(signals::cn_tlnl(number), near);
    core.signals.set_nc(signals::cn_tlend(number), over);
    const auto driven =
        static_cast<std::uint32_t>(p::get(core.table, p::pt_driven_spindle, number));
    const std::uint32_t spindle =
        driven ? driven
               : static_cast<std::uint32_t>(p::get(core.table, p::n0604_default_spindle, number));
    if (spindle >= 1 && spindle <= kMaxSpindles && (context.now.tool != 0 || context.near))
        core.signals.set_nc(signals::sn_tlnl(spindle), near);
    ShortText text;
    text << "tool " << static_cast<std::int64_t>(context.now.tool) << " "
         << std::string_view(context.now.name.data());
    if (near && !over && !context.near && context.now.tool != 0)
        core.alarm(Alarm::ToolLifeNear, number, text.view());
    if (over && !context.over && context.now.tool != 0) {
        const int end = static_cast<int>(p::get(core.table, p::pt_life_end, number));
        if (end != 3) core.alarm(Alarm::ToolLifeOver, number, text.view());
        context.end = end == 1 ? End::StopAfterPart : end == 2 ? End::Hold : End::Nothing;
    }
    context.near = near;
    context.over = over;
}

void ToolClient::spend(Core& core, unsigned index, bool cuts, double seconds, double mm) noexcept {
    Context& context = context_[index];
    while (context.made_count > 0 &&
           core.store.write(StoreRequestKind::ToolLife, index + 1,
                            context.made[context.made_count - 1],
                            static_cast<std::int32_t>(LifeKind::Pieces), 1.0, {}))
        --context.made_count;
    if (context.now.tool == 0 || !managed(core)) return;
    // it works on this part
    if (cuts && context.told_at != core.tick) (void)use_in_part(index, context.now.tool);
    if (cuts && context.now.kind == LifeKind::Minutes)
        use(core, index, LifeKind::Minutes, seconds / kSecondsPerMinute);
    if (cuts && context.now.kind == LifeKind::Metres)
        use(core, index, LifeKind::Metres, mm / kMmPerMetre);
    context.since_s += seconds;
    if (context.counted > 0 && context.since_s >= kSendEveryS) (void)flush(core, index);
}

bool ToolClient::flush(Core& core, unsigned index) noexcept {
    Context& context = context_[index];
    context.since_s = 0;
    if (context.counted <= 0 || context.now.tool == 0) return true;
    if (!core.store.write(StoreRequestKind::ToolLife, index + 1, context.now.tool,
                          static_cast<std::int32_t>(context.now.kind), context.counted, {}))
        return false;
    context.counted = 0;
    return true;
}

// Each tool that has cut since the last part has made one.
void ToolClient::part(Core& core, unsigned index) noexcept {
    if (!managed(core)) return;
    Context& context = context_[index];
    bool own = false;
    for (std::size_t i = 0; i < context.used_count && context.made_count < kPerPart; ++i) {
        context.made[context.made_count++] = context.used[i];
        own = own || context.used[i] == context.now.tool;
    }
    context.used_count = 0;
    if (!own || context.now.kind != LifeKind::Pieces) return;
    context.now.left -= 1;
    context.now.group_left -= 1;
    look(core, index);
}

// Those are counted now: the end of the part counts what cuts from here on.
bool ToolClient::pieces(Core& core, unsigned index, double count) noexcept {
    Context& context = context_[index];
    context.told_at = core.tick;
    for (; context.used_count > 0; --context.used_count) {
        const std::int32_t tool = context.used[context.used_count - 1];
        if (!core.store.write(StoreRequestKind::ToolLife, index + 1, tool,
                              static_cast<std::int32_t>(LifeKind::Pieces), count, {}))
            return false;
        if (tool != context.now.tool || context.now.kind != LifeKind::Pieces) continue;
        context.now.left -= count;
        context.now.group_left -= count;
        look(core, index);
    }
    return true;
}

}  // namespace polyturn::kernel
