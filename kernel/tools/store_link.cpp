#include "kernel/tools/store_link.hpp"

#include "kernel/tick/event_log.hpp"

namespace polyturn::kernel {

bool StoreLink::write(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                      std::int32_t field, double value, std::string_view name) noexcept {
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

bool StoreLink::ask(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                    std::int32_t field, double value, std::string_view name, std::int64_t due,
                    bool is_value) noexcept {
    if (!write(kind, channel, number, field, value, name)) return false;
    // The store answers in order: of questions that are due together the last one's answer is the
    // answer to all. A full list (more ticks with questions than PT_ANSWER_TICKS: the store is
    // away) may thus wait longer, but loses nothing.
    if (due_count_ > 0 && (due_[due_count_ - 1].tick == due || due_count_ == due_.size())) {
        Due& last = due_[due_count_ - 1];
        last = {due, persist_.head(), last.value || is_value};
        return true;
    }
    due_[due_count_++] = {due, persist_.head(), is_value};
    return true;
}

void StoreLink::drop_due() noexcept {
    value_taken_ = value_taken_ || due_[0].value;
    last_answer_ = due_[0].request;
    for (std::size_t i = 1; i < due_count_; ++i) due_[i - 1] = due_[i];
    --due_count_;
}

bool StoreLink::take_changes(params::Table& table, std::int64_t tick, bool virtual_time) noexcept {
    // In virtual time a change acts only with the answer it belongs to; the answer was waited for
    // by the clock.
    if (virtual_time) {
        if (!answer_due(tick)) return false;
        while (due_count_ > 0 && due_[0].tick <= tick) { drop_due(); }
    } else {
        while (due_count_ > 0 && answered()) { drop_due(); }
    }
    // Whole imports only: look ahead for the end before the first value is taken.
    // P1: the changes before head are complete
    const auto head = store_->param_changes.head.load(std::memory_order_acquire);
    std::uint64_t complete = changes_.tail();
    for (std::uint64_t i = complete; i < head; ++i)
        if (store_->param_changes.slot(i).last) complete = i + 1;
    bool changed = false;
    while (changes_.tail() < complete) {
        const ParamChange* change = changes_.front();
        if (!change) break;
        if (change->slot < table.numbers.size()) {
            table.numbers[change->slot] = change->value;
            changed = true;
        }
        changes_.pop();
    }
    return changed;
}

}  // namespace polyturn::kernel
