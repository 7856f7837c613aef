// The head of a block: skip level, block number, labels.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;

bool parse_head(Execution& x, bool& skipped);

}  // namespace polyturn::channels::sinumerik
