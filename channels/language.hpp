// What every NC language is to the rest of the channel: something that goes on block by block. A
// language translates into calls of Core, cycles and calls of subprograms; it owns no rule of
// motion.
#pragma once
#include <any>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "channels/program_files.hpp"
#include "channels/state/core.hpp"
#include "ipc/diagnosis/languages.hpp"

namespace polyturn::channels {

enum class Step : std::uint8_t {
    Continue,   // a block has been interpreted (or a part of a cycle)
    AtBarrier,  // everything delivered so far must be executed; then call barrier_done() and go on
    Ended,      // M30, M02, end of the text, or M99 in the main program
    Failed,     // an alarm was delivered
};

class Language {
public:
    virtual ~Language() = default;
    // From the beginning of the file; modal state as after cycle start.
    virtual Result<void> start(FileId main) = 0;
    virtual Step step() = 0;
    virtual void barrier_done() = 0;
    // A value that setup or operator give to a variable by its name in this language; false: no
    // such variable.
    virtual bool preset_variable(std::string_view name, double value) = 0;
    virtual bool preset_text(std::string_view, std::string_view) { return false; }
    // A tool and one of its edges, as languages with such tables keep them: parameter DPn has the
    // value. False: no such table.
    virtual bool preset_tool(int, std::string_view) { return false; }
    virtual bool preset_edge(int, int, std::string_view, double) { return false; }
    // The tools of the store that this channel sees (PT_TOOL_UNIT), before the setup's; languages
    // without a tool table of their own need none.
    virtual void preset_stored(const ToolTable&, const ToolEdgeTable&, int /*unit*/) {}
    virtual Core& core() = 0;

    // The codes that hold behind the block read last, with blanks between them: for screens.
    virtual void active_codes(std::string& /*out*/) const {}
    // Every variable of the program that is not empty, by its name in this language: for screens.
    using ShowVariable = std::function<void(std::string_view name, double value)>;
    virtual void list_variables(const ShowVariable& /*show*/) const {}

    // Resume states (architecture 5.6): kept for blocks whose records are not all executed, when
    // switched on. BlockContext::serial counts the blocks of a run; records carry it back.
    virtual void keep_resume_states(bool on) = 0;
    // all blocks before it are executed for good
    virtual void executed(std::uint64_t serial) = 0;
    // Interpretation goes on with this block as if neither it nor anything behind it had been read:
    // modal state, calls, variables, offsets and zeros are those that held before it. False: no
    // state is kept for it.
    virtual bool resume_at(std::uint64_t serial) = 0;
    // would it be true? Changes nothing
    virtual bool may_resume_at(std::uint64_t serial) const = 0;
    // The operator has changed offsets or zeros (MachineView::store has them): they act from here
    // on. The programmed point stays the same number and becomes another point of the machine.
    // False: not here (blocks are read ahead: compensation); try again later.
    virtual bool offsets_changed() = 0;
    // Axes were moved by hand in a hold, by so much (drives, by place), and the program goes on
    // without going back first. Called behind resume_at(): whether the path of the block moves
    // along is the language's rule. False: it has none, go back first.
    virtual bool starts_away() const { return false; }
    virtual void start_away(const AxisValues& /*by*/) {}
    // What the program leaves to the one that is started next in this channel; taken behind
    // start().
    virtual std::any carry() const { return {}; }
    virtual void take_carry(const std::any& /*before*/, bool /*after_reset*/) {}
    // The tool offset in use is gone behind a reset, or else behind the end that the program has
    // come to.
    virtual bool loses_offset(bool /*by_reset*/) const { return false; }
    // The machine was interrupted by a signal that the program has enabled, and is stopped.
    // `serial`: the first block of which not everything is executed, 0 when there is none;
    // `within`: it has begun. The interrupt program comes next. False: this language, or this
    // block, cannot be interrupted.
    // `input`: the number of the interrupt input that came, where there are several.
    virtual bool interrupt(std::uint64_t /*serial*/, bool /*within*/, unsigned /*input*/) {
        return false;
    }
    // The signal has come, and the path is still on its way to the block `serial`, in front of
    // which the interrupt program comes. What of it acts at once is interpreted now. True:
    // interpretation stands in it, and interrupt_arrived() goes on when the path is there. False:
    // nothing has changed.
    virtual bool interrupt_ahead(std::uint64_t /*serial*/) { return false; }
    virtual void interrupt_arrived() {}
};

// By the name that --language takes; nothing for a language that is not built.
std::unique_ptr<Language> make_language(std::string_view name, MachineView& view, Sink& sink,
                                        Port& port, ProgramFiles& files);
std::unique_ptr<Language> make_fanuc(MachineView& view, Sink& sink, Port& port,
                                     ProgramFiles& files);
std::unique_ptr<Language> make_sinumerik(MachineView& view, Sink& sink, Port& port,
                                         ProgramFiles& files);
std::unique_ptr<Language> make_fagor(MachineView& view, Sink& sink, Port& port,
                                     ProgramFiles& files);
std::unique_ptr<Language> make_nct(MachineView& view, Sink& sink, Port& port, ProgramFiles& files);

}  // namespace polyturn::channels
