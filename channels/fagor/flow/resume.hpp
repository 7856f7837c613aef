// Resume states of fagor: see Language::resume_at. Parameters, tables and zeros are put back from
// the undo log.
#pragma once
#include <cstdint>

namespace polyturn::channels::fagor {

struct Execution;

void keep_resume_states(Execution& x, bool on);
// A block of nothing but axis words, after which only positions differ.
bool is_plain_move(const Execution& x);
// Before a block is read.
void note_resume_point(Execution& x);
// See Language.
void executed(Execution& x, std::uint64_t serial);
bool resume_at(Execution& x, std::uint64_t serial);
bool offsets_changed(Execution& x);

}  // namespace polyturn::channels::fagor
