// Cutting edges of tools ($TC_DPx) as a channel that speaks sinumerik uses them: which ones, what
// their values are called, along which axes their lengths lie.
#pragma once
#include "hmi/machine/tools/tool_words.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"

namespace polyturn::hmi {

struct EdgeLine {
    std::int32_t tool = 0, edge = 0;
    bool operator==(const EdgeLine&) const = default;
};

bool usesEdges(const Live& live, unsigned channel);  // in place of the offset table
// else what the store has of tools reaches no program (N2900)
bool toolsManaged(const Live& live);
// Edges of the tools that the channel can call: those in its turret first, by place, then those in
// magazines, then the rest. A tool that has none has D1, which comes with its first value.
std::vector<EdgeLine> edgeLines(const Live& live, unsigned channel);
const ToolEdge* edgeOf(const Live& live, EdgeLine line);  // nullptr: it has no value yet
double edgeValue(const Live& live, EdgeLine line, int dp);
unsigned planeNow(const Live& live, unsigned channel);  // 0 G17, 1 G18, 2 G19
// Place in the channel of the axis along which a length (0 L1, 1 L2, 2 L3) of the edge acts; -1:
// along none.
int placeOfLength(const Live& live, unsigned channel, EdgeLine line, int length);
bool isLength(int dp);  // L1 to L3, their wear, their base
int lengthOf(int dp);   // which of them, from 0
double sumOfLength(const Live& live, EdgeLine line, int length);  // with wear and base, as it acts
QString edgeParameterTitle(int dp);                               // «L1», «Wear L1»
QString edgeTitle(const Live& live, EdgeLine line);               // «ROUGH_80  D1»

}  // namespace polyturn::hmi
