// What has been entered at this panel, for Undo. The newest is taken back, unless the present value
// is not what was entered: a measuring cycle, the wear of a part or another panel has been
// there since, and that is not taken back. Pressed faster than the store answers, it waits until
// what was entered before can be seen.
#pragma once
#include <QDateTime>
#include <functional>
#include <optional>
#include <vector>

namespace polyturn::hmi {

// Where: which value it is. Content: its content.
template <class Where, class Content>
class Changes {
public:
    struct Change {
        Where where;
        Content old, now;
    };
    std::function<Content(const Where&)> present;
    std::function<bool(const Content&, const Content&)> same;
    // enters `old` again: asked(), then answered() or entered()
    std::function<void(const Change&)> putBack;
    // says that it stays, and what is there
    std::function<void(const Change&, const Content&)> keep;

    void asked() { ++asked_; }
    void refused() {
        --asked_;
        goOn();
    }
    void entered(Change change) {
        --asked_;
        unseen_ = change;
        unseenUntil_ = QDateTime::currentMSecsSinceEpoch() + kSeenWithinMs;
        list_.push_back(std::move(change));
    }
    void takenBack(Change change) {
        --asked_;
        unseen_ = std::move(change);
        unseenUntil_ = QDateTime::currentMSecsSinceEpoch() + kSeenWithinMs;
    }
    const Change* newest() const { return list_.empty() ? nullptr : &list_.back(); }
    void undo() {
        ++wanted_;
        goOn();
    }
    // Each frame.
    void goOn() {
        if (unseen_ && (same(present(unseen_->where), unseen_->now) ||
                        QDateTime::currentMSecsSinceEpoch() > unseenUntil_))
            unseen_.reset();
        while (wanted_ > 0 && asked_ == 0 && !unseen_) {
            --wanted_;
            if (list_.empty()) continue;
            const Change taken = std::move(list_.back());
            list_.pop_back();
            const Content there = present(taken.where);
            if (same(there, taken.now))
                putBack(taken);
            else
                keep(taken, there);
        }
    }

private:
    static constexpr qint64 kSeenWithinMs = 1'000;  // then somebody else was faster
    std::vector<Change> list_;
    // entered, but the image still has what was there before
    std::optional<Change> unseen_;
    qint64 unseenUntil_ = 0;
    int asked_ = 0, wanted_ = 0;
};

}  // namespace polyturn::hmi
