// The order in which a block acts whose words are read, and what it must not say.
#pragma once
namespace polyturn::channels::sinumerik {

struct Address;
struct Execution;
struct GCode;

bool takes(const GCode& code, const Address& address);
const GCode* motion_code(const Execution& x);
bool check_block(Execution& x);
bool act(Execution& x);

}  // namespace polyturn::channels::sinumerik
