// MEAFRAME: the frame between wanted and measured points.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool f_meaframe(Execution& x, Call& call);

}  // namespace polyturn::channels::sinumerik
