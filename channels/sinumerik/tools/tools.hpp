// T, D, M6, TOFF: which tool and edge hold.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct Word;

bool tool_words(Execution& x);
bool changes_tool(const Execution& x);
bool change_tool(Execution& x);
bool f_lentoax(Execution& x, Call& c);
void apply_tool(Execution& x);
bool a_tool_length_offset(Execution& x, const Word& word);
bool a_tool_axis_offset(Execution& x, const Word& word);
bool a_sum_offset(Execution& x, const Word& word);
bool a_tool_radius_offset(Execution& x, const Word& word);

}  // namespace polyturn::channels::sinumerik
