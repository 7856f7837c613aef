// The tool in work of a channel's turret or spindle: what tool management has put to work,
// else what the PLC reports (active_tool), else what the last executed block has called. A program
// that is read ahead puts no tool to work.
#pragma once
#include <QString>

#include "hmi/machine/live/live.hpp"

namespace polyturn::hmi {

struct ToolAtWork {
    std::int64_t number = 0;  // as T calls it; 0: not known
    QString name;             // empty: it has none
    // another one that the running block calls: the turret is turning, or a change is to come;
    // 0: none
    std::int64_t called = 0;
    bool certain = false;  // reported by the machine, not by a program
};
ToolAtWork toolAtWork(const Live& live, unsigned channel);
// «T1  ROUGH_80», «T1 → T3»; empty: not known
QString toolAtWorkText(const ToolAtWork& tool, bool named);

}  // namespace polyturn::hmi
