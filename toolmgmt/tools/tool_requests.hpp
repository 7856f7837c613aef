// What the machine tells about its tools, in path order: which one is called, works now, how much
// of its life is used up, what a program writes. Each becomes changes of the values like any other;
// see Service for disk and image.
#pragma once

#include "toolmgmt/apply_request.hpp"

namespace polyturn::toolmgmt {

bool is_tool_request(const StoreRequest& request);
// Kinds ToolInPlace, ToolChanged, ToolLife, ToolValue.
Result<Applied> apply_tool_request(const StoreRequest& request, StoreValues& values);
// ToolCall: the answer with the request's id; the called tool becomes the channel's next one.
ToolAnswer answer_tool_call(const StoreRequest& request, const StoreValues& values,
                            const ToolPlaceTable& places);

// News for the kernel: the life of the tools that work, where these changes touched it; ids are 0.
std::vector<ToolAnswer> changes_of_tools_in_work(const StoreValues& values,
                                                 const ToolPlaceTable& places,
                                                 const std::vector<Change>& changes);

// One value of a tool (or "exists"), written and noted; false when it is there already.
bool set_tool_number(StoreValues& values, std::int32_t tool, std::string_view field, double value,
                     std::vector<Change>& changes);
bool set_tool_text(StoreValues& values, std::int32_t tool, std::string_view field,
                   std::string_view text, std::vector<Change>& changes);
bool set_value(StoreValues& values, const Key& key, double value, std::vector<Change>& changes);
bool set_text(StoreValues& values, const Key& key, std::string_view text,
              std::vector<Change>& changes);
// Uses up life, raises warned and worn. `amount` in the unit of the tool's life_kind; a kind that
// it does not count is nothing.
void use_up(StoreValues& values, std::int32_t tool, LifeKind kind, double amount,
            std::vector<Change>& changes);
// After wear offsets of a channel changed: tools whose life is wear look at their cell.
void look_at_wear(StoreValues& values, unsigned channel, std::int32_t cell,
                  std::vector<Change>& changes);
// The same after the wear of an edge changed: of a tool that has no cell.
void check_edge_wear(StoreValues& values, std::int32_t tool, std::vector<Change>& changes);

}  // namespace polyturn::toolmgmt
