// Threads and taps: G33 to G35, G335, G336, G331, G332, G63.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;
struct Word;

bool geo_thread(Execution& x, const GCode& code);
bool geo_barrel(Execution& x, const GCode& code);
bool geo_tap(Execution& x, const GCode& code);
bool geo_tap_chuck(Execution& x, const GCode&);
bool a_thread_ramp(Execution& x, const Word& word);

}  // namespace polyturn::channels::sinumerik
