#include "channels/records/dialogue_out.hpp"

#include <algorithm>
#include <cstring>

namespace polyturn::channels {
namespace {

void put(char* to, std::size_t size, std::string_view text) {
    std::memcpy(to, text.data(), std::min(text.size(), size - 1));
}

}  // namespace

void DialogueOut::show(const DialoguePage& page) {
    constexpr std::size_t kNote = 64, kKey = 32;
    Dialogue& out = own_->dialogue.draft();
    std::memset(static_cast<void*>(&out), 0, sizeof out);
    out.serial = ++serial_;
    put(out.title.data(), out.title.size(), page.title);
    out.field_count = static_cast<std::uint32_t>(std::min(page.fields.size(), out.fields.size()));
    for (std::size_t i = 0; i < out.field_count; ++i) {
        DialogueField& field = out.fields[i];
        put(field.name.data(), field.name.size(), page.fields[i].name);
        put(field.variable.data(), field.variable.size(), page.fields[i].variable);
        field.value = page.fields[i].value;
    }
    out.note_count =
        static_cast<std::uint32_t>(std::min(page.notes.size(), out.notes.size() / kNote));
    for (std::size_t i = 0; i < out.note_count; ++i)
        put(&out.notes[i * kNote], kNote, page.notes[i]);
    for (std::size_t i = 0; i < std::min(page.keys.size(), out.keys.size() / kKey); ++i)
        put(&out.keys[i * kKey], kKey, page.keys[i]);
    own_->dialogue.publish();
    shown_ = true;
}

void DialogueOut::entered(std::string_view variable, double value) {
    if (!shown_) return;
    Dialogue now = own_->dialogue.published();
    for (std::size_t i = 0; i < now.field_count; ++i)
        if (variable == now.fields[i].variable.data()) now.fields[i].value = value;
    own_->dialogue.write(now);
}

void DialogueOut::clear() {
    if (!shown_) return;
    Dialogue& out = own_->dialogue.draft();
    std::memset(static_cast<void*>(&out), 0, sizeof out);
    out.serial = serial_;
    own_->dialogue.publish();
    shown_ = false;
}

}  // namespace polyturn::channels
