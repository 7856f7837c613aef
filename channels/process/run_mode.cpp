#include "channels/process/run_mode.hpp"

#include <filesystem>

#include "channels/check/event_text.hpp"
#include "channels/preset.hpp"
#include "channels/process/channel_process.hpp"
#include "channels/program_files.hpp"

namespace polyturn::channels {
namespace {

// The language that --language names, or the job of the selected file, or the machine; a block by
// hand is in that of the machine.
std::string language_of(const RunModeOptions& options, const MachineView& view,
                        const ProgramChoice& choice = {}) {
    if (options.language.empty() && choice.mdi.empty() && choice.language != Dialect::Polyturn)
        return std::string(language_name(choice.language));
    return options.language.empty()
               ? std::string(params::get_text(view.table(), params::pt_language, view.channel))
               : options.language;
}

// A program in one of the languages, with the files that it can reach.
class LanguageRun : public ProgramRun {
public:
    LanguageRun(MachineView& view, Sink& sink, Port& port, const ProgramChoice& choice,
                const text::Setup& setup, const std::string& language, EventSink*& events)
        : view_(&view),
          port_(&port),
          choice_(choice),
          setup_(&setup),
          events_(&events),
          name_(language) {
        for (const std::string& path : setup.channel(view.channel).subprograms)
            files_.add_library(path);
        const std::string& place = choice.mdi.empty() ? choice.path : choice.beside;
        const std::string folder = std::filesystem::path(place).parent_path().string();
        if (!place.empty()) files_.add_folder(folder);
        const std::string_view memory =
            params::get_text(view.table(), params::pt_program_folders, view.channel);
        files_.add_folders(memory, folder);
        if (const std::string_view first = memory.substr(0, memory.find(':')); !first.empty())
            files_.keep_in((std::filesystem::path(folder) / first).string());
        language_ = make_language(language, view, sink, port, files_);
    }
    Result<void> start() override {
        if (choice_.mdi.empty() && choice_.path.empty())
            return Diagnosis{Alarm::FileUnreadable, {}, {}, "no program is selected"};
        if (!language_)
            return Diagnosis{Alarm::NotBuilt, {choice_.path, 0, 0, 0}, {}, "the language " + name_};
        // Only fanuc programs know that the slide is inclined (fanuc_lathe 10.5): another one would
        // drive past where it means.
        if (params::bit(view_->table(), params::f8200, view_->channel, 0) &&
            dialect_of(name_) != Dialect::Fanuc)
            return Diagnosis{Alarm::NotBuilt, {choice_.path, 0, 0, 0}, {}, "F8200, " + name_};
        auto main =
            choice_.mdi.empty() ? files_.open(choice_.path) : files_.open_text(choice_.mdi, "MDI");
        if (!main) return main.diagnosis();
        if (auto started = language_->start(*main); !started) return started.diagnosis();
        language_->core().start_at_machine(view_->start);
        if (const ToolTable* tools = port_->tool_table())
            language_->preset_stored(*tools, *port_->tool_edges(),
                                     static_cast<int>(params::get(
                                         view_->table(), params::pt_tool_unit, view_->channel)));
        preset(*language_, setup_->channel(view_->channel));
        return {};
    }
    Step step() override { return language_->step(); }
    void barrier_done() override { language_->barrier_done(); }
    bool interrupt(std::uint64_t serial, bool within, unsigned input) override {
        return language_->interrupt(serial, within, input);
    }
    bool interrupt_ahead(std::uint64_t serial) override {
        return language_->interrupt_ahead(serial);
    }
    void interrupt_arrived() override { language_->interrupt_arrived(); }
    std::any carry() const override { return language_ ? language_->carry() : std::any{}; }
    void take_carry(const std::any& before, bool after_reset) override {
        if (language_) language_->take_carry(before, after_reset);
    }
    void executed(std::uint64_t serial) override { language_->executed(serial); }
    void keep_resume_states(bool on) override { language_->keep_resume_states(on); }
    bool may_resume_at(std::uint64_t serial) const override {
        return language_->may_resume_at(serial);
    }
    bool resume_at(std::uint64_t serial) override { return language_->resume_at(serial); }
    bool starts_away() const override { return language_ && language_->starts_away(); }
    bool loses_offset(bool by_reset) const override {
        return language_ && language_->loses_offset(by_reset);
    }
    void start_away(const AxisValues& by) override { language_->start_away(by); }
    bool offsets_changed() override { return language_->offsets_changed(); }
    BlockContext at() const override { return language_->core().at; }
    std::size_t file_count() const override { return files_.count(); }
    std::string file_name(std::size_t index) const override {
        return files_.path(static_cast<FileId>(index));
    }
    const Core* core() const override { return language_ ? &language_->core() : nullptr; }
    void active_codes(std::string& out) const override {
        if (language_) language_->active_codes(out);
    }
    void list_variables(const Language::ShowVariable& show) const override {
        if (language_) language_->list_variables(show);
    }
    void shown() override {
        if (*events_) {
            (*events_)->set_files(&files_);
            (*events_)->speak(dialect_of(name_));
        }
    }

private:
    MachineView* view_;
    Port* port_;
    ProgramChoice choice_;
    const text::Setup* setup_;
    EventSink** events_;  // the describing sink of the running program
    ProgramFiles files_;
    std::string name_;
    std::unique_ptr<Language> language_;
};

}  // namespace

Result<void> run_mode(const RunModeOptions& options) {
    text::Setup setup;
    if (!options.setup.empty()) {
        auto loaded = text::load_setup(options.setup);
        if (!loaded) return loaded.diagnosis();
        setup = std::move(*loaded);
    }
    ProcessServices services;
    services.setup = &setup;
    services.kept_folder = options.kept;
    EventSink* events = nullptr;  // the describing sink of the running program
    services.make_run = [&](MachineView& view, Sink& sink, Port& port,
                            const ProgramChoice& choice) -> std::unique_ptr<ProgramRun> {
        const std::string language = language_of(options, view, choice);
        auto run = std::make_unique<LanguageRun>(view, sink, port, choice, setup, language, events);
        run->shown();
        return run;
    };
    services.make_describer = [&](const MachineView& view,
                                  std::string& text) -> std::unique_ptr<Sink> {
        auto sink = std::make_unique<EventSink>(
            EventScene{&view, nullptr, dialect_of(language_of(options, view))}, text,
            options.variables, '\0');
        events = sink.get();
        return sink;
    };
    auto process = ChannelProcess::create(options.instance, options.channel, std::move(services));
    if (!process) return process.diagnosis();
    (*process)->run();
    return {};
}

}  // namespace polyturn::channels
