#include "kernel/cyclic/store_link.hpp"

#include "kernel/cyclic/event_log.hpp"

namespace polyturn::kernel {

bool StoreLink::write(StoreRequestKind kind, std::uint32_t channel, std::int32_t number, std::int32_t field, double value, std::string_view name) noexcept {
    StoreRequest* request = persist_.claim();
    if (!request) return false;
    request->id = persist_.head() + 1;
    request->kind = static_cast<std::uint32_t>(kind);
    request->channel = channel;
    request->number = number;
    request->field = field;
    request->value = value;
    request->level = level_;
    request->user = user_;
    copy_text(request->name, name);
    persist_.commit();
    written_ = true;
    return true;
}

bool StoreLink::ask_parameter(std::string_view line, std::int64_t tick, std::int64_t answer_ticks) noexcept {
    if (due_count_ == due_.size()) return false;
    if (!write(StoreRequestKind::Parameter, 0, 0, 0, 0.0, line)) return false;
    due_[due_count_++] = {tick + answer_ticks, persist_.head(), false};
    return true;
}

bool StoreLink::ask_value(StoreRequestKind kind, std::uint32_t channel, std::int32_t number, std::int32_t field, double value, std::string_view name, std::int64_t tick,
                          std::int64_t answer_ticks) noexcept {
    if (due_count_ == due_.size()) return false;
    if (!write(kind, channel, number, field, value, name)) return false;
    due_[due_count_++] = {tick + answer_ticks, persist_.head(), true};
    return true;
}

bool StoreLink::ask_tool(StoreRequestKind kind, std::uint32_t channel, std::int32_t number, std::int32_t field, double value, std::string_view name, std::int64_t tick,
                         std::int64_t answer_ticks) noexcept {
    if (due_count_ == due_.size()) return false;
    if (!write(kind, channel, number, field, value, name)) return false;
    due_[due_count_++] = {tick + answer_ticks, persist_.head(), false};
    return true;
}

void StoreLink::drop_due() noexcept {
    value_taken_ = value_taken_ || due_[0].value;
    last_answer_ = due_[0].request;
    for (std::size_t i = 1; i < due_count_; ++i) due_[i - 1] = due_[i];
    --due_count_;
}

bool StoreLink::take_changes(params::Table& table, std::int64_t tick, bool virtual_time) noexcept {
    // In virtual time a change acts only with the answer it belongs to; the answer was waited for by the clock.
    if (virtual_time) {
        if (!answer_due(tick)) return false;
        while (due_count_ > 0 && due_[0].tick <= tick) {
            drop_due();
        }
    } else {
        while (due_count_ > 0 && answered()) {
            drop_due();
        }
    }
    // Whole imports only: look ahead for the end before the first value is taken.
    const auto head = store_->param_changes.head.load(std::memory_order_acquire);
    std::uint64_t complete = changes_.tail();
    for (std::uint64_t i = complete; i < head; ++i)
        if (store_->param_changes.slot(i).last) complete = i + 1;
    bool changed = false;
    while (changes_.tail() < complete) {
        const ParamChange* change = changes_.front();
        if (!change) break;
        if (change->slot < table.numbers.size()) table.numbers[change->slot] = change->value, changed = true;
        changes_.pop();
    }
    return changed;
}

}  // namespace polyturn::kernel
