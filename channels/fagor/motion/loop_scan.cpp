// G41 N, G42 N: the blocks behind the one that switches compensation on are interpreted in advance
// by a second interpreter that only records their contour; what contour_loops finds there changes
// the blocks when they really come (fagor_8037t part 1, 8.3).
//
// A block that is left out moves nothing in the plane; its functions and its other axes act.
// Positions within the program (increments, arc centres) count as if it had moved: path.programmed
// takes its end, path.machine does not.
#include "channels/fagor/interpreter.hpp"
#include "channels/fagor/motion/contour_loops.hpp"

namespace polyturn::channels::fagor {

namespace {
// of one scan; the next one begins where it ended
constexpr std::size_t kMostElements = 1000, kMostBlocks = 5000;
}  // namespace

bool Interpreter::scan_loops() {
    loops_.clear();
    scanned_to_ = 0;
    if (modal_.collision_blocks == 0 || modal_.comp == 40 || scanning_ || reads_profile_)
        return true;
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    cycles::ContourRecorder recorder(p, q);
    recorder.only_plane = true;  // a block moves its other axes, whether it is left out or not
    Interpreter reader(core_.view(), recorder, core_.port(), *files_);
    const TextPosition back = source_->next_position();
    const std::vector<cycles::Element> elements =
        reader.record_ahead(*this, recorder, p, q, scanned_to_);
    source_->seek(back);
    show_diameter();
    // The contour is read as it is programmed: G72 S makes it larger than that, and the nose
    // smaller beside it.
    const Nose nose{core_.path.tool.nose_radius / modal_.scale, modal_.comp == 41 ? 1 : -1,
                    outer_corner()};
    for (const ContourLoop& loop :
         find_loops(elements, nose, static_cast<std::size_t>(modal_.collision_blocks))) {
        const std::uint64_t before = elements[loop.before].at.serial;
        if (loop.meeting) loops_[before].end = loop.meeting;
        for (std::size_t k = loop.before + 1; k < loop.after; ++k) {
            LoopPlan& plan = loops_[elements[k].at.serial];
            plan.first = plan.first || k == loop.before + 1;
            (elements[k].at.serial == before ? plan.sharp : plan.left_out) = true;
        }
    }
    return true;
}

std::vector<cycles::Element> Interpreter::record_ahead(const Interpreter& caller,
                                                       cycles::ContourRecorder& recorder,
                                                       unsigned p, unsigned q, std::uint64_t& to) {
    scanning_ = true;
    values_.take_values(caller.values_);
    modal_ = caller.modal_;
    modal_.comp = 40;
    core_.compensation_reset();
    core_.path = caller.core_.path;
    core_.path.zones = {};
    core_.path.second_limits = {};
    core_.set_frame(Frame{});
    // behind compensation: nothing of the contour that is compensated
    core_.path.factored = false;
    core_.path.factor.fill(1.0);
    core_.start_at_machine(core_.path.machine);
    core_.path.programmed = caller.core_.path.programmed;
    recorder.from({core_.path.programmed[p], core_.path.programmed[q]});
    frames_ = caller.frames_;
    source_ = caller.source_;
    serial_ = caller.serial_;
    for (std::size_t blocks = 0;
         blocks < kMostBlocks && recorder.contour.elements.size() < kMostElements; ++blocks) {
        const Step done = step();
        if (scan_over_ || done != Step::Continue || recorder.error || recorder.foreign) break;
        to = serial_;
    }
    return recorder.contour.elements;
}

// The plan of this block, applied to its target. True: its way in the plane is left out.
bool Interpreter::leave_out(AxisValues& target) {
    const auto plan = loops_.find(core_.at.serial);
    if (plan == loops_.end()) return false;
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    if (!plan->second.left_out && plan->second.end) {
        target[p] = plan->second.end->z;
        target[q] = plan->second.end->x;
    }
    if (plan->second.first)
        core_.sink().alarm(
            {Alarm::FagorProfileHollow, {files_->path(core_.at.file), core_.at.line, 0, 0}, {}, {}},
            core_.at);
    return plan->second.left_out;
}

// The chamfer or rounding at the end of this block is too small for the nose, the block itself is
// not.
bool Interpreter::ends_sharp() const {
    const auto plan = loops_.find(core_.at.serial);
    return plan != loops_.end() && plan->second.sharp;
}

// Only what lies outside of the plane is driven; the program is where the block would have led.
bool Interpreter::drive_left_out(const AxisValues& target, bool rapid) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    AxisValues stays = target;
    const AxisValues here = core_.programmed_now();
    stays[p] = here[p];
    stays[q] = here[q];
    bool moves = false;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        moves = moves || (i != p && i != q && std::fabs(stays[i] - here[i]) > 1e-7);
    if (moves && !straight(stays, rapid)) return false;
    core_.path.programmed = target;
    return true;
}

}  // namespace polyturn::channels::fagor
