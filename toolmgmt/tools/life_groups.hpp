// Tool life groups that a program registers (G10 L3 ... G11): which tools of the turret are used
// one after the other, and for how long each. They are rows of the tool table like any other; the
// group is a column of the row.
//
// A tool of a group is the one at its station. Where the station is empty it is entered, standing
// there; its place in the group is its duplo number, so that T calls (ToolCallBy::Group) take them
// in the order of the program.
#pragma once

#include "toolmgmt/apply_request.hpp"

namespace polyturn::toolmgmt {

// Kind LifeGroup. What was used up of a tool that is registered again is forgotten: its life begins
// anew.
Result<Applied> apply_life_group(const StoreRequest& request, StoreValues& values);

}  // namespace polyturn::toolmgmt
