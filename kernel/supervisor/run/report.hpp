// Where the time of a run went, for people: each channel's times, what two turrets at once have
// saved, who waited where and for whom, and which cut to move.
#pragma once
#include <string>

#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/run/run_record.hpp"

namespace polyturn::supervisor {
std::string report_text(const RunRecord& record, const JobPlan& plan);
}
