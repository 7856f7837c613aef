#include "channels/check/check_mode.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "channels/check/check_port.hpp"
#include "channels/check/event_text.hpp"
#include "channels/check/round_watch.hpp"
#include "channels/forwarding_sink.hpp"
#include "channels/preset.hpp"
#include "ipc/model/machine/store/apply_setup.hpp"
#include "ipc/path/stroke_zones.hpp"

namespace polyturn::channels {
namespace {

// Prints events as they come in pieces, so that a long program needs no memory; after a wait it
// asks for the way on.
class Printer {
public:
    explicit Printer(std::FILE* out) : out_(out) {}
    std::string text;
    void flush() {
        std::fwrite(text.data(), 1, text.size(), out_);
        std::fflush(out_);
        text.clear();
    }
    void flush_large() {
        if (text.size() > 1u << 16) flush();
    }

private:
    std::FILE* out_;
};

// What is wrong is printed as an event, and for people on standard error.
int refuse(const Diagnosis& diagnosis, const EventScene& scene, Printer& printer) {
    append_event(printer.text, scene, diagnosis, BlockContext{});
    printer.text += '\n';
    printer.flush();
    std::fputs(render(diagnosis, scene.dialect, {}).c_str(), stderr);
    return 2;
}

void place_axes(Core& core, const text::ChannelSetup& setup) {
    MachineView& view = core.view();
    AxisValues machine = view.start;
    for (const auto& [name, value] : setup.machine)
        if (const int place = view.axis_by_name(name); place >= 0)
            machine[static_cast<std::size_t>(place)] =
                view.from_shown(static_cast<unsigned>(place), value);
    for (const auto& [name, value] : setup.pos)
        if (const int place = view.axis_by_name(name); place >= 0) {
            const auto i = static_cast<std::size_t>(place);
            machine[i] = view.from_shown(static_cast<unsigned>(place), value) + core.path.zero[i];
        }
    core.start_at_machine(machine);
}

// How many offsets the channels of this one's kind share; the one whose table they are in shares
// them as well.
unsigned offsets_in_common(const MachineView& view) {
    return static_cast<unsigned>(
        view.config().kind == ChannelKind::Mill
            ? params::get(view.table(), params::n1401_no_of_common_tool_offsets_m)
            : params::get(view.table(), params::n1412_no_of_common_tool_offsets_t));
}

// What the interpreters of one check have in common, mapped from a file that the caller has made.
// Offsets are common to the channels of one kind, N1401 to those that mill, N1412 to those that
// turn (nct_parameters_part1 15.1): each kind has cells of its own.
class SharedCells {
public:
    SharedCells(const std::string& path, ChannelKind kind)
        : first_(kind == ChannelKind::Mill ? kMaxOffsets : 0) {
        if (path.empty()) return;
        const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
        if (file < 0) return;
        void* const at = ::ftruncate(file, static_cast<off_t>(kBytes)) != 0
                             ? MAP_FAILED
                             : ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (at != MAP_FAILED) cells_ = static_cast<double*>(at);
        ::close(file);
    }
    ~SharedCells() {
        if (cells_) ::munmap(cells_, kBytes);
    }
    SharedCells(const SharedCells&) = delete;
    SharedCells& operator=(const SharedCells&) = delete;
    double* cells() const { return cells_; }
    // Offset n as the last one wrote it that shares it (N1401, N1412).
    void put(std::size_t n, const OffsetCell& cell) const {
        if (n >= kMaxOffsets) return;
        char* const at = place(n);
        std::memcpy(at + sizeof(double), &cell, sizeof cell);
        std::memset(at, 1, 1);
    }
    void take(ChannelStore& store, unsigned count) const {
        for (std::size_t n = 1; n <= count && n < kMaxOffsets && n < store.offsets.size(); ++n)
            if (const char* const at = place(n); *at)
                std::memcpy(static_cast<void*>(&store.offsets[n]), at + sizeof(double),
                            sizeof(OffsetCell));
    }

private:
    // written or not; the cell
    static constexpr std::size_t kMaxOffsets = 1000,
                                 kOffsetBytes = sizeof(double) + sizeof(OffsetCell);
    static constexpr std::size_t kVariableBytes = 900 * sizeof(double),
                                 kBytes = kVariableBytes + 2 * kMaxOffsets * kOffsetBytes;
    char* place(std::size_t n) const {
        return reinterpret_cast<char*>(cells_) + kVariableBytes + (first_ + n) * kOffsetBytes;
    }
    std::size_t first_;
    double* cells_ = nullptr;
};

// Remembers whether the next thing to do is to wait for the others, shows skip moves to the port
// and what is written to the round watch.
class WaitWatch final : public ForwardingSink {
public:
    WaitWatch(Sink& next, CheckPort& port, const MachineView& view, const SharedCells& shared,
              RoundWatch& rounds)
        : ForwardingSink(&next),
          port_(&port),
          view_(&view),
          shared_(&shared),
          rounds_(&rounds),
          common_(offsets_in_common(view)) {}
    bool waiting = false;
    const Core* core = nullptr;  // of the program that is read
    // a move came to the end of a stroke: nothing is driven behind it
    std::optional<Diagnosis> stroke_end;
    // of that move: under compensation an earlier block than the one that is read
    BlockContext stroke_at;
    void move(const Move& m, const BlockContext& at) override {
        if (stroke_end) return;
        if (m.kind != MoveKind::Skip) {
            next_->move(m, at);
            watch_stroke(m, at);
            return;
        }
        // The event shows the point that the signal leaves, as a run of the machine would.
        port_->skip_move(m, *view_);
        Move stopped = m;
        for (unsigned i = 0; i < view_->axis_count && !m.skip_passes; ++i) {
            const auto end = port_->axis_at_skip(view_->axes[i].machine_axis);
            if (!end) continue;
            stopped.pos[i] += *end - m.machine[i];
            stopped.machine[i] = *end;
        }
        next_->move(stopped, at);
        watch_stroke(stopped, at);
    }
    void wait(const Wait& w, const BlockContext& at) override {
        waiting = waiting || w.act == Wait::Act::Meet;
        next_->wait(w, at);
    }
    void variable(const Variable& v, const BlockContext& at) override {
        rounds_->wrote(v.name, v.value, v.text);
        next_->variable(v, at);
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        rounds_->wrote_offset(o);
        if (shared_->cells() && !o.work && o.number >= 1 &&
            static_cast<unsigned>(o.number) <= common_)
            shared_->put(static_cast<std::size_t>(o.number),
                         view_->store->offsets[static_cast<std::size_t>(o.number)]);
        next_->offset(o, at);
    }
    // The others have had their turn.
    void take_common() const {
        if (shared_->cells()) shared_->take(*view_->store, common_);
    }

private:
    // The machine stops where a move would leave its stroke (nct_parameters_part1 11.4), also where
    // nothing was checked before.
    void watch_stroke(const Move& m, const BlockContext& at) {
        if (!core || core->path.transformation.active()) return;
        StrokeZones zones;
        zones.count = view_->axis_count;
        StrokeFlags flags;
        flags.second_off = core->path.stroke2_off;
        bool any = false;
        for (unsigned i = 0; i < view_->axis_count; ++i) {
            if (!view_->axes[i].stroke.any()) continue;
            zones.axes[i] = zone_of(view_->axes[i].stroke, view_->stroke, flags);
            any = true;
        }
        if (!any) return;
        const bool arc = m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw;
        constexpr int kChords = 48;
        AxisValues from = m.machine_start;
        for (int k = 1, pieces = arc ? kChords : 1; k <= pieces && !stroke_end; ++k) {
            AxisValues to = m.machine;
            if (k < pieces) {
                const double share = static_cast<double>(k) / pieces;
                for (unsigned i = 0; i < view_->axis_count; ++i)
                    to[i] = m.machine_start[i] + share * (m.machine[i] - m.machine_start[i]);
                const double first = std::atan2(m.machine_start[m.plane_q] - m.centre_q,
                                                m.machine_start[m.plane_p] - m.centre_p) +
                                     share * m.sweep;
                to[m.plane_p] = m.centre_p + m.radius * std::cos(first);
                to[m.plane_q] = m.centre_q + m.radius * std::sin(first);
            }
            StrokeFault fault;
            if (free_part(zones, from.data(), to.data(), fault) < 1.0) {
                stroke_at = at;
                stroke_at.cycle = {};
                stroke_at.tool = {};
                stroke_end =
                    Diagnosis{Alarm::StrokeLimit,
                              {},
                              {fault.limit},
                              "A" + std::to_string(view_->axes[fault.axis].machine_axis + 1)};
            }
            from = to;
        }
    }

    CheckPort* port_;
    const MachineView* view_;
    const SharedCells* shared_;
    RoundWatch* rounds_;
    unsigned common_;
};

// Does an axis of the channel take over the travel of another one (N2101 and its fellows)?
bool may_follow(const MachineView& view) {
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const unsigned axis = view.axes[i].machine_axis + 1u;
        if (params::get(view.table(), params::n2101_synchronous_master, axis) > 0 ||
            params::get(view.table(), params::n2107_superimposed_master, axis) > 0)
            return true;
    }
    return false;
}

// "go SPINDLES": the others have had their turn; what is known of their spindles.
bool ask_to_continue(CheckPort& port) {
    char line[64];
    if (!std::fgets(line, sizeof line, stdin)) return false;
    const std::string_view text(line);
    std::uint32_t spindles = 0;
    if (text.starts_with("go "))
        std::from_chars(text.data() + 3, text.data() + text.size(), spindles);
    port.others_turn(spindles);
    return true;
}

}  // namespace

int run_check(const CheckOptions& options, std::FILE* out) {
    Printer printer(out);
    LoadedMachine machine = load_machine(options.machine);
    MachineView empty;
    EventScene scene{&empty, nullptr, Dialect::Polyturn};
    empty.channel = options.channel;
    if (!machine.ok())
        for (const Diagnosis& diagnosis : machine.diagnoses)
            if (diagnosis.severity() == Severity::Error) return refuse(diagnosis, scene, printer);
    MachineView view = make_machine_view(*machine.table, options.channel);
    scene.view = &view;
    if (!view.config().exists())
        return refuse({Alarm::ProgramNumberMissing, {options.program, 0, 0, 0}, {}, {}}, scene,
                      printer);
    const std::string language =
        options.language.empty()
            ? std::string(params::get_text(*machine.table, params::pt_language, options.channel))
            : options.language;
    scene.dialect = dialect_of(language);

    text::Setup setup;
    if (!options.setup.empty()) {
        auto loaded = text::load_setup(options.setup);
        if (!loaded) return refuse(loaded.diagnosis(), scene, printer);
        setup = std::move(*loaded);
        std::vector<Diagnosis> diagnoses;
        apply_setup(setup, view.machine, options.channel, *view.store, diagnoses);
        if (const CommonOffsets common = common_offsets(view); common.count) {
            const auto other = std::make_unique<ChannelStore>();
            clear_store(*other);
            apply_setup(setup, view.machine, common.channel, *other, diagnoses);
            take_common_offsets(*view.store, *other, common);
        }
        for (const Diagnosis& diagnosis : diagnoses)
            if (diagnosis.severity() == Severity::Error) return refuse(diagnosis, scene, printer);
    }
    const text::ChannelSetup& own = setup.channel(options.channel);

    ProgramFiles files;
    scene.files = &files;
    for (const std::string& path : own.subprograms) files.add_library(path);
    const std::string folder = std::filesystem::path(options.program).parent_path().string();
    files.add_folder(folder);
    files.add_folders(params::get_text(*machine.table, params::pt_program_folders, options.channel),
                      folder);
    const auto main = files.open(options.program);
    if (!main) return refuse(main.diagnosis(), scene, printer);

    EventSink events(scene, printer.text, options.variables, '\n');
    CheckPort port(setup, options.channel, options.alone);
    const SharedCells shared(options.shared, view.config().kind);
    port.share(shared.cells());
    port.axes_follow(may_follow(view));
    RoundWatch rounds(options.most_blocks);
    WaitWatch sink(events, port, view, shared, rounds);
    const std::unique_ptr<Language> interpreter = make_language(language, view, sink, port, files);
    if (!interpreter)
        return refuse({Alarm::NotBuilt, {options.program, 0, 0, 0}, {}, "the language " + language},
                      scene, printer);
    if (const auto started = interpreter->start(*main); !started)
        return refuse(started.diagnosis(), scene, printer);
    place_axes(interpreter->core(), own);
    sink.core = &interpreter->core();
    preset(*interpreter, own);

    if (shared.cells() && !ask_to_continue(port)) return 0;  // the programs take turns
    sink.take_common();

    for (;;) {
        const Step step = interpreter->step();
        if (sink.stroke_end) {
            sink.stroke_end->place = {files.path(sink.stroke_at.file), sink.stroke_at.line, 0, 0};
            events.alarm(*sink.stroke_end, sink.stroke_at);
            break;
        }
        printer.flush_large();
        if (step != Step::AtBarrier && step != Step::Continue) break;
        if (rounds.look(interpreter->core()) != RoundWatch::Verdict::GoesOn) {
            const BlockContext& at = interpreter->core().at;
            events.alarm({Alarm::LoopEndless, {files.path(at.file), at.line, 0, 0}, {}, {}}, at);
            break;
        }
        if (step == Step::Continue && !sink.waiting) continue;
        // it asks for a live value
        if (step == Step::AtBarrier && !sink.waiting) port.looked_at_machine();
        if (sink.waiting) {
            sink.waiting = false;
            printer.flush();
            if (!ask_to_continue(port)) break;  // no partner exists that could release it
            sink.take_common();
        }
        if (step == Step::AtBarrier) interpreter->barrier_done();
    }
    printer.flush();
    return events.errors() ? 1 : 0;
}

}  // namespace polyturn::channels
