// The channel process in run mode: acts on the kernel's events, interprets, pushes records.
//
//            CycleStart               AtBarrier                  BarrierReached
//   Idle ----------------> Reading ------------> Standing ------------------------> Reading ...
//     ^                       |                     |
//     '-- Reset, end, alarm --'---------------------'
//
// While its path is held, a program can be taken back to the block in which it is held, to go on
// with other offsets; a block can be executed by hand meanwhile (held_program.cpp).
//
// Invariants
//   I1  `quiet` becomes n only when event n and all before it have been acted on, everything that
//   follows from them is in the
//       ring, and nothing more comes without another event: Idle or Standing.
//   I2  What a program reads of the outside belongs to its cycle start or to the barrier at which
//   it stands (architecture 5.5). I3  The heartbeat grows at least every 50 ms while the process
//   lives, whatever it waits for.
#pragma once
#include <any>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "channels/hold/operator_changes.hpp"
#include "channels/hold/restart_sink.hpp"
#include "channels/hold/resume_sink.hpp"
#include "channels/language.hpp"
#include "channels/process/coupled_limits.hpp"
#include "channels/process/run_port.hpp"
#include "channels/records/dialogue_out.hpp"
#include "channels/records/picture_out.hpp"
#include "channels/records/record_sink.hpp"
#include "ipc/memory/segment.hpp"

namespace polyturn::channels {

struct ProgramChoice {
    std::string path;         // selected file
    std::string mdi;          // a text instead of a file
    std::string beside = {};  // of mdi: the selected file; files in its folder can be called
    // of the file, as a job says it; Polyturn: the machine says it
    Dialect language = Dialect::Polyturn;
};

// Interprets one program, seen from here. Made anew for each cycle start.
class ProgramRun {
public:
    virtual ~ProgramRun() = default;
    virtual Result<void> start() = 0;
    virtual Step step() = 0;
    virtual void barrier_done() = 0;
    // see Language
    virtual bool interrupt(std::uint64_t /*serial*/, bool /*within*/, unsigned /*input*/) {
        return false;
    }
    virtual bool interrupt_ahead(std::uint64_t /*serial*/) { return false; }
    virtual void interrupt_arrived() {}
    virtual void executed(std::uint64_t /*serial*/) {}
    virtual void keep_resume_states(bool) {}
    virtual bool may_resume_at(std::uint64_t /*serial*/) const { return false; }
    virtual bool resume_at(std::uint64_t /*serial*/) { return false; }
    virtual bool offsets_changed() { return true; }
    virtual bool starts_away() const { return false; }
    virtual bool loses_offset(bool /*by_reset*/) const { return false; }  // see Language
    virtual void start_away(const AxisValues& /*by*/) {}
    // the block that was interpreted last
    virtual BlockContext at() const { return {}; }
    virtual const Core* core() const { return nullptr; }  // what holds behind that block
    virtual void active_codes(std::string& /*out*/) const {}
    virtual void list_variables(
        const std::function<void(std::string_view, double)>& /*show*/) const {}
    // it is the one whose blocks are described from now on
    virtual void shown() {}
    virtual std::any carry() const { return {}; }
    virtual void take_carry(const std::any& /*before*/, bool /*after_reset*/) {}
    virtual std::size_t file_count() const = 0;
    virtual std::string file_name(std::size_t index) const = 0;
};

struct ProcessServices {
    std::function<std::unique_ptr<ProgramRun>(MachineView&, Sink&, Port&, const ProgramChoice&)>
        make_run;
    // A sink that appends event objects to `text`, for the notes; may be empty.
    std::function<std::unique_ptr<Sink>(const MachineView&, std::string& text)> make_describer;
    const text::Setup* setup = nullptr;
    std::string kept_folder;  // of texts that survive power-off; empty: none do
};

class ChannelProcess {
public:
    // Attaches to supervisor, store and kernel, makes the channel's own segment.
    static Result<std::unique_ptr<ChannelProcess>> create(const std::string& instance,
                                                          unsigned channel,
                                                          ProcessServices services);
    // Until Quit.
    void run();
    // One event, or a piece of interpretation; false after Quit. For tests that act as the kernel
    // in the same thread.
    bool turn(bool sleep);

private:
    enum class State : std::uint8_t { Idle, Reading, Standing };

    ChannelProcess(PeerSegment<SupervisorSegment> supervisor, PeerSegment<StoreSegment> store,
                   PeerSegment<KernelSegment> kernel, OwnSegment<ChannelSegment> own,
                   unsigned channel, ProcessServices services);
    void act(const ChannelEvent& event);
    void begin_program();
    void take_limits();
    void go_on();
    void read_program();
    void end_program(StopReason reason);
    void reset(const ChannelEvent& event);
    void forget_read_ahead(std::uint64_t serial);
    void interrupt(const ChannelEvent& event);
    void interrupt_ahead(const ChannelEvent& event);
    // held_program.cpp: what happens to a program while its path is held
    void restart(const ChannelEvent& event);
    void ask_resume(const ChannelEvent& event);
    void resume(const ChannelEvent& event);
    void held_mdi(const ChannelEvent& event);
    void void_pushed(const ChannelEvent& event);
    void look_for_changes();
    void take_changes();
    AxisValues axes_now();
    void forget_executed();
    void take_shared();
    void say_quiet();
    bool take_store();
    void fail(const Diagnosis& diagnosis);
    void publish_names();
    void publish_choice();
    void show_block();
    void put_note(std::uint64_t number, std::string_view text);

    PeerSegment<SupervisorSegment> supervisor_;
    PeerSegment<StoreSegment> store_;
    PeerSegment<KernelSegment> kernel_;
    OwnSegment<ChannelSegment> own_;
    unsigned channel_;
    ProcessServices services_;
    EventInbox inbox_;
    std::unique_ptr<RingOut> ring_;
    NoteWriter notes_;
    RunPort port_;
    PathLimits limits_;
    Couplings couplings_;  // those that limits_ were made for
    std::unique_ptr<TransformedOut> transformed_;
    std::unique_ptr<PathMaker> maker_;
    std::unique_ptr<MachineView> view_;
    std::string note_text_;
    std::unique_ptr<Sink> describer_;
    std::unique_ptr<RecordSink> sink_;
    std::unique_ptr<ResumeSink> resume_sink_;    // in front of sink_
    std::unique_ptr<RestartSink> restart_sink_;  // in front of both: what the program speaks to
    OperatorChanges changes_;
    PictureOut pictures_;
    DialogueOut dialogue_;
    std::string codes_;
    void show_variables(bool now);
    std::chrono::steady_clock::time_point variables_due_{};
    std::unique_ptr<ChannelStore> looked_at_;
    bool operator_changed_ = false;  // offsets or zeros; they act as soon as they can
    // block; the next program is only interpreted until there
    std::optional<std::int64_t> restart_to_;
    std::uint32_t restart_set_ = 0;
    // held_run_: the program, while a block that was entered in its hold runs
    std::unique_ptr<ProgramRun> run_, held_run_;
    // where the axes were when the program was left for that
    AxisValues left_at_{};
    ProgramChoice choice_, running_;
    State state_ = State::Idle;
    std::uint64_t seen_event_ = 0;
    std::uint64_t last_note_ = 0;
    double parts_left_ = 1;
    // in an interrupt program, while the path has not reached it
    bool ahead_ = false;
    bool next_part_ = false;  // stopped between two parts
    bool store_changed_ = false;
    std::unique_ptr<ChannelStore> first_store_;
    std::any carried_;  // of the program before
    bool after_reset_ = false;
    bool quit_ = false;
    std::size_t names_published_ = 0;
};

}  // namespace polyturn::channels
