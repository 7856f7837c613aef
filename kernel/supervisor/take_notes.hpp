// Brings the notes of all channels to the joiner. A channel's process may write what it likes into
// its ring: whoever writes what cannot be is named, and from then on its notes are left alone until
// a successor is there.
#pragma once
#include <string>

#include "ipc/memory/note_reader.hpp"
#include "kernel/supervisor/base/controller.hpp"
#include "kernel/supervisor/base/event_joiner.hpp"

namespace polyturn::supervisor {

// Of one ring: true when it can go on being read. `moved` is set when something was there.
inline bool take_ring(const NoteHead& ring, std::atomic<std::uint64_t>& tail, unsigned channel,
                      EventJoiner& joiner, std::string& text, bool& moved) {
    ForeignNotes notes(ring, tail);
    for (std::uint64_t number = 0;;) {
        const ForeignNotes::Taken taken = notes.take(number, text);
        if (taken != ForeignNotes::Taken::One) return taken == ForeignNotes::Taken::None;
        moved = true;
        if (!joiner.note(channel, number, text)) return false;
    }
}

// wrong(channel): its process is to be put out of work.
template <class Wrong>
bool take_notes(Controller& controller, EventJoiner& joiner, Wrong wrong) {
    bool moved = false;
    std::string text;
    for (unsigned number = 1; number <= kMaxChannels; ++number) {
        const ChannelSegment* channel = controller.channel(number);
        // A successor that is being started begins where its predecessor's notes were read to.
        if (!channel || controller.awaits(number)) continue;
        if (take_ring(channel->notes, controller.own().note_tail[number - 1], number, joiner, text,
                      moved))
            continue;
        if (controller.running(kProcessChannel + number - 1)) wrong(number);
    }
    return moved;
}

}  // namespace polyturn::supervisor
