// Brings together what a block is (the channel's note) and when it happened (the kernel's
// RecordBegin and RecordEnd), and gives the events out in their order: by t, then channel, then
// sequence (cli.md 5).
//
// An event is final when nothing can come before it any more: the log has passed its time, and it
// is complete itself. Moves and dwells are complete when they have ended, so a long cut holds back
// what happens meanwhile in other channels.
//
//   log      begin 1 (t 0)   begin 2 (t 1)   end 2 (t 3)   end 1 (t 5)
//   out                                                    1 {t 0, end 5}  2 {t 1, end 3}
//
// Pure: no image, no files.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "ipc/capacities.hpp"

namespace polyturn::supervisor {

class EventJoiner {
public:
    // A finished event as text without its end of line; `end_s` below 0: it has none.
    struct Event {
        std::string text;
        double t_s = 0.0, end_s = -1.0;
        unsigned channel = 0;
    };
    using Sink = std::function<void(const Event&)>;

    // Also holds back waits and M, S, T until they have ended, so that the sink learns how long
    // they took.
    void measure_all(bool on) { measure_all_ = on; }
    // The channel's description of a block, a JSON object without t and end. Numbers grow within a
    // channel; only a skip move is described again when it has ended, with the point where that
    // was, and is held back until then. False: it is no object on one line, or speaks for another
    // channel; nothing was taken, and whoever sends such a thing is not to be believed any more.
    [[nodiscard]] bool note(unsigned channel, std::uint64_t number, std::string_view text);
    // Notes of a channel that wait for their blocks: far more than its ring of records can hold. Of
    // more the oldest go.
    static constexpr std::size_t kMostWaiting = 8 * kPathRing;
    static constexpr std::size_t kMostBytes = 16 * kNoteRing;  // of them
    // It begins later than what stands behind it, a step of a program that an axis runs beside the
    // path, or earlier than what stands before it, a macro statement of an interrupt program that
    // acts while the block is still driven.
    void hold(unsigned channel, std::uint64_t number);
    // The block began. Returns its text with t, for stimuli that wait for it; empty when there is
    // no such note.
    std::string_view begin(unsigned channel, std::uint64_t number, double t_s);
    void end(unsigned channel, std::uint64_t number, double t_s);
    // The channel was reset or has died: what was under way has ended here. Notes stay: those of
    // the next start may be here before the log has this end, and what was discarded with its
    // records is dropped when a later one begins.
    void close_channel(unsigned channel, double t_s);
    // A successor of the channel's process counts its notes from the beginning.
    void forget_notes(unsigned channel) {
        Channel& own = channels_[channel];
        drop_waiting(own, own.waiting.end());
    }
    // An event that comes without a note (alarm, flag, stop); a JSON object without t.
    std::string_view plain(unsigned channel, double t_s, std::string text);

    // Gives out what is final, knowing that nothing before `until_s` can come any more.
    void drain(double until_s, const Sink& sink);
    // Whoever wants none of them: nothing is kept until it is final.
    void discard() { entries_.clear(); }
    // The end of the run: everything, what did not end without its `end`.
    void finish(const Sink& sink);

    // Text of the block that the channel began last, and whether there is one: alarms are placed by
    // it.
    const std::string* last_begun(unsigned channel) const;
    // The file of that block, where it is in this line: the kernel's own alarms know lines
    // only. Empty: it is another block.
    std::string file_of(unsigned channel, unsigned line) const;

private:
    struct Key {
        double t_s;
        unsigned channel;
        std::uint64_t sequence;
        bool operator<(const Key& other) const {
            if (t_s != other.t_s) return t_s < other.t_s;
            if (channel != other.channel) return channel < other.channel;
            return sequence < other.sequence;
        }
    };
    struct Entry {
        std::string text;  // ends with '}'
        std::uint64_t number = 0;
        double end_s = -1.0;
        bool complete = false;   // may be given out
        bool shows_end = false;  // a move or dwell
        bool ended = false;
    };
    struct Channel {
        std::map<std::uint64_t, std::string> waiting;  // notes whose block has not begun
        std::map<std::uint64_t, std::string> held;     // steps that begin beside the path
        std::size_t bytes = 0;                         // of `waiting`
        std::unordered_map<std::uint64_t, Key> open;   // begun, not ended
        std::string last;
        // a skip move that is not described again yet
        std::optional<Key> skip;
        std::uint64_t skip_number = 0;
    };
    void settle_skip(Channel& own);
    // those before it
    static void drop_waiting(Channel& own, std::map<std::uint64_t, std::string>::iterator end);
    std::string_view insert(unsigned channel, double t_s, std::string text, Entry entry,
                            Key* key_out);

    std::map<Key, Entry> entries_;
    std::map<unsigned, Channel> channels_;
    std::uint64_t sequence_ = 0;
    bool measure_all_ = false;
};

}  // namespace polyturn::supervisor
