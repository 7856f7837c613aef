// The two panels of the picture; each draws into its frame and says how high it is.
#pragma once
#include <memory>

#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/plot/plot_svg.hpp"
#include "kernel/supervisor/run/run_record.hpp"

namespace polyturn::supervisor {

struct Frame {
    double x = 0.0, y = 0.0, width = 0.0;
};

class PathPanel {
public:
    PathPanel(const RunRecord& record, const JobPlan& plan, double width);
    ~PathPanel();
    double height() const;
    void draw(Svg& svg, const Frame& frame) const;
    bool empty() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

class TimelinePanel {
public:
    TimelinePanel(const RunRecord& record, const JobPlan& plan);
    double height() const;
    void draw(Svg& svg, const Frame& frame) const;

private:
    const RunRecord& record_;
    const JobPlan& plan_;
};

// A step of 1, 2 or 5 times a power of ten, so that about `wanted` of them fit into `range`.
double round_step(double range, double wanted);

}  // namespace polyturn::supervisor
