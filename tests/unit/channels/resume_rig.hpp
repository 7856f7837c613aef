// Reads ahead in a program, comes back to one of its blocks, and tells what follows.
#pragma once
#include <gtest/gtest.h>

#include "channels/preset.hpp"
#include "play.hpp"

namespace polyturn::channels::testing {

class SerialSink final : public Sink {
public:
    explicit SerialSink(EventScene scene) : events_(scene, text_, true, 0) {}
    std::vector<std::pair<std::uint64_t, std::string>> events;

    void move(const Move& m, const BlockContext& at) override {
        events_.move(m, at);
        take(at);
    }
    void dwell(const Dwell& d, const BlockContext& at) override {
        events_.dwell(d, at);
        take(at);
    }
    void aux(const Aux& a, const BlockContext& at) override {
        events_.aux(a, at);
        take(at);
    }
    void spindle(const Spindle& s, const BlockContext& at) override {
        events_.spindle(s, at);
        take(at);
    }
    void wait(const Wait& w, const BlockContext& at) override {
        events_.wait(w, at);
        take(at);
    }
    void variable(const Variable& v, const BlockContext& at) override {
        events_.variable(v, at);
        take(at);
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        events_.offset(o, at);
        take(at);
    }
    void message(std::string_view t, const BlockContext& at) override {
        events_.message(t, at);
        take(at);
    }
    void stop(const Stop& s, const BlockContext& at) override {
        events_.stop(s, at);
        take(at);
    }
    void part(double c, const BlockContext& at) override {
        events_.part(c, at);
        take(at);
    }
    void alarm(const Diagnosis& d, const BlockContext& at) override {
        events_.alarm(d, at);
        take(at);
    }
    void barrier(const BlockContext&) override {}
    void block_end(const BlockContext&) override {}

private:
    void take(const BlockContext& at) {
        if (!text_.empty()) events.emplace_back(at.serial, text_);
        text_.clear();
    }
    std::string text_;
    EventSink events_;
};

// Reads `ahead` blocks, goes back to block `back` (0: never), reads to the end.
inline std::vector<std::pair<std::uint64_t, std::string>> run_with_return(
    std::string_view language, std::string_view text, std::uint64_t ahead, std::uint64_t back,
    const text::ChannelSetup& own = {}) {
    const auto table = lathe({"N0107 A5=3", "N0108 A5=360"});
    MachineView view = make_machine_view(*table, 1);
    view.store->offsets[1].wear[0] = 0.5;
    const text::Setup setup;
    ProgramFiles files;
    for (const std::string& path : own.subprograms) files.add_library(path);
    SerialSink sink({&view, &files, dialect_of(language)});
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(text, "t");
    const auto interpreter = make_language(language, view, sink, port, files);
    EXPECT_TRUE(interpreter->start(*main).ok());
    preset(*interpreter, own);
    interpreter->keep_resume_states(true);
    bool went_back = back == 0;
    for (int steps = 0; steps < 2000; ++steps) {
        const Step step = interpreter->step();
        if (step == Step::AtBarrier) interpreter->barrier_done();
        if (!went_back && interpreter->core().at.serial >= ahead) {
            went_back = true;
            while (!sink.events.empty() && sink.events.back().first >= back) sink.events.pop_back();
            EXPECT_TRUE(interpreter->resume_at(back));
            continue;
        }
        if (step == Step::Ended || step == Step::Failed) break;
    }
    return sink.events;
}

// Whatever block a channel returns to, what follows is what followed the first time.
inline void expect_same_events_from_every_block(std::string_view language, std::string_view program,
                                                const text::ChannelSetup& own = {}) {
    SCOPED_TRACE(std::string(program));
    const auto straight = run_with_return(language, program, 0, 0, own);
    ASSERT_FALSE(straight.empty());
    EXPECT_EQ(straight.back().second.find("alarm"), std::string::npos) << straight.back().second;
    const std::uint64_t blocks = straight.back().first;
    for (std::uint64_t back = 1; back <= blocks; ++back)
        for (std::uint64_t ahead = back; ahead <= blocks; ahead += 1 + ahead / 8) {
            const auto again = run_with_return(language, program, ahead, back, own);
            ASSERT_EQ(again, straight) << "from block " << ahead << " back to " << back;
        }
}

}  // namespace polyturn::channels::testing
