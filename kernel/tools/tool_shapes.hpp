// Outlines of the tools in the turrets, as protection guards them
// (ipc/model/bodies/tool_shapes.hpp): read by a thread outside the cyclic one, then handed to the
// cyclic thread as plain numbers.
#pragma once
#include "ipc/model/bodies/tool_shapes.hpp"

namespace polyturn::kernel {
using polyturn::read_tool_shapes;
using polyturn::ToolShape;
using polyturn::ToolShapes;
}  // namespace polyturn::kernel
