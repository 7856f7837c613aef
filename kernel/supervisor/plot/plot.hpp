// The picture of a run (SVG): tool paths of all channels against stock, chuck and centre line, and
// below it the timeline of the channels with their rendezvous.
//
//   plot.cpp            the sheet: title, panels, legend
//   plot_svg.hpp/.cpp   elements as text, nothing else
//   plot_part.hpp/.cpp  what the cuts have left of the stock
//   plot_paths.cpp      the upper panel            plot_timeline.cpp   the lower panel
#pragma once
#include <string>

#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/run/run_record.hpp"

namespace polyturn::supervisor {
std::string plot_text(const RunRecord& record, const JobPlan& plan);
}
