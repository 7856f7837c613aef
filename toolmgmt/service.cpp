#include "toolmgmt/service.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "ipc/image/store_changes.hpp"
#include "ipc/model/machine/check/config_check.hpp"
#include "ipc/params/registry.hpp"
#include "toolmgmt/cell_requests.hpp"
#include "toolmgmt/operations/backup_files.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/tools/places.hpp"
#include "toolmgmt/tools/tool_requests.hpp"
#include "toolmgmt/wait_any.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::uint64_t kMostPerStep = 1024;  // persist requests before somebody else is served
constexpr std::chrono::seconds kRetry{1};     // after the disk refused
// of one request of fixed fields, before it counts as what kills its readers
constexpr unsigned kMostTries = 5;
constexpr const char* kKilled = "the store died when it read this request; it is not read again";
constexpr std::size_t kMostImportLines = 100'000;
constexpr std::size_t kAnswerPiece = sizeof(StoreAnswer{}.text) - 1;
// changes that the kernel takes in one tick; its ring holds twice as many
constexpr std::size_t kMostAtOnce = 4096;

void copy_text(auto& to, std::string_view from) {
    to.fill(0);
    std::copy_n(from.begin(), std::min(from.size(), to.size() - 1), to.begin());
}

std::string one_line(const Diagnosis& diagnosis) {
    return std::string(alarm_number(diagnosis.alarm, Dialect::Polyturn)) + " " + diagnosis.text() +
           ". " + std::string(diagnosis.remedy());
}

}  // namespace

void Service::tell_not_kept(const Diagnosis& why) {
    std::fprintf(stderr, "polyturn-toolmgmt: %s\n", one_line(why).c_str());
    if (!kernel_.attached()) return;
    ToolAnswer message{};
    message.alarm = kStoreMessage;
    message.tool = static_cast<std::int32_t>(Alarm::NotKept);
    copy_text(message.text, why.text());
    // P2: the kernel has read the answers before its tail
    (void)image_.push(message, kernel_->tool_tail.tail.load(std::memory_order_acquire));
}

Service::Service(std::string instance, PeerSegment<SupervisorSegment> supervisor, StoreImage image,
                 StoreValues& values, Database* disk, Files files)
    : instance_(std::move(instance)),
      supervisor_(std::move(supervisor)),
      image_(std::move(image)),
      values_(values),
      disk_(disk),
      machine_(derive_machine_config(values.parameters)),
      files_(std::move(files)),
      places_(std::make_unique<ToolPlaceTable>()),
      logins_(std::make_unique<LoginLimit>()) {
    if (!disk_ && image_.taken_over()) {  // the image is all that there is
        image_.read_into(values_);
        machine_ = derive_machine_config(values_.parameters);
    }
    // P4: own word
    pending_index_ = image_.segment().persist_tail.tail.load();
    replay_from_ = image_.replay_from();
    // The transaction may have been the last thing that the predecessor did: the file knows better
    // than its image.
    if (const Cell* done = values_.cell({Kind::Setting, 0, 0, 0, "persist"});
        done && image_.taken_over()) {
        const std::string own = std::to_string(supervisor_->processes[kProcessKernel].pid) + ":";
        if (done->text.rfind(own, 0) == 0)
            replay_from_ = std::max<std::uint64_t>(
                replay_from_, std::strtoull(done->text.c_str() + own.size(), nullptr, 10));
    }
    look_at_condition();
    tell_condition();  // before the kernel is there, it reads it in its first tick
    look_for_kernel();
    // Before anything is shown: the predecessor showed these values, and they must not seem to go
    // back.
    replay();
    // Zeros that hold until power-off are in the image only, and the machine may be cutting by
    // them.
    if (disk_ && image_.taken_over()) image_.read_zeros_into(values_);
    derive_places(values_, *places_);
    image_.publish_all(values_);
    answer_what_was_begun();
}

// A predecessor that died between taking a request and its answer: its waiter is notified.
void Service::answer_what_was_begun() {
    StoreSegment& own = image_.segment();
    // P4: own words
    const auto head = own.answers.head.load(std::memory_order_relaxed),
               tail = own.request_tail.tail.load(std::memory_order_relaxed);
    if (!image_.taken_over()) return;
    if (head > 0 && own.answers.slot(head - 1).more != 0) {  // its end is missing
        StoreAnswer end{};
        end.id = own.answers.slot(head - 1).id;
        end.ok = 1;
        out_.push_back(end);
    }
    if (tail == 0) return;
    StoreRequest request = supervisor_->requests.slot(tail - 1);
    if (static_cast<StoreRequestKind>(request.kind) != StoreRequestKind::Operation ||
        begun_before(request.id) == 0)
        return;
    push_answer(request.id, refuse_begun(request));
}

void Service::push_answer(std::uint64_t id, std::string_view text) {
    for (std::size_t at = 0; at == 0 || at < text.size(); at += kAnswerPiece) {
        StoreAnswer piece{};
        piece.id = id;
        piece.ok = 1;
        piece.more = at + kAnswerPiece < text.size();
        copy_text(piece.text, text.substr(at, kAnswerPiece));
        out_.push_back(piece);
    }
}

Service::~Service() = default;

bool Service::step() {
    supervisor_seen_ = supervisor_->store_bell.seen();
    look_for_kernel();
    if (kernel_.attached()) kernel_seen_ = kernel_->store_bell.seen();
    bool worked = take_persist();
    send_answers();
    worked |= take_requests();
    back_up_when_due();
    tell_condition();
    const auto now = Clock::now();
    if (!pending_.empty() && now - pending_since_ >= kBatchMs && now >= next_try_) {
        const bool known = !disk_refuses_.empty();  // said once
        if (const Result<void> done = commit_pending({}, "program"); !done) {
            if (!known) tell_not_kept(done.diagnosis());
            next_try_ = now + kRetry;
        }
        worked = true;
    }
    if (worked)
        quiet_since_ = now;
    else
        fold_when_idle();
    return worked;
}

void Service::wait() {
    // a new kernel rings no bell of ours
    std::int64_t timeout_us = kernel_.attached() ? 100'000 : 4'000;
    if (!pending_.empty()) timeout_us = 5'000;
    if (!out_.empty()) timeout_us = 1'000;
    std::array<Watched, 2> bells{{{&supervisor_->store_bell, supervisor_seen_}, {nullptr, 0}}};
    std::size_t count = 1;
    if (kernel_.attached()) bells[count++] = {&kernel_->store_bell, kernel_seen_};
    wait_any(std::span(bells).first(count), timeout_us);
}

void Service::finish() {
    for (int i = 0; i < 1000 && step(); ++i) {}  // the kernel may have said its last words since
    if (pending_.empty()) return;
    if (const Result<void> done = commit_pending({}, "program"); !done)
        std::fprintf(stderr, "polyturn-toolmgmt: %s\n", one_line(done.diagnosis()).c_str());
}

// A kernel that is started anew has a new segment under the old name: the supervisor's table says
// which one lives.
void Service::look_for_kernel() {
    const std::int32_t pid = supervisor_->processes[kProcessKernel].pid;
    if (pid <= 0 || (kernel_.attached() && kernel_->header.writer_pid == pid)) return;
    auto fresh = PeerSegment<KernelSegment>::attach(instance_);
    if (!fresh || (*fresh)->header.writer_pid != pid) return;
    StoreSegment& own = image_.segment();
    if (kernel_.attached()) {
        while (take_persist()) {}  // what the dead one pushed is final and still counts
        commit_pending({}, "program").ok();
        // P2: nothing of its ring was taken. P4: on_disk is for a successor of this process
        own.persist_tail.tail.store(0, std::memory_order_release);
        own.on_disk.store(0, std::memory_order_release);
        replay_from_ = 0;
    } else if (own.persist_tail.tail.load() >
               // P4: own tail. P3: of the head the number alone counts
               (*fresh)->persist.head.load(std::memory_order_acquire)) {
        // Store and kernel were both replaced: this is not the ring that the predecessor read.
        // P2, P4: as above
        own.persist_tail.tail.store(0, std::memory_order_release);
        own.on_disk.store(0, std::memory_order_release);
        replay_from_ = 0;
    }
    kernel_ = std::move(*fresh);
    told_ = !unfit_;  // a new one has heard nothing
    // P4: own word
    pending_index_ = own.persist_tail.tail.load();
}

// What the predecessor had taken into its image but not to the disk: the kernel's ring still holds
// it unless the kernel has gone round since. A slot counts when the kernel has not come to it again
// after it was read.
void Service::replay() {
    StoreSegment& own = image_.segment();
    // P4: own word
    const auto tail = own.persist_tail.tail.load();
    if (!kernel_.attached()) return;
    constexpr auto kCapacity = decltype(KernelSegment::persist)::capacity;
    std::vector<Change> changes;
    for (auto index = replay_from_; index < tail; ++index) {
        // P5: the copy counts when the kernel has not come round since
        const StoreRequest request = kernel_->persist.slot(index);
        std::atomic_thread_fence(std::memory_order_acquire);
        if (kernel_->persist.head.load(std::memory_order_acquire) >= index + kCapacity) continue;
        // answered before its tail moved
        if (static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::ToolCall) continue;
        Result<Applied> applied = is_tool_request(request)
                                      ? apply_tool_request(request, values_)
                                      : apply_request(request, Origin::Program, machine_, values_);
        if (!applied) continue;
        if (applied->until_power_off) continue;  // the image has it
        refresh_machine(applied->changes);
        std::move(applied->changes.begin(), applied->changes.end(), std::back_inserter(changes));
    }
    keep_pending(changes);
    // All of it was on the disk already, the predecessor only could not say so any more.
    if (pending_.empty()) own.on_disk.store(tail, std::memory_order_release);
}

bool Service::take_persist() {
    if (!kernel_.attached()) return false;
    StoreSegment& own = image_.segment();
    // P1: the requests before head are complete. P4: own tail
    const auto head = kernel_->persist.head.load(std::memory_order_acquire);
    auto index = own.persist_tail.tail.load(std::memory_order_relaxed);
    if (index >= head) return false;
    const auto end = std::min(head, index + kMostPerStep);
    std::vector<Change> changes, passing;  // for the disk; until power-off
    std::vector<CellEntry> cells;
    for (; index < end; ++index) {
        const StoreRequest request = kernel_->persist.slot(index);
        if (static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::ToolCall) {
            if (!answer_tool_call(request)) break;  // the kernel has left no space: again later
            continue;
        }
        // an operator's, through the kernel
        if (const auto low = request.level ? level_refusal(request) : std::nullopt) {
            std::fprintf(stderr, "polyturn-toolmgmt: %s\n", one_line(*low).c_str());
            continue;
        }
        if (const auto cell = cell_of(request)) {
            cells.push_back(*cell);
            continue;
        }
        Result<Applied> applied = is_tool_request(request)
                                      ? apply_tool_request(request, values_)
                                      : apply_request(request, Origin::Program, machine_, values_);
        if (applied &&
            static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::OffsetValue &&
            request.channel >= 1 && request.channel <= kMaxChannels)
            look_at_wear(values_,
                         static_cast<unsigned>(offset_owner(values_.parameters, machine_,
                                                            request.channel, request.number)),
                         request.number, applied->changes);
        if (!applied) {
            tell_not_kept(applied.diagnosis());
            continue;
        }
        refresh_machine(applied->changes);
        push_parameter_changes(applied->changes);
        // What the kernel counts itself needs no change notification to it.
        if (const auto kind = static_cast<StoreRequestKind>(request.kind);
            kind != StoreRequestKind::ToolLife && kind != StoreRequestKind::ToolInPlace &&
            kind != StoreRequestKind::ToolChanged)
            tell_kernel(applied->changes, request.id);
        std::move(applied->changes.begin(), applied->changes.end(),
                  std::back_inserter(applied->until_power_off ? passing : changes));
    }
    if (const Result<void> kept = keep_cells(supervisor_->options, values_.parameters, cells);
        !kept)
        tell_not_kept(kept.diagnosis());
    keep_pending(changes);
    changes.insert(changes.end(), passing.begin(), passing.end());
    image_.publish(values_, changes);
    pending_index_ = index;
    // The image is out: virtual time may go on.
    // P1, P2: they were read, and what they changed is published
    own.persist_tail.tail.store(index, std::memory_order_release);
    own.bell.ring();
    // P4: read by a successor
    if (pending_.empty()) own.on_disk.store(index, std::memory_order_release);
    return true;
}

bool Service::take_requests() {
    StoreSegment& own = image_.segment();
    bool worked = false;
    for (;;) {
        // P4: own tail. P1: the requests before head are complete
        const auto index = own.request_tail.tail.load(std::memory_order_relaxed);
        if (index >= supervisor_->requests.head.load(std::memory_order_acquire)) return worked;
        send_answers();
        if (!out_.empty()) return worked;
        // Room for the answer first: an operator's change whose answer cannot be given must not be
        // made.
        // P4: own head. P2: room for the answer
        if (own.answers.head.load(std::memory_order_relaxed) -
                supervisor_->answer_tail.tail.load(std::memory_order_acquire) >=
            decltype(StoreSegment::answers)::capacity)
            return worked;
        const StoreRequest request = supervisor_->requests.slot(index);
        const bool parameter =
            static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::Parameter;
        // its sender gave up: the lines of an import follow each other
        if (!parameter) import_.clear();
        if (static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::Operation) {
            // Pieces follow each other; `number` is where this one begins, so that a sender that
            // gave up spoils nothing.
            if (request.number == 0) operation_.clear();
            if (operation_.size() == static_cast<std::size_t>(request.number) &&
                operation_.size() <= kLargestRequest)
                operation_.append(request.name.data(),
                                  ::strnlen(request.name.data(), request.name.size()));
            if (request.field != kMoreFollows) {
                // What killed its reader is not read again: nobody knows what it would do to this
                // one.
                const bool again = begun_before(request.id) > 0;
                mark_begun(request.id, 1);
                const std::string text =
                    again ? refuse_begun(request)
                          : operate_safely(std::exchange(operation_, {}), request);
                push_answer(request.id, text);
            }
            // P2: it was read
            own.request_tail.tail.store(index + 1, std::memory_order_release);
            send_answers();
            own.bell.ring();
            worked = true;
            continue;
        }
        // One of fixed fields may be tried again: most likely its reader was killed from outside.
        const unsigned before = begun_before(request.id);
        mark_begun(request.id, before + 1);
        Result<Applied> applied = Applied{{}, "more follows"};
        if (before >= kMostTries) {
            applied = Diagnosis{Alarm::RequestBad, {}, {}, kKilled};
            import_.clear();
        } else if (parameter && request.field == kMoreFollows) {
            if (import_.size() < kMostImportLines)
                import_.push_back(request);
            else
                applied = Diagnosis{
                    Alarm::StoreRequestBad,
                    {},
                    {},
                    "an import of more than " + std::to_string(kMostImportLines) + " lines"};
        } else {
            applied = apply_operator(request);
            import_.clear();
        }
        answer(request, applied);
        // P2: it was read. P1: its answer is there
        own.request_tail.tail.store(index + 1, std::memory_order_release);
        own.bell.ring();
        worked = true;
    }
}

// The slot that is filled next belongs to no other process: it says what is being worked on, to
// whoever follows in this segment.
void Service::mark_begun(std::uint64_t id, unsigned times) {
    auto& ring = image_.segment().answers;
    // P4: own head
    StoreAnswer& next = ring.slot(ring.head.load(std::memory_order_relaxed));
    next = {};
    next.more = times;
    // P8: a successor that finds the id finds the count too
    std::atomic_signal_fence(std::memory_order_release);
    next.id = id;
}

unsigned Service::begun_before(std::uint64_t id) {
    const auto& ring = image_.segment().answers;
    // P4: own head
    const StoreAnswer& next = ring.slot(ring.head.load(std::memory_order_relaxed));
    return next.id == id && id != 0 && next.ok == 0 && next.text[0] == 0 ? next.more : 0;
}

// The request, with the lines of its import before it: checked, on disk, in the image. All of it or
// nothing.
Result<Applied> Service::apply_operator(const StoreRequest& request) {
    std::map<Key, Change> all;  // a value that two lines set changes once
    std::vector<StoreRequest> requests = import_;
    requests.push_back(request);
    std::string answer;
    const auto changes = [&] {
        std::vector<Change> out;
        for (const auto& [key, change] : all) out.push_back(change);
        return out;
    };
    for (const StoreRequest& one : requests) {
        if (const auto refused = has_users() ? level_refusal(one) : std::nullopt) {
            undo(changes());
            return *refused;
        }
        Result<Applied> applied = apply_request(one, Origin::Operator, machine_, values_);
        if (!applied) {
            undo(changes());
            return applied;
        }
        answer = applied->answer;
        if (static_cast<StoreRequestKind>(one.kind) == StoreRequestKind::OffsetValue)
            look_at_wear(values_,
                         static_cast<unsigned>(
                             offset_owner(values_.parameters, machine_, one.channel, one.number)),
                         one.number, applied->changes);
        for (Change& change : applied->changes) {
            const auto [at, fresh] = all.emplace(change.key, change);
            if (!fresh) {
                at->second.after = change.after;
                at->second.text_after = change.text_after;
            }
        }
    }
    Applied done{changes(), std::move(answer)};
    // Also after a query: what it shows counts as written, so what came before it goes to the disk
    // with it.
    if (const Result<void> kept = commit_pending(done.changes, user_name(request)); !kept) {
        undo(done.changes);
        return kept.diagnosis();
    }
    refresh_machine(done.changes);
    image_.publish(values_, done.changes);
    push_parameter_changes(done.changes);
    tell_kernel(done.changes, 0);
    return done;
}

void Service::answer(const StoreRequest& request, const Result<Applied>& applied) {
    StoreAnswer out{};
    out.id = request.id;
    out.ok = applied ? 1 : 0;
    if (!applied) {
        copy_text(out.text, one_line(applied.diagnosis()));
    } else if (!applied->answer.empty()) {
        copy_text(out.text, applied->answer);
    } else if (static_cast<StoreRequestKind>(request.kind) == StoreRequestKind::Parameter) {
        // Stored, because the other half of the change may be in transit; but a start with it would
        // be refused.
        if (const auto wrong = check_machine_config(values_.parameters); !wrong.empty())
            copy_text(out.text, "stored, but: " + one_line(wrong.front()));
    }
    auto& ring = image_.segment().answers;
    // P4: own head
    const auto head = ring.head.load(std::memory_order_relaxed);
    ring.slot(head) = out;
    // P1: the answer is complete
    ring.head.store(head + 1, std::memory_order_release);
}

// What the disk says of itself: nobody's rights grow because users were lost, and the kernel starts
// nothing.
void Service::look_at_condition() {
    const bool was = unfit_;
    unfit_ = disk_ && disk_->condition().unfit;
    image_.set_locked(disk_ && (disk_->condition().locked || disk_->condition().had_users));
    if (unfit_ != was) told_ = false;
    if (!unfit_ || was) return;
    std::string detail = disk_->condition().unfit->detail;
    const auto newest = newest_good_backup(files_.store_folder);
    detail += newest ? "; newest backup: " + newest->substr(newest->rfind('/') + 1)
                     : "; there is no backup";
    unfit_text_ = detail;
    std::fprintf(stderr, "polyturn-toolmgmt: %s\n",
                 one_line({disk_->condition().unfit->alarm, {}, {}, detail}).c_str());
}

void Service::tell_condition() {
    if (told_) return;
    // P4: own head
    const auto head = image_.segment().tool_answers.head.load(std::memory_order_relaxed);
    if (!kernel_.attached() && head != 0) return;
    ToolAnswer message{};
    message.alarm = unfit_ ? kStoreUnfit : kStoreWhole;
    if (unfit_) message.tool = static_cast<std::int32_t>(disk_->condition().unfit->alarm);
    copy_text(message.text, unfit_text_);
    // P2: the kernel has read the answers before its tail
    told_ = image_.push(
        message, kernel_.attached() ? kernel_->tool_tail.tail.load(std::memory_order_acquire) : 0);
}

// A log that lies there for days is a risk for days; folding it in while nobody waits costs nobody
// anything.
void Service::fold_when_idle() {
    if (!disk_ || !disk_->anything_to_fold() || !pending_.empty() ||
        Clock::now() - quiet_since_ < kIdle)
        return;
    quiet_since_ = Clock::now();
    if (const Result<void> folded = disk_->fold(); !folded)
        std::fprintf(stderr, "polyturn-toolmgmt: %s\n", one_line(folded.diagnosis()).c_str());
}

// All numbers of one request are one import: the kernel takes them in the same tick.
void Service::push_parameter_changes(const std::vector<Change>& changes) {
    StoreSegment& own = image_.segment();
    std::vector<ParamChange> out;
    for (const Change& change : changes) {
        const double* at = change.key.kind == Kind::Parameter && !change.is_text
                               ? number_at(values_, change.key)
                               : nullptr;
        if (!at) continue;
        ParamChange next{};
        next.import_id = import_id_ + 1;
        next.slot = static_cast<std::uint32_t>(at - values_.parameters.numbers.data());
        next.value = *at;
        out.push_back(next);
    }
    if (out.empty()) return;
    ++import_id_;
    // Larger than the ring it cannot be taken in one tick: then in as few as possible.
    for (std::size_t i = kMostAtOnce - 1; i < out.size(); i += kMostAtOnce) out[i].last = 1;
    out.back().last = 1;
    auto& ring = own.param_changes;
    constexpr auto kCapacity = decltype(StoreSegment::param_changes)::capacity;
    for (const ParamChange& next : out) {
        // P4: own head
        const auto head = ring.head.load(std::memory_order_relaxed);
        // A live kernel takes them every tick; one that does not within a second is dead or
        // stopped, and its successor reads the whole table. Without a kernel nobody reads the ring.
        // P2: room, when the kernel has read what lay there
        for (int ms = 0;
             kernel_.attached() &&
             head - kernel_->param_tail.tail.load(std::memory_order_acquire) >= kCapacity &&
             ms < 1000;
             ++ms)
            sleep_ms(1);
        ring.slot(head) = next;
        // P1: the change is complete
        ring.head.store(head + 1, std::memory_order_release);
    }
}

void Service::keep_pending(const std::vector<Change>& changes) {
    if (!disk_) return;
    if (pending_.empty() && !changes.empty()) pending_since_ = Clock::now();
    for (const Change& change : changes) {
        const auto [at, fresh] = pending_.emplace(change.key, change);
        if (fresh) continue;
        at->second.after = change.after;
        at->second.text_after = change.text_after;
    }
}

Result<void> Service::commit_pending(const std::vector<Change>& more, std::string_view who) {
    if (disk_) {
        std::vector<Change> batch;
        for (const auto& [key, change] : pending_) batch.push_back(change);
        if (!batch.empty()) {
            // How far the kernel's ring is on disk goes into the same transaction: life that was
            // counted is not counted twice.
            const Key key{Kind::Setting, 0, 0, 0, "persist"};
            batch.push_back({key, 0, 0, {}, mark(), true});
            Result<void> done = disk_->commit(batch, "program");
            disk_refuses_ = done ? std::string() : done.diagnosis().text();
            if (!done) return done;
        }
        pending_.clear();
    }
    // P4: read by a successor
    image_.segment().on_disk.store(pending_index_, std::memory_order_release);
    if (disk_ && !more.empty()) return disk_->commit(more, who);
    return {};
}

void Service::undo(const std::vector<Change>& changes) {
    for (const Change& change : changes)
        write_value(values_, change.key, change.before, change.text_before, change.is_text);
}

void Service::refresh_machine(const std::vector<Change>& changes) {
    const bool places = std::any_of(changes.begin(), changes.end(), [](const Change& c) {
        return c.key.kind == Kind::Parameter || c.key.kind == Kind::Place ||
               (c.key.kind == Kind::Tool &&
                (c.key.name == "magazine" || c.key.name == "pot" || c.key.name == "exists"));
    });
    if (places) derive_places(values_, *places_);
    const bool parameters = std::any_of(changes.begin(), changes.end(), [](const Change& c) {
        return c.key.kind == Kind::Parameter;
    });
    if (parameters) machine_ = derive_machine_config(values_.parameters);
}

}  // namespace polyturn::toolmgmt
