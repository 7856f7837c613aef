// What a program leaves to the next one in its channel (fagor_8037t part 1, 4.4.2, 9.1; part 2,
// 11.2, 13): parameters but the local ones, tables, programs that were written, the active zero
// offset, work zones, the tool in work, the inclined axis. Everything else begins as the machine
// parameters say.
#pragma once
#include <any>

namespace polyturn::channels::fagor {

struct Execution;

std::any carry(const Execution& x);
void take_carry(Execution& x, const std::any& before);

}  // namespace polyturn::channels::fagor
