#include "hmi/machine/live/live.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::hmi {
namespace {

using Clock = std::chrono::steady_clock;
// for processes that have come or gone
constexpr auto kLookEvery = std::chrono::milliseconds(500);
constexpr auto kPictureHolds = std::chrono::milliseconds(500);

std::string processName(std::size_t slot) {
    static constexpr const char* kNames[] = {"kernel", "plc", "toolmgmt", "hmi", "cell"};
    if (slot < std::size(kNames)) return kNames[slot];
    return "channel " + std::to_string(slot - kProcessChannel + 1);
}

}  // namespace

Live::Live(std::string instance)
    : instance_(std::move(instance)),
      status_(std::make_unique<MachineStatus>()),
      config_(std::make_unique<MachineConfig>()),
      table_(std::make_unique<params::Table>()),
      inputs_(std::make_unique<PlcInputs>()),
      outputs_(std::make_unique<PlcOutputs>()),
      names_(std::make_unique<ProgramNames>()),
      tools_(std::make_unique<ToolTable>()),
      edges_(std::make_unique<ToolEdgeTable>()),
      places_(std::make_unique<ToolPlaceTable>()),
      totals_(std::make_unique<StoreTotals>()),
      variables_(std::make_unique<VariableList>()) {
    params::set_defaults(*table_);
    for (auto& one : stores_) one = std::make_unique<ChannelStore>();
}

Live::~Live() = default;

void Live::detach(Diagnosis why) {
    if (connected_) ++generation_;
    connected_ = false;
    why_ = std::move(why);
    supervisor_ = {};
    kernel_ = {};
    storeSegment_ = {};
    for (auto& one : channelSegments_) one = {};
    channels_.clear();
    for (auto& one : views_) one = {};
}

// A person knows the controller by its name, not by that of a segment.
Diagnosis Live::named(Diagnosis why) const {
    if (why.alarm == Alarm::SegmentMissing || why.alarm == Alarm::SegmentNotReady)
        why.detail = instance_;
    return why;
}

std::string Live::whyNot() const {
    return why_ ? text_in(*why_, display_language_now()) : std::string();
}

void Live::attach() {
    auto supervisor = PeerSegment<SupervisorSegment>::attach(instance_);
    if (!supervisor) return detach(named(supervisor.diagnosis()));
    auto kernel = PeerSegment<KernelSegment>::attach(instance_);
    if (!kernel) return detach(named(kernel.diagnosis()));
    auto store = PeerSegment<StoreSegment>::attach(instance_);
    if (!store) return detach(named(store.diagnosis()));
    supervisor_ = std::move(*supervisor);
    kernel_ = std::move(*kernel);
    storeSegment_ = std::move(*store);
    if (!peersLive()) return detach({Alarm::SegmentMissing, {}, {}, instance_});
    connected_ = true;
    why_.reset();
    ++generation_;
    // P3: constant since the segment was published (the order is stronger than needed)
    tickSeconds_ = static_cast<double>(kernel_->tick_ns.load(std::memory_order_acquire)) * 1e-9;
    storeVersion_ = tableVersion_ = 0;
    toolsSeen_ = edgesSeen_ = placesSeen_ = 0;
    namesVersion_ = {};
    noseTrails_ = {};
}

std::string Live::machineFolder() const {
    return connected_ ? std::string(supervisor_->options.machine_folder.data()) : std::string();
}

// What a killed controller left behind says nothing about now.
bool Live::peersLive() const {
    return process_lives(supervisor_->header.writer_pid) &&
           process_lives(kernel_->header.writer_pid) &&
           supervisor_->header.generation == kernel_->header.generation;
}

void Live::attachChannels() {
    for (const unsigned number : channels_) {
        auto& segment = channelSegments_[number - 1];
        if (segment.attached() && process_lives(segment->header.writer_pid)) continue;
        auto found = PeerSegment<ChannelSegment>::attach(instance_, number);
        if (!found || !process_lives((*found)->header.writer_pid)) continue;
        segment = std::move(*found);
        namesVersion_[number - 1] = 0;
    }
}

void Live::readStore() {
    // P1: the tables of this version, or newer ones, are published
    const std::uint64_t version = storeSegment_->version.load(std::memory_order_acquire);
    const std::uint64_t table = storeSegment_->parameters.version();
    if (version == storeVersion_ && table == tableVersion_ && version != 0) return;
    if (table != tableVersion_ || tableVersion_ == 0) {
        if (!storeSegment_->parameters.read(*table_)) return;
        tableVersion_ = table;
        *config_ = derive_machine_config(*table_);
        channels_.clear();
        for (unsigned number = 1; number <= config_->last_channel; ++number)
            if (config_->channel(number).exists()) channels_.push_back(number);
        for (const unsigned number : channels_) {
            const auto place = [&](PlaneRole role) {
                const AxisConfig* axis = find_axis(*config_, number, role);
                return axis && axis->slot != kNoSlot ? static_cast<int>(axis->slot) : -1;
            };
            bool usable = true;
            angular_[number - 1] =
                angular_axes(*table_, number, config_->channel(number).axis_count,
                             place(PlaneRole::BasicX), place(PlaneRole::BasicZ), usable);
        }
    }
    for (const unsigned number : channels_)
        if (!storeSegment_->channels[number - 1].read(*stores_[number - 1])) return;
    storeVersion_ = version;
}

// Half a megabyte: only when it is another one.
void Live::readTools() {
    const std::uint64_t tools = storeSegment_->tools.version(),
                        edges = storeSegment_->edges.version(),
                        places = storeSegment_->places.version();
    if (tools == toolsSeen_ && edges == edgesSeen_ && places == placesSeen_) return;
    if (!storeSegment_->tools.read(*tools_) || !storeSegment_->edges.read(*edges_) ||
        !storeSegment_->places.read(*places_))
        return;
    toolsSeen_ = tools;
    edgesSeen_ = edges;
    placesSeen_ = places;
    ++toolsVersion_;
}

const VariableList& Live::variables(unsigned channel) const {
    const auto& segment = channelSegments_[channel - 1];
    if (!connected_ || !segment.attached() || !segment->variables.read(*variables_))
        variables_->count = variables_->more = 0;
    return *variables_;
}

bool Live::dialogue(unsigned channel, Dialogue& out) const {
    const ChannelStatus& now = status_->channels[channel - 1];
    const auto& segment = channelSegments_[channel - 1];
    return connected_ && segment.attached() &&
           static_cast<ChannelState>(now.state) == ChannelState::ProgramStop &&
           static_cast<StopReason>(now.stop_reason) == StopReason::Dialogue &&
           segment->dialogue.read(out) && out.serial != 0 &&
           out.title[0] + out.keys[0] + static_cast<char>(out.field_count) != 0;
}

bool Live::scopeSamples(std::uint64_t& next, std::vector<ScopeSample>& out) const {
    out.clear();
    if (!connected_) return true;
    constexpr std::uint64_t kRoom = kScopeRing - 64;  // what the kernel writes while this is read
    // P1: the samples before head are complete. P5: they count when head has not come round since
    const std::uint64_t head = kernel_->scope.head.load(std::memory_order_acquire);
    const std::uint64_t first = std::max(std::min(next, head), head > kRoom ? head - kRoom : 0);
    const bool whole = first == next;
    for (std::uint64_t i = first; i < head; ++i) out.push_back(kernel_->scope.slot(i));
    // P5: the kernel writes sample `now` into the place of now - kScopeRing
    std::atomic_thread_fence(std::memory_order_acquire);
    const std::uint64_t now = kernel_->scope.head.load(std::memory_order_relaxed);
    const bool overtaken = now >= first + kScopeRing;  // written over while it was read
    if (overtaken) out.clear();
    next = head;
    return whole && !overtaken;
}

double Live::stoppedSince() const {
    if (!connected_) return -1;
    // of the log; what the kernel writes while this is read
    constexpr std::uint64_t kRoom = 16'384 - 1'024;
    // P1: the events before head are complete; those that may be written over are left out
    const std::uint64_t head = kernel_->log.head.load(std::memory_order_acquire),
                        first = head > kRoom ? head - kRoom : 0;
    double since = -1;
    for (std::uint64_t i = head; i > first; --i) {
        const KernelEvent& event = kernel_->log.slot(i - 1);
        if (event.kind != static_cast<std::uint32_t>(KernelEventKind::MachineState)) continue;
        const auto step = static_cast<MachineStep>(event.code);
        if (step != MachineStep::EmergencyStop && step != MachineStep::Stopped) return since;
        since = seconds(event.tick);
    }
    return first == 0 ? 0 : -1;  // it has not been on yet
}

void Live::poll() {
    const auto now = Clock::now();
    if (now >= nextLook_) {
        nextLook_ = now + kLookEvery;
        if (!connected_)
            attach();
        else if (!peersLive())
            detach({Alarm::SegmentMissing, {}, {}, instance_});
        if (connected_) {
            readStore();
            attachChannels();
        }
    }
    if (!connected_) return;
    readStore();
    readTools();
    (void)storeSegment_->totals.read(*totals_);
    (void)kernel_->status.read(*status_);
    (void)kernel_->plc_inputs.read(*inputs_);
    (void)kernel_->plc_seen.read(*outputs_);
    for (std::size_t i = 0; i < tickCost_.size(); ++i)
        // P3: counters, announce nothing
        tickCost_[i] = kernel_->tick_cost[i].load(std::memory_order_relaxed);
    for (const unsigned number : channels_) readChannel(number);
}

void Live::readChannel(unsigned number) {
    ChannelView& view = views_[number - 1];
    const auto& segment = channelSegments_[number - 1];
    const ChannelStatus& status = channel(number);
    view.moves.fill(false);
    if (segment.attached())
        if (const std::uint64_t version = segment->programs.version();
            version != namesVersion_[number - 1] && segment->programs.read(*names_)) {
            namesVersion_[number - 1] = version;
            view.programs.clear();
            for (std::size_t i = 0; i < names_->count && i < 32; ++i)
                view.programs.emplace_back(&names_->name[i * 256],
                                           ::strnlen(&names_->name[i * 256], 255));
        }
    view.file = status.line && status.file < view.programs.size() ? status.file : 0;
    // The running record, or the one executed last.
    // P1: the records before head are complete
    const std::uint64_t head =
        segment.attached() ? segment->path.head.load(std::memory_order_acquire) : 0;
    const bool running = status.record < head;
    const PathRecord first =
        head ? segment->path.slot(running ? status.record : head - 1) : PathRecord{};
    // A hold or a reset has made void what was read ahead, and the channel has not yet told what
    // holds now: until then, what held before.
    // P1: after a reset the picture of what holds now is there
    if (head && (segment->epoch.load(std::memory_order_acquire) != status.epoch ||
                 (!running && first.epoch != status.epoch && !rests(number))))
        return;
    view.known = false;
    view.nose.fill(0);
    if (!head) return;
    view.rapid = (first.flags & kRapid) != 0;
    // It can be written over while it is read, and the next part begins without one: for a moment
    // the last one holds on, while the program runs.
    for (int attempt = 0; attempt < 3 && !view.known; ++attempt)
        view.known = find_picture(*segment, first.serial, view.picture);
    Clock::time_point& told = pictureTold_[number - 1];
    const bool runs = status.state == static_cast<std::uint32_t>(ChannelState::Running) ||
                      status.state == static_cast<std::uint32_t>(ChannelState::Waiting);
    if (!runs)
        told = {};
    else if (view.known)
        told = Clock::now();
    else
        view.known = told != Clock::time_point() && Clock::now() - told < kPictureHolds;
    if (view.known && (view.picture.flags & kPictureNoNose))
        readNose(number, running ? status.record : head - 1);
    // BlockPicture::tool_shown, kPictureNoNose
    for (std::size_t place = 0; view.known && place < kChannelAxes; ++place) {
        view.toolShift[place] = view.picture.tool_shift[place];
        view.toolShown[place] = view.picture.tool_shown[place] - view.nose[place];
    }
    readTaken(number);
    if (!running || status.state == static_cast<std::uint32_t>(ChannelState::Reset)) return;
    // Its block may go on in the records behind it: the last one says where the axes end.
    const ChannelConfig& config = config_->channel(number);
    for (std::uint64_t at = status.record; at < head && at < status.record + 256; ++at) {
        const PathRecord& record = segment->path.slot(at);
        if (record.serial != first.serial || record.epoch != first.epoch ||
            record.kind > static_cast<std::uint8_t>(RecordKind::Curve))
            break;
        // path coordinates are no axes; those of an inclined slide are X and Z at right angles
        if (record.transform && !angular_[number - 1].on) return;
        for (std::size_t i = 0; i < record.axis_count && i < kMaxPathAxes; ++i)
            for (std::size_t place = 0; place < config.axis_count; ++place)
                if (config.axes[place] == record.axis[i] + 1) {
                    view.moves[place] = true;
                    view.end[place] = record.end[i];
                }
    }
}

// Of each axis, what the newest record that moves it has; along the running one it grows into that
// from what was before. A reset ends compensation: what was driven before it tells nothing. Records
// that are past are read once.
void Live::readNose(unsigned number, std::uint64_t newest) {
    // the channel writes at the other end of the ring
    constexpr std::uint64_t kFar = kPathRing / 2;
    ChannelView& view = views_[number - 1];
    NoseTrail& trail = noseTrails_[number - 1];
    const ChannelStatus& now = channel(number);
    if (now.state == static_cast<std::uint32_t>(ChannelState::Reset)) {
        trail = {};
        return;
    }
    const ChannelConfig& config = config_->channel(number);
    // from a hold, with another epoch
    const bool goesOn = (view.picture.flags & (kPictureCompLeft | kPictureCompRight)) != 0;
    const auto& ring = channelSegments_[number - 1]->path;
    if (trail.next > newest || newest - trail.next > kFar)
        trail = {newest > kFar ? newest - kFar : 0, ring.slot(newest).epoch, {}};
    view.nose = trail.nose;
    for (std::uint64_t at = trail.next; at <= newest; ++at) {
        const PathRecord& record = ring.slot(at);
        if (record.epoch != trail.epoch && !goesOn) view.nose.fill(0);
        trail.epoch = record.epoch;
        // it may still be running
        if (at == newest) {
            trail.next = newest;
            trail.nose = view.nose;
        }
        if (record.kind == 0 || record.kind > static_cast<std::uint8_t>(RecordKind::Curve))
            continue;
        const double rest = at == now.record && record.length > 0
                                ? std::clamp(now.path_left / record.length, 0.0, 1.0)
                                : 0.0;
        for (std::size_t i = 0; i < record.axis_count && i < kMaxPathAxes; ++i)
            for (std::size_t place = 0; place < config.axis_count; ++place)
                if (config.axes[place] == record.axis[i] + 1)
                    view.nose[place] += (1.0 - rest) * (record.nose[i] - view.nose[place]);
    }
}

double Live::toGo(unsigned channel, unsigned place) const {
    const ChannelView& one = view(channel);
    if (!one.moves[place]) return 0;
    const auto stands = [&](unsigned at) {
        return status_->axes[config_->channel(channel).axes[at] - 1u].cmd;
    };
    const AngularAxes& axes = angular_[channel - 1];
    if (axes.on && place == axes.angular) return one.end[place] - axes.x_of(stands(place));
    if (axes.on && place == axes.square)
        return one.end[place] - axes.z_of(stands(axes.angular), stands(place));
    return one.end[place] - stands(place);
}

double Live::upright(unsigned channel, unsigned place, double machine) const {
    const AngularAxes& axes = angular_[channel - 1];
    if (axes.on && place == axes.angular) return axes.x_of(machine);
    if (axes.on && place == axes.square)
        return axes.z_of(status_->axes[config_->channel(channel).axes[axes.angular] - 1u].act,
                         machine);
    return machine;
}

bool Live::rests(unsigned channel) const {
    const auto state = static_cast<ChannelState>(status_->channels[channel - 1].state);
    return state == ChannelState::Reset || state == ChannelState::Ended;
}

// As Core::load_zeros (channels/state) adds them.
double Live::tableZero(unsigned channel, unsigned place, std::int32_t row) const {
    const auto& zeros = stores_[channel - 1]->zeros;
    const auto of = [&](std::size_t one) { return zeros[one * kChannelAxes + place]; };
    const bool chosen = row > 0 && row != static_cast<std::int32_t>(kZeroShift) &&
                        static_cast<std::size_t>(row) < kWorkZeros;
    const double sum =
        of(kZeroExternal) + of(kZeroShift) + (chosen ? of(static_cast<std::size_t>(row)) : 0.0);
    const AxisConfig& axis = config_->axis(config_->channel(channel).axes[place]);
    return axis.diameter && !axis.rotary ? sum / 2 : sum;
}

// Between the selection of a program and its first block, before the first program and after the
// last one no block says what acts: the zeros with which its language begins
// (kernel/supervisor/run/start_position.cpp). The tool is the one that the last program has left
// (ChannelView::toolShift).
double Live::zeroAtRest(unsigned channel, unsigned place) const {
    const auto row = [&](const char* name) {
        return tableZero(channel, place,
                         static_cast<std::int32_t>(work_zero_row(name).value_or(0)));
    };
    switch (language(channel)) {
        case Dialect::Fanuc:
            return row("G54");
        // N1301 CLR with N1303: the group of G54 stays as the last program has left it
        case Dialect::Nct: {
            const bool stays =
                params::bit(*table_, params::n1301_defaultg2, channel, 7) &&
                params::bit(*table_, params::nth(params::n1302_clr_g_table1, 2), channel, 6);
            return stays && view(channel).zeroRow > 0
                       ? tableZero(channel, place, view(channel).zeroRow)
                       : row("G54");
        }
        case Dialect::Sinumerik:
            return row("G500");
        case Dialect::Mefi:
            return row(params::get(*table_, params::pt_mefi_priority, channel) == 54 ? "G54"
                                                                                     : "G53");
        default:
            return 0;  // Fagor: machine zero until a program selects one
    }
}

// Programs that have ended leave nothing of their zeros to the next one, and what is entered now
// counts for it; where they do leave them (Fagor; frames of Sinumerik), it is the last block's with
// what has changed in the tables since. A turning axis has its turns in it.
bool Live::zeroNow(unsigned channel, unsigned place, double& out) const {
    const ChannelView& one = view(channel);
    const bool rest = rests(channel);
    const Dialect speaks = language(channel);
    const bool begins =
        speaks == Dialect::Fanuc || speaks == Dialect::Nct || speaks == Dialect::Mefi;
    if (one.known && (one.picture.flags & kPictureNoShift)) return false;
    if (!one.known && !rest) return false;  // a snapshot that is in transit
    if (!one.known ||
        (rest && begins && !config_->axis(config_->channel(channel).axes[place]).rotary)) {
        out = zeroAtRest(channel, place);
        return true;
    }
    out = one.picture.shift[place] - one.picture.tool_shift[place];
    if (rest) out += tableZero(channel, place, one.zeroRow) - one.zeroTaken[place];
    return true;
}

bool Live::fromZero(unsigned channel, unsigned place, double machine, double& out) const {
    double zero = 0;
    if (!zeroNow(channel, place, zero)) return false;
    out = upright(channel, place, machine) - zero - view(channel).toolShift[place];
    return true;
}

// ChannelView::zeroTaken. A table that is changed while a program runs acts later: when the sum has
// changed by as much.
void Live::readTaken(unsigned number) {
    constexpr double kSame = 1e-6;  // sums of positions differ in their last digits
    ChannelView& view = views_[number - 1];
    const bool rest = rests(number);
    view.rested |= rest;
    // a program that has begun before its first picture has come counts as begun with it
    if (!view.known || (view.picture.flags & kPictureNoShift)) return;
    const bool began = view.rested && !rest;
    view.rested = rest;
    const BlockPicture& p = view.picture;
    const bool anew = !view.zeroKnown || began || p.zero_row != view.zeroRow ||
                      (rest && p.serial != view.zeroSerial);
    view.zeroKnown = true;
    view.zeroRow = p.zero_row;
    view.zeroSerial = p.serial;
    for (unsigned place = 0; place < config_->channel(number).axis_count; ++place) {
        const double sum = p.shift[place] - p.tool_shift[place],
                     table = tableZero(number, place, p.zero_row);
        if (anew || std::abs((sum - view.zeroSum[place]) - (table - view.zeroTaken[place])) < kSame)
            view.zeroTaken[place] = table;
        view.zeroSum[place] = sum;
    }
}

bool Live::workpiece(unsigned channel, unsigned place, double machine, double& out) const {
    if (!fromZero(channel, place, machine, out)) return false;
    out += view(channel).toolShown[place];
    return true;
}

std::vector<Live::Process> Live::processes() const {
    std::vector<Process> out;
    if (!connected_) return out;
    for (std::size_t slot = 0; slot < kProcesses; ++slot) {
        const ProcessEntry& entry = supervisor_->processes[slot];
        // P1: the number of the process was stored before
        const auto state = static_cast<ProcessState>(entry.state.load(std::memory_order_acquire));
        if (state != ProcessState::Absent) out.push_back({processName(slot), entry.pid, state});
    }
    return out;
}

}  // namespace polyturn::hmi
