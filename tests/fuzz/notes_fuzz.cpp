// libs: polyturn_text polyturn_diagnosis fmt
//
// Any bytes in a channel's ring of notes, any head: the supervisor reads within the ring, comes to
// an end, and believes no event of another.
#include <cstring>
#include <memory>

#include "ipc/memory/note_reader.hpp"
#include "kernel/supervisor/base/event_joiner.cpp"
#include "kernel/supervisor/base/event_text.cpp"

using namespace polyturn;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto ring = std::make_unique<NoteHead>();  // its end is the end of the allocation
    if (size < 16) return 0;
    std::uint64_t place = 0, ahead = 0;
    std::memcpy(&place, data, 8);
    std::memcpy(&ahead, data + 8, 8);
    data += 16;
    size -= 16;
    if (place % 4) place = place % (3 * kNoteRing) & ~std::uint64_t{7};
    ring->head = ahead % 4 ? place + (ahead % (size + 64) & ~std::uint64_t{7}) : ahead;
    for (std::size_t i = 0; i < size; ++i)
        ring->bytes[(place + i) & (kNoteRing - 1)] = static_cast<char>(data[i]);
    std::atomic<std::uint64_t> tail{place};
    supervisor::EventJoiner joiner;
    ForeignNotes notes(*ring, tail);
    std::string text;
    std::uint64_t number = 0, taken = 0;
    while (notes.take(number, text) == ForeignNotes::Taken::One && joiner.note(1, number, text)) {
        if (++taken > kNoteRing / 16) std::abort();
        (void)joiner.begin(1, number, 1.0);
        (void)joiner.file_of(1, 3);
        if (number % 3) joiner.end(1, number, 2.0);
    }
    joiner.finish([](const supervisor::EventJoiner::Event& event) {
        if (event.text.find('\n') != std::string::npos) std::abort();
    });
    return 0;
}
