// How fast: F and its types, the axes that F counts, limits and shares of single axes.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct GCode;
struct Word;

bool p_fgroup(Execution& x, Call& c);
bool a_feed_radius(Execution& x, const Word& word);
bool a_feed_limit(Execution& x, const Word& word);
bool a_override(Execution& x, const Word& word);
bool g_feed_type(Execution& x, const GCode& code);
bool feed_word(Execution& x, const Word& word);
bool a_feed(Execution& x, const Word& word);
bool a_feed_tooth(Execution& x, const Word& word);
// Core's feed from F, FZ, FB and group 15
bool update_feed(Execution& x);
bool motion_changes(Execution& x, const GCode& to);
bool a_handwheel_feed(Execution& x, const Word& word);
bool a_axis_share(Execution& x, const Word& word);

}  // namespace polyturn::channels::sinumerik
