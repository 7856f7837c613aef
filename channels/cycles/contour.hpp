// The contour between the blocks P and Q of a stock removal cycle, as the language has interpreted
// it without output.
//
//     A (where the cycle is called)
//     |  first block: approach, G0 or G1
//     v
//     A'---- element ----.                     lines and arcs in the order of the program;
//                         '--- element ----B   each knows its block, so that an alarm can name it
#pragma once
#include <optional>
#include <vector>

#include "channels/sink.hpp"
#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::cycles {

struct Point {
    double z = 0.0, x = 0.0;  // workpiece system, true mm, X as a radius
};

struct Element {
    enum class Form : std::uint8_t { Line, ArcCw, ArcCcw } form = Form::Line;
    Point from, to;
    Point centre;  // arcs
    double radius = 0.0;
    double first_angle = 0.0, sweep = 0.0;  // rad in the plane Z X; sweep positive from Z to X
    bool rapid = false;
    BlockContext at;
};

struct Contour {
    Point start, first;  // A and A'
    bool approach_rapid = true;
    bool first_names_z = false, first_names_x = false;
    BlockContext first_block;
    std::vector<Element> elements;
    Point end() const { return elements.empty() ? first : elements.back().to; }
};

// Replaces the sink while the blocks are interpreted: keeps moves, swallows everything
// else.
class ContourRecorder final : public Sink {
public:
    ContourRecorder(unsigned z_place, unsigned x_place) : z_(z_place), x_(x_place) {}

    Contour contour;
    std::optional<Diagnosis> error;  // reported by the block that failed
    // a block that is no part of a contour: a thread, a move outside the plane, a wait
    std::optional<BlockContext> foreign;
    bool only_plane = false;  // axes outside the plane do not count

    void from(Point point) { here_ = point; }
    void move(const Move& move, const BlockContext& at) override;
    void alarm(const Diagnosis& diagnosis, const BlockContext& at) override;
    void wait(const Wait&, const BlockContext& at) override { foreign = at; }
    // an end of the program is noticed by the reader itself
    void stop(const Stop& stop, const BlockContext& at) override {
        if (stop.asked && (stop.reason == StopReason::M00 || stop.reason == StopReason::M01))
            foreign = at;
    }
    void barrier(const BlockContext& at) override { foreign = at; }
    void offset(const OffsetWrite&, const BlockContext& at) override { foreign = at; }
    void dwell(const Dwell&, const BlockContext&) override {}
    void aux(const Aux&, const BlockContext&) override {}
    void spindle(const Spindle&, const BlockContext&) override {}
    void variable(const Variable&, const BlockContext&) override {}
    void message(std::string_view, const BlockContext&) override {}
    void part(double, const BlockContext&) override {}
    void block_end(const BlockContext&) override {}

private:
    unsigned z_, x_;
    Point here_;
};

}  // namespace polyturn::channels::cycles
