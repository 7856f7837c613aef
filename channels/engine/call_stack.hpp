// The texts that are being run, the outermost first, and the source of the innermost one. Which
// levels there may be, which parameters a level has and what a return restores is the language's;
// so is the type of a frame. It has at least:
//
//   FileId file            the text
//   TextPosition begin     where it is entered, and entered again
//   TextPosition resume    where the text that called it goes on
#pragma once
#include <utility>
#include <vector>

#include "channels/program_files.hpp"
#include "channels/text/line_source.hpp"

namespace polyturn::channels::engine {

template <class Frame>
class CallStack {
public:
    explicit CallStack(ProgramFiles& files) : files_(&files) { frames_.reserve(32); }

    Frame& here() { return frames_.back(); }
    const Frame& here() const { return frames_.back(); }
    const Frame& main() const { return frames_.front(); }
    LineSource& source() { return *source_; }
    const std::vector<Frame>& frames() const { return frames_; }
    bool empty() const { return frames_.empty(); }
    std::size_t depth() const { return frames_.size(); }

    // The only text from here on.
    void start(Frame frame) {
        frames_.clear();
        push(std::move(frame));
    }
    // It is called by the running text, which goes on behind what has been read of it.
    void enter(Frame frame) {
        frame.resume = source_->next_position();
        push(std::move(frame));
    }
    // The innermost text once more, from its beginning.
    void again() { source_->seek(here().begin); }
    // Back to where it was called.
    Frame leave() {
        Frame done = std::move(frames_.back());
        frames_.pop_back();
        go_on_at(done.resume);
        return done;
    }
    // The innermost frame ends without a return: the running text is that of the next one out.
    void drop() { frames_.pop_back(); }
    // What a resume state has kept, and where the block begins.
    void restore(const std::vector<Frame>& frames, TextPosition position) {
        frames_ = frames;
        go_on_at(position);
    }
    // A second reader of the same texts; it reads by the same source.
    void share(const CallStack& other) {
        frames_ = other.frames_;
        source_ = other.source_;
    }

private:
    void push(Frame frame) {
        const TextPosition begin = frame.begin;
        frames_.push_back(std::move(frame));
        go_on_at(begin);
    }
    void go_on_at(TextPosition position) {
        source_ = &files_->source(here().file);
        source_->seek(position);
    }

    ProgramFiles* files_;
    std::vector<Frame> frames_;
    LineSource* source_ = nullptr;
};

}  // namespace polyturn::channels::engine
