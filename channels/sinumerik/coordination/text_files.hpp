// READ, WRITE, DELETE and what is asked about text files.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_file_facts(Execution& x, Call& c);
bool p_write(Execution& x, Call& c);
bool p_read(Execution& x, Call& c);
bool p_delete(Execution& x, Call& c);
bool p_file_size(Execution& x, Call& c);
bool f_isfile(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
