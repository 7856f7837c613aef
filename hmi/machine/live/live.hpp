// The running machine as the screens see it: a copy of the image, made some times a second, and the
// names that belong to it. Read-only mappings; nothing here waits for anybody. While there is no
// controller, or a new one has come, it attaches again.
#pragma once
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/machine/live/lengths.hpp"
#include "ipc/diagnosis/languages.hpp"
#include "ipc/image/block_pictures.hpp"
#include "ipc/model/machine/angular_axes.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/memory/segment.hpp"

namespace polyturn::hmi {

// What one channel does at the block that runs now.
struct ChannelView {
    std::vector<std::string> programs;  // paths, [0] the selected or running main program
    std::uint32_t file = 0;             // of them, the one that contains the running block
    // `picture` holds for the running block; else it is the last one that was known
    bool known = false;
    bool rapid = false;  // the running record is one of rapid
    BlockPicture picture{};
    std::array<bool, kChannelAxes> moves{};  // by place: the running block moves the axis
    // and where to: machine coordinate, at right angles where the X slide is inclined
    std::array<double, kChannelAxes> end{};
    // by place: what compensation has added to the programmed point
    std::array<double, kChannelAxes> nose{};
    // By place, of the last block that was known: what the tool adds to the zeros, and what of it
    // positions show. It holds on when another program is selected: nothing has moved, and the tool
    // is in its place until that program begins.
    std::array<double, kChannelAxes> toolShift{}, toolShown{};
    // By place: what the tables of zeros have in the shift that `picture` tells, besides what
    // programs add (G52, G92, frames). The picture itself says the sum only; so it is what stood
    // there when the block's zero was chosen, and what the tables changed by when the sum did.
    std::array<double, kChannelAxes> zeroTaken{};
    std::array<double, kChannelAxes> zeroSum{};  // and the sum, when that was found
    std::int32_t zeroRow = -1;
    std::uint64_t zeroSerial = 0;
    bool zeroKnown = false, rested = true;
};

class Live {
public:
    explicit Live(std::string instance);
    ~Live();

    // A fresh copy; cheap. Attaches when it is time to try again.
    void poll();
    // Everything has been replaced: another generation, or the controller has come or gone.
    std::uint64_t generation() const { return generation_; }
    bool connected() const { return connected_; }
    // of the controller: another number at each of its starts
    std::uint64_t machineRun() const { return connected_ ? kernel_->header.generation : 0; }
    // there is no controller, in the language of the screens; empty: there is one
    std::string whyNot() const;
    const std::string& instance() const { return instance_; }
    // where its tables and its machine model lie, without the ending; empty: there are none
    std::string machineFolder() const;

    const MachineStatus& status() const { return *status_; }
    const MachineConfig& config() const { return *config_; }
    const params::Table& table() const { return *table_; }
    // in which its lengths are shown and entered
    LengthUnit unit(unsigned channel) const { return lengthUnit(*config_, channel); }
    LengthUnit unit(const AxisConfig& axis) const { return lengthUnit(*config_, axis); }
    LengthUnit commonUnit() const { return hmi::commonUnit(*config_); }
    const ChannelView& view(unsigned channel) const { return views_[channel - 1]; }
    const ChannelStatus& channel(unsigned number) const { return status_->channels[number - 1]; }
    // In which its program is written: a job may say another one than PT_LANGUAGE. Blocks that the
    // panel gives (MDI) are PT_LANGUAGE's. Of what runs; a block by hand is in that of the machine
    // (ChannelRunner::speaks). And of the selected program, whatever the mode.
    Dialect language(unsigned channel) const {
        return static_cast<ChannelMode>(this->channel(channel).mode) == ChannelMode::Mdi ||
                       this->channel(channel).by_hand
                   ? panelLanguage(channel)
                   : programLanguage(channel);
    }
    Dialect programLanguage(unsigned channel) const {
        return static_cast<Dialect>(status_->channels[channel - 1].speaks);
    }
    Dialect panelLanguage(unsigned channel) const {
        return dialect_of(params::get_text(*table_, params::pt_language, channel));
    }
    const std::vector<unsigned>& channels() const { return channels_; }  // that exist
    double seconds(std::int64_t ticks) const { return static_cast<double>(ticks) * tickSeconds_; }
    std::int32_t nc(std::uint32_t slot) const { return inputs_->signal[slot]; }
    std::int32_t plc(std::uint32_t slot) const { return outputs_->signal[slot]; }
    const PlcInputs& inputs() const { return *inputs_; }
    const PlcOutputs& outputs() const { return *outputs_; }
    // Offsets, zeros and kept variables; the version grows with each change of the store.
    std::uint64_t storeVersion() const { return storeVersion_; }
    const ChannelStore& store(unsigned channel) const { return *stores_[channel - 1]; }
    // Tools, their edges and places; the version grows with each change, of life too.
    const ToolTable& tools() const { return *tools_; }
    const ToolEdgeTable& edges() const { return *edges_; }
    const ToolPlaceTable& places() const { return *places_; }
    std::uint64_t toolsVersion() const { return toolsVersion_; }
    const StoreTotals& totals() const { return *totals_; }
    const VariableList& variables(unsigned channel) const;  // read anew at each call
    // what its program asks now; false: nothing
    bool dialogue(unsigned channel, Dialogue& out) const;
    // blocks entered by hand
    bool mdi(unsigned channel, MdiList& out) const {
        return connected_ && kernel_->mdi[channel - 1].read(out) && out.count > 0;
    }
    // bodies as protection sees them; none while it is off
    bool guard(GuardStatus& out) const { return connected_ && kernel_->guard.read(out); }
    // The scope: what it records, and the samples from `next` on (moved behind them); false: some
    // were missed.
    bool scopeChoice(ScopeChoice& out) const {
        return connected_ && kernel_->scope_choice.read(out);
    }
    bool scopeSamples(std::uint64_t& next, std::vector<ScopeSample>& out) const;
    // s after the start of the kernel, while it is stopped; negative: its log does not know any
    // more
    double stoppedSince() const;
    const std::array<std::uint64_t, 64>& tickCost() const { return tickCost_; }
    struct Process {
        std::string name;
        int pid = 0;
        ProcessState state{};
    };
    std::vector<Process> processes() const;

    // Of an axis of the channel by its place: what the workpiece system shows for a machine
    // coordinate; false: it cannot be said.
    bool workpiece(unsigned channel, unsigned place, double machine, double& out) const;
    // The coordinate at right angles for that of the drive, where the X slide is inclined
    // (fanuc_lathe 10.5); the same everywhere else.
    double upright(unsigned channel, unsigned place, double machine) const;
    // What is left of the running block in an axis; 0 where it does not move it.
    double toGo(unsigned channel, unsigned place) const;
    // Likewise, in the system that the program counts in, whatever absolute positions are to
    // contain.
    bool fromZero(unsigned channel, unsigned place, double machine, double& out) const;
    // The zero of that system, true lengths, without the tool: of the running block, or what counts
    // while nothing runs.
    bool zeroNow(unsigned channel, unsigned place, double& out) const;
    // What the tables of zeros come to with that row chosen, true lengths.
    double tableZero(unsigned channel, unsigned place, std::int32_t row) const;
    bool rests(unsigned channel) const;  // no program runs or is to go on

private:
    double zeroAtRest(unsigned channel, unsigned place) const;
    void attach();
    void detach(Diagnosis why);
    Diagnosis named(Diagnosis why) const;
    bool peersLive() const;
    void attachChannels();
    void readChannel(unsigned number);
    void readNose(unsigned number, std::uint64_t newest);
    void readTaken(unsigned number);
    void readStore();

    std::string instance_;
    std::optional<Diagnosis> why_;
    bool connected_ = false;
    std::uint64_t generation_ = 0;
    double tickSeconds_ = 0.001;
    std::chrono::steady_clock::time_point nextLook_{};
    PeerSegment<SupervisorSegment> supervisor_;
    PeerSegment<KernelSegment> kernel_;
    PeerSegment<StoreSegment> storeSegment_;
    std::array<PeerSegment<ChannelSegment>, kMaxChannels> channelSegments_;
    std::array<std::uint64_t, kMaxChannels> namesVersion_{};
    // while its program runs: when the picture of the running block was found last
    std::array<std::chrono::steady_clock::time_point, kMaxChannels> pictureTold_{};
    std::unique_ptr<MachineStatus> status_;
    std::unique_ptr<MachineConfig> config_;
    std::unique_ptr<params::Table> table_;
    std::unique_ptr<PlcInputs> inputs_;
    std::unique_ptr<PlcOutputs> outputs_;
    std::unique_ptr<ProgramNames> names_;
    std::array<std::unique_ptr<ChannelStore>, kMaxChannels> stores_;
    std::array<ChannelView, kMaxChannels> views_;
    std::array<AngularAxes, kMaxChannels> angular_{};
    struct NoseTrail {
        std::uint64_t next = 0;  // the first record that is still to be read
        std::uint32_t epoch = 0;
        std::array<double, kChannelAxes> nose{};  // before it
    };
    std::array<NoseTrail, kMaxChannels> noseTrails_{};
    std::vector<unsigned> channels_;
    void readTools();
    std::unique_ptr<ToolTable> tools_;
    std::unique_ptr<ToolEdgeTable> edges_;
    std::unique_ptr<ToolPlaceTable> places_;
    std::unique_ptr<StoreTotals> totals_;
    mutable std::unique_ptr<VariableList> variables_;
    std::uint64_t toolsSeen_ = 0, edgesSeen_ = 0, placesSeen_ = 0, toolsVersion_ = 0;
    std::array<std::uint64_t, 64> tickCost_{};
    std::uint64_t storeVersion_ = 0, tableVersion_ = 0;
};

}  // namespace polyturn::hmi
