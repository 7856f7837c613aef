#include "kernel/cyclic/tool_desk.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "ipc/image/store_news.hpp"
#include "kernel/cyclic/core.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::kernel {
namespace p = params;
namespace {
constexpr double kSendEveryS = 1.0;
constexpr double kSecondsPerMinute = 60.0, kMmPerMetre = 1000.0;

// A number that another process has written: one that is no alarm's (the store died at it, or is another version) must not be
// looked up.
Alarm known_alarm(std::int32_t number) noexcept { return number >= 0 && number < kAlarmCount ? static_cast<Alarm>(number) : Alarm::ToolsUnserved; }
}  // namespace

bool ToolDesk::managed(const Core& core) noexcept { return p::bit(core.table, p::n2900_tool_m_config, 0); }

void ToolDesk::start(KernelSegment& image, const StoreSegment& store) {
    store_ = &store;
    image.tool_tail.tail.store(store.tool_answers.head.load(std::memory_order_acquire), std::memory_order_release);   // answers to a dead kernel's questions
    const auto tools = std::make_unique<ToolTable>();
    if (!store.tools.read(*tools)) return;
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        const std::int32_t number = tools->in_channel[l];
        if (number < 1 || number > static_cast<std::int32_t>(kTools)) continue;
        const ToolRow& row = tools->rows[static_cast<std::size_t>(number - 1)];
        Working& now = desk_[l].now;
        now.tool = number;
        now.kind = static_cast<LifeKind>(row.life_kind);
        now.warning = row.warning;
        now.name = row.name;
        now.offset = row.h_cell, now.radius_offset = row.d_cell;
        if (row.life > 0 && now.kind != LifeKind::None) {
            now.left = row.life - row.counter;
            now.group_left = 0;
            for (const ToolRow& other : tools->rows)
                if (other.used && other.type_number == row.type_number && (row.type_number != 0 || &other == &row))
                    now.group_left += other.life > 0 && static_cast<LifeKind>(other.life_kind) != LifeKind::None ? other.life - other.counter : std::numeric_limits<double>::infinity();
        }
    }
}

// A successor of the store goes on in the same ring, or begins a new one. What was asked and not answered is asked again.
void ToolDesk::rebind(KernelSegment& image, const StoreSegment& store) noexcept {
    if (store.tool_answers.head.load(std::memory_order_acquire) < image.tool_tail.tail.load(std::memory_order_relaxed)) image.tool_tail.tail.store(0, std::memory_order_release);
    store_ = &store;
    for (Desk& desk : desk_)
        if (desk.call == Call::Asked) desk.call = Call::None;
}

bool ToolDesk::ask(Core& core, unsigned index, const PathRecord& r) noexcept {
    Desk& desk = desk_[index];
    if (!flush(core, index)) return false;   // who is called depends on what is used up
    const std::string_view name = r.plane[1] ? std::string_view(r.text.data(), ::strnlen(r.text.data(), r.text.size())) : std::string_view{};
    if (!core.store.ask_tool(StoreRequestKind::ToolCall, index + 1, 0, static_cast<std::int32_t>(r.plane[0]), r.value, name, core.tick, core.config.answer_ticks)) return false;
    desk.call = Call::Asked;
    desk.id = core.store.id();
    desk.asked_at = core.tick;
    return true;
}

void ToolDesk::take_answers(Core& core) noexcept {
    if (!store_) return;
    const auto& ring = store_->tool_answers;
    auto& taken = core.image.tool_tail.tail;
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
            core.alarm(known_alarm(answer.tool), 0, {answer.text.data(), ::strnlen(answer.text.data(), answer.text.size())});
            continue;
        }
        if (answer.channel < 1 || answer.channel > kMaxChannels) continue;
        Desk& desk = desk_[answer.channel - 1];
        if (answer.alarm == kToolNews) {
            if (core.virtual_time && answer.id > core.store.last_answer()) break;
            if (answer.tool != desk.now.tool || answer.tool == 0) continue;
            const bool same = desk.now.kind == static_cast<LifeKind>(answer.life_kind);
            if (!same) desk.counted = 0;
            desk.now.offset = answer.offset, desk.now.radius_offset = answer.radius_offset;
            desk.now.left = answer.left - desk.counted, desk.now.group_left = answer.group_left - desk.counted, desk.now.warning = answer.warning;
            desk.now.kind = static_cast<LifeKind>(answer.life_kind);
            desk.near = desk.near && desk.now.left < desk.now.warning, desk.over = desk.over && desk.now.left <= 0;
            look(core, answer.channel - 1);
            continue;
        }
        if (desk.call != Call::Asked || answer.id != desk.id) continue;
        // Never earlier than its tick: a fast store must not make another run of the same program.
        if (core.virtual_time && core.tick < desk.asked_at + core.config.answer_ticks) break;
        desk.answer = answer;
        if (answer.alarm >= 0) desk.answer.alarm = static_cast<std::int32_t>(known_alarm(answer.alarm));
        desk.call = answer.alarm >= 0 ? Call::Refused : Call::Answered;
    }
    taken.store(index, std::memory_order_release);
}

void ToolDesk::show(Core& core, unsigned index) noexcept {
    const ToolAnswer& answer = desk_[index].answer;
    core.signals.set_nc(signals::cn_mgzno(index + 1), answer.magazine);
    core.signals.set_nc(signals::cn_potno(index + 1), answer.pot);
    core.signals.set_nc(signals::cn_toolno(index + 1), answer.tool);
}

void ToolDesk::publish(unsigned index, ChannelStatus& out) const noexcept {
    const Desk& desk = desk_[index];
    out.tool = desk.passed.any ? desk.passed.tool : desk.now.tool;
    out.tool_offset = desk.passed.any ? desk.passed.offset : desk.now.offset;
    out.tool_radius_offset = desk.passed.any ? desk.passed.radius_offset : desk.now.radius_offset;
}

void ToolDesk::pass(const Core& core, unsigned index, bool changes) noexcept {
    Desk& desk = desk_[index];
    const bool by_t = p::bit(core.table, p::n2901_search_config, index + 1, 1);   // TLC
    if (changes) {
        if (desk.passed_next.any) desk.passed = desk.passed_next, desk.passed_next = {};
        return;
    }
    (desk.answer.spindle_place && !by_t ? desk.passed_next : desk.passed) = {true, desk.answer.tool, desk.answer.offset, desk.answer.radius_offset};
}

bool ToolDesk::differs(unsigned index) const noexcept {
    const Desk& desk = desk_[index];
    if (!desk.passed.any && !desk.passed_next.any) return false;
    return !(desk.passed.any && desk.passed.tool == desk.answer.tool) && !(desk.passed_next.any && desk.passed_next.tool == desk.answer.tool);
}

bool ToolDesk::in_place(Core& core, unsigned index) noexcept {
    Desk& desk = desk_[index];
    const bool by_t = p::bit(core.table, p::n2901_search_config, index + 1, 1);   // TLC
    const std::int32_t how = !desk.answer.spindle_place ? 1 : by_t ? 2 : 0;
    if (how != 0 && !flush(core, index)) return false;
    if (!core.store.write(StoreRequestKind::ToolInPlace, index + 1, desk.answer.tool, how, 0.0, {})) return false;
    desk.next = how == 0;
    if (how != 0) work(core, index, desk.answer);
    return true;
}

bool ToolDesk::changed(Core& core, unsigned index) noexcept {
    Desk& desk = desk_[index];
    if (!desk.next) return true;
    if (!flush(core, index)) return false;
    if (!core.store.write(StoreRequestKind::ToolChanged, index + 1, desk.answer.tool, 0, 0.0, {})) return false;
    desk.next = false;
    work(core, index, desk.answer);
    return true;
}

void ToolDesk::work(Core& core, unsigned index, const ToolAnswer& answer) noexcept {
    Desk& desk = desk_[index];
    desk.now = {};
    desk.now.tool = answer.tool;
    desk.now.offset = answer.offset, desk.now.radius_offset = answer.radius_offset;
    if (answer.tool != 0) {
        desk.now.kind = static_cast<LifeKind>(answer.life_kind);
        desk.now.left = answer.left, desk.now.group_left = answer.group_left, desk.now.warning = answer.warning;
        std::copy_n(answer.text.begin(), desk.now.name.size() - 1, desk.now.name.begin());
    }
    desk.near = desk.over = false;
    end_search(index);
    if (desk.now.kind == LifeKind::Uses) desk.now.left -= 1, desk.now.group_left -= 1;   // the store counts it itself
    look(core, index);
}

// False: more tools than a part can have.
bool ToolDesk::use_in_part(unsigned index, std::int32_t tool) noexcept {
    Desk& desk = desk_[index];
    const auto end = desk.used.begin() + static_cast<std::ptrdiff_t>(desk.used_count);
    if (std::find(desk.used.begin(), end, tool) != end) return true;
    if (desk.used_count == kPerPart) return false;
    desk.used[desk.used_count++] = tool;
    return true;
}

void ToolDesk::use(Core& core, unsigned index, LifeKind kind, double amount) noexcept {
    Desk& desk = desk_[index];
    if (desk.now.tool == 0 || desk.now.kind != kind) return;
    desk.counted += amount;
    desk.now.left -= amount, desk.now.group_left -= amount;
    look(core, index);
}

// Warning and end of life: flags, and a message each once for a tool.
void ToolDesk::look(Core& core, unsigned index) noexcept {
    Desk& desk = desk_[index];
    const bool of_group = p::bit(core.table, p::n2900_tool_m_config, 1);   // TLN
    const bool near = (of_group ? desk.now.group_left : desk.now.left) < desk.now.warning;
    const bool over = desk.now.left <= 0;
    const std::uint32_t number = index + 1;
    core.signals.set_nc(signals::cn_tlnl(number), near);
    core.signals.set_nc(signals::cn_tlend(number), over);
    const auto driven = static_cast<std::uint32_t>(p::get(core.table, p::pt_driven_spindle, number));
    const std::uint32_t spindle = driven ? driven : static_cast<std::uint32_t>(p::get(core.table, p::n0604_default_spindle, number));
    if (spindle >= 1 && spindle <= kMaxSpindles && (desk.now.tool != 0 || desk.near)) core.signals.set_nc(signals::sn_tlnl(spindle), near);
    ShortText text;
    text << "tool " << static_cast<std::int64_t>(desk.now.tool) << " " << std::string_view(desk.now.name.data());
    if (near && !over && !desk.near && desk.now.tool != 0) core.alarm(Alarm::ToolLifeNear, number, text.view());
    if (over && !desk.over && desk.now.tool != 0) {
        const int end = static_cast<int>(p::get(core.table, p::pt_life_end, number));
        if (end != 3) core.alarm(Alarm::ToolLifeOver, number, text.view());
        desk.end = end == 1 ? End::StopAfterPart : end == 2 ? End::Hold : End::Nothing;
    }
    desk.near = near, desk.over = over;
}

void ToolDesk::spend(Core& core, unsigned index, bool cuts, double seconds, double mm) noexcept {
    Desk& desk = desk_[index];
    while (desk.made_count > 0 && core.store.write(StoreRequestKind::ToolLife, index + 1, desk.made[desk.made_count - 1], static_cast<std::int32_t>(LifeKind::Pieces), 1.0, {})) --desk.made_count;
    if (desk.now.tool == 0 || !managed(core)) return;
    if (cuts && desk.told_at != core.tick) (void)use_in_part(index, desk.now.tool);   // it works on this part
    if (cuts && desk.now.kind == LifeKind::Minutes) use(core, index, LifeKind::Minutes, seconds / kSecondsPerMinute);
    if (cuts && desk.now.kind == LifeKind::Metres) use(core, index, LifeKind::Metres, mm / kMmPerMetre);
    desk.since_s += seconds;
    if (desk.counted > 0 && desk.since_s >= kSendEveryS) (void)flush(core, index);
}

bool ToolDesk::flush(Core& core, unsigned index) noexcept {
    Desk& desk = desk_[index];
    desk.since_s = 0;
    if (desk.counted <= 0 || desk.now.tool == 0) return true;
    if (!core.store.write(StoreRequestKind::ToolLife, index + 1, desk.now.tool, static_cast<std::int32_t>(desk.now.kind), desk.counted, {})) return false;
    desk.counted = 0;
    return true;
}

// Each tool that has cut since the last part has made one.
void ToolDesk::part(Core& core, unsigned index) noexcept {
    if (!managed(core)) return;
    Desk& desk = desk_[index];
    bool own = false;
    for (std::size_t i = 0; i < desk.used_count && desk.made_count < kPerPart; ++i) {
        desk.made[desk.made_count++] = desk.used[i];
        own = own || desk.used[i] == desk.now.tool;
    }
    desk.used_count = 0;
    if (!own || desk.now.kind != LifeKind::Pieces) return;
    desk.now.left -= 1, desk.now.group_left -= 1;
    look(core, index);
}

// Those are counted now: the end of the part counts what cuts from here on.
bool ToolDesk::pieces(Core& core, unsigned index, double count) noexcept {
    Desk& desk = desk_[index];
    desk.told_at = core.tick;
    for (; desk.used_count > 0; --desk.used_count) {
        const std::int32_t tool = desk.used[desk.used_count - 1];
        if (!core.store.write(StoreRequestKind::ToolLife, index + 1, tool, static_cast<std::int32_t>(LifeKind::Pieces), count, {})) return false;
        if (tool != desk.now.tool || desk.now.kind != LifeKind::Pieces) continue;
        desk.now.left -= count, desk.now.group_left -= count;
        look(core, index);
    }
    return true;
}

}  // namespace polyturn::kernel
