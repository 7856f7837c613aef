// Events as text: one JSON object each, as cli.md section 3 says. The one place that knows the
// keys: check mode prints these objects, run mode puts them into the notes of its records (there
// without their times, which the kernel knows).
#pragma once
#include <string>

#include "channels/machine_view.hpp"
#include "channels/program_files.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels {

// What all events of a channel share.
struct EventScene {
    const MachineView* view = nullptr;
    // names of the files that BlockContext::file means; may be absent
    const ProgramFiles* files = nullptr;
    Dialect dialect = Dialect::Polyturn;
};

// Each appends one object without a line end.
void append_event(std::string& out, const EventScene&, const Move&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Dwell&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Aux&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Spindle&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Wait&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Variable&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const OffsetWrite&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Stop&, const BlockContext&);
void append_event(std::string& out, const EventScene&, const Diagnosis&, const BlockContext&);
void append_message_event(std::string& out, const EventScene&, std::string_view text,
                          const BlockContext&);
void append_print_event(std::string& out, const EventScene&, std::string_view text,
                        const BlockContext&);
// What the signals of channels/program_start.hpp say: {"ev":"select", channel, program},
// {"ev":"start", channels}; nothing of others.
void append_signal_event(std::string& out, const EventScene&, std::string_view name, double value,
                         const BlockContext&);
void append_part_event(std::string& out, const EventScene&, double count, const BlockContext&);

// A sink that appends every event to a text, each followed by `separator` (0: nothing).
class EventSink final : public Sink {
public:
    EventSink(EventScene scene, std::string& text, bool variables, char separator)
        : scene_(scene), text_(&text), variables_(variables), separator_(separator) {}
    void set_files(const ProgramFiles* files) { scene_.files = files; }
    void speak(Dialect dialect) { scene_.dialect = dialect; }  // of the program that begins

    void move(const Move& m, const BlockContext& at) override { put(m, at); }
    void dwell(const Dwell& d, const BlockContext& at) override { put(d, at); }
    void aux(const Aux& a, const BlockContext& at) override {
        if (!a.silent) put(a, at);
    }
    void spindle(const Spindle& s, const BlockContext& at) override {
        if (!s.silent) put(s, at);
    }
    void wait(const Wait& w, const BlockContext& at) override {
        if (w.act != Wait::Act::Arrive) put(w, at);
    }
    void variable(const Variable& v, const BlockContext& at) override {
        if (variables_) put(v, at);
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override { put(o, at); }
    void stop(const Stop& s, const BlockContext& at) override {
        if (s.asked) put(s, at);
    }
    void alarm(const Diagnosis& d, const BlockContext& at) override {
        errors_ += d.severity() == Severity::Error;
        put(d, at);
    }
    void message(std::string_view text, const BlockContext& at) override {
        append_message_event(*text_, scene_, text, at);
        end();
    }
    void part(double count, const BlockContext& at) override {
        append_part_event(*text_, scene_, count, at);
        end();
    }
    void print(std::string_view text, const BlockContext& at) override {
        append_print_event(*text_, scene_, text, at);
        end();
    }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        const std::size_t before = text_->size();
        append_signal_event(*text_, scene_, name, value, at);
        if (text_->size() != before) end();
    }
    void barrier(const BlockContext&) override {}
    void block_end(const BlockContext&) override {}
    unsigned errors() const { return errors_; }

private:
    template <class Event>
    void put(const Event& event, const BlockContext& at) {
        const std::size_t before = text_->size();
        append_event(*text_, scene_, event, at);
        if (text_->size() != before) end();  // some say nothing
    }
    void end() {
        if (separator_) *text_ += separator_;
    }

    EventScene scene_;
    std::string* text_;
    bool variables_;
    char separator_;
    unsigned errors_ = 0;
};

}  // namespace polyturn::channels
