// What the cuts leave of the stock, as a radius over Z. The tool counts as its programmed point; a
// grooving tool, known by a width in its name ("grooving 3 mm"), also clears its width towards the
// free end.
#pragma once
#include <vector>

#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/run/run_record.hpp"

namespace polyturn::supervisor {

// A straight piece of a tool's path; arcs come as many.
struct PlaneSegment {
    unsigned channel = 0;
    Doing doing = Doing::Cut;
    PlanePoint from, to;
    double tool_width_mm = 0.0;
    std::size_t activity = 0;
};

// The ways of all channels in the workpiece system. The first move of a channel starts where the
// setup puts it.
std::vector<PlaneSegment> plane_segments(const RunRecord& record, const JobPlan& plan);

struct Contour {
    double z_low_mm = 0.0, step_mm = 0.1;
    std::vector<double> radius_mm;  // outside, from z_low upwards; 0 where nothing is left
};
Contour contour_after(const std::vector<PlaneSegment>& segments, const text::JobStock& stock);

}  // namespace polyturn::supervisor
