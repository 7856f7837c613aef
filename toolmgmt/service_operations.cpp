// The store's service of operations (operations/operation.hpp) and for T calls of the kernel.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/check/config_check.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/cell_requests.hpp"
#include "toolmgmt/operations/backup_files.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/operations/rectangular.hpp"
#include "toolmgmt/service.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {

bool Service::answer_tool_call(const StoreRequest& request) {
    ToolAnswer answer = toolmgmt::answer_tool_call(request, values_, *places_);
    // What a tool has done could not be kept: no tool is changed until the disk takes it again.
    if (!disk_refuses_.empty()) {
        answer.alarm = static_cast<std::int32_t>(Alarm::ToolsUnserved);
        answer.text.fill(0);
        std::copy_n(disk_refuses_.begin(), std::min(disk_refuses_.size(), answer.text.size() - 1),
                    answer.text.begin());
    }
    // P2: the kernel has read the answers before its tail
    return image_.push(answer, kernel_->tool_tail.tail.load(std::memory_order_acquire));
}

// Whoever resets the life of the tool that works just now means the kernel's count too. `request`:
// of the kernel's ring, 0 an operator's.
void Service::tell_kernel(const std::vector<Change>& changes, std::uint64_t request) {
    if (!kernel_.attached() || std::none_of(changes.begin(), changes.end(), [](const Change& c) {
            return c.key.kind == Kind::Tool;
        }))
        return;
    for (ToolAnswer& news : changes_of_tools_in_work(values_, *places_, changes)) {
        news.id = request;
        // P2: the kernel has read the answers before its tail
        (void)image_.push(news, kernel_->tool_tail.tail.load(std::memory_order_acquire));
    }
}

std::string Service::user_name(const StoreRequest& request) const {
    if (request.user == 0) return "operator";
    const Cell* name =
        values_.cell({Kind::User, 0, static_cast<std::int32_t>(request.user), 0, "name"});
    return name ? name->text : "operator";
}

bool Service::has_users() const {
    const auto first = values_.cells.lower_bound(Key{Kind::User, 0, 0, 0, {}});
    return (first != values_.cells.end() && first->first.kind == Kind::User) ||
           (disk_ && (disk_->condition().locked || disk_->condition().had_users));
}

// Of this kernel's ring: another kernel counts from 0 again.
std::string Service::mark() const {
    return std::to_string(kernel_.attached() ? kernel_->header.writer_pid : 0) + ":" +
           std::to_string(pending_index_);
}

void Service::send_answers() {
    auto& ring = image_.segment().answers;
    bool sent = false;
    while (!out_.empty()) {
        // P4: own head. P2: room, when the supervisor has read what lay there
        const auto head = ring.head.load(std::memory_order_relaxed);
        if (head - supervisor_->answer_tail.tail.load(std::memory_order_acquire) >=
            decltype(StoreSegment::answers)::capacity)
            break;
        ring.slot(head) = out_.front();
        // P1: the answer is complete
        ring.head.store(head + 1, std::memory_order_release);
        out_.pop_front();
        sent = true;
    }
    if (sent) image_.segment().bell.ring();
}

std::string Service::operate(const std::string& text, const StoreRequest& request) {
    Work work{values_,
              machine_,
              disk_,
              {static_cast<UserLevel>(request.level), request.user, user_name(request)},
              files_.machine_folder,
              instance_,
              {},
              {},
              {},
              {},
              false,
              {}};
    work.compensation_file = compensation_file(supervisor_->options);
    work.position = [this](unsigned axis) -> std::optional<double> {
        if (!kernel_.attached() || axis < 1 || axis > kMaxAxes) return {};
        const auto status = std::make_unique<MachineStatus>();
        if (!kernel_->status.read(*status)) return {};
        return status->axes[axis - 1].act;
    };
    work.touch = [this](unsigned channel) -> std::optional<Touch> {
        const auto status = std::make_unique<MachineStatus>();
        const auto plc = std::make_unique<PlcOutputs>();
        if (!kernel_.attached() || !kernel_->status.read(*status) || !kernel_->plc_seen.read(*plc))
            return {};
        const ChannelStatus& own = status->channels[channel - 1];
        Touch out;
        out.axis = static_cast<unsigned>(std::abs(own.touched));
        out.negative = own.touched < 0;
        out.setter = own.touched_at;
        if (out.axis >= 1 && out.axis <= kMaxAxes) out.at = status->axes[out.axis - 1].skip;
        if (const AngularAxes axes = angular_of(values_.parameters, machine_, channel); axes.on)
            out.slide_at = status->axes[machine_.channel(channel).axes[axes.angular] - 1u].skip;
        out.plc_offset = plc->signal[PlcSignal{signals::cp_offsno}(channel)];
        return out;
    };
    work.logins = logins_.get();
    // A predecessor that was killed behind its transaction had done it already: an id is done once.
    const Key done_key{Kind::Setting, 0, 0, 0, "operation"};
    const std::string done_text =
        std::to_string(supervisor_->header.writer_pid) + ":" + std::to_string(request.id);
    if (const Cell* last = values_.cell(done_key); last && last->text == done_text)
        return answer_text({{"repeated", true}}, {});
    const Result<Json> parsed = parse_request(text);
    if (!parsed) {
        work.fault(parsed.diagnosis());
        return answer_text({}, work.faults);
    }
    const Json& asked = *parsed;
    const bool preview = read_flag(asked, "preview", work);
    if (!work.good()) return answer_text({}, work.faults);
    // What the operation copies or compares must be on disk. A broken file takes nothing: who logs
    // in, asks about it or makes it whole is answered all the same, and what would change a value
    // is refused when it is written.
    const bool broken = disk_ && disk_->condition().broken;
    const auto verb = asked.is_object() ? asked.find("do") : asked.end();
    const bool copies = asked.is_object() && verb != asked.end() && verb->is_string() &&
                        verb->get_ref<const std::string&>().starts_with("backup");
    const bool may_wait = broken && !copies;
    if (const Result<void> kept = may_wait ? Result<void>() : commit_pending({}, "program");
        !kept) {
        work.fault(kept.diagnosis());
        return answer_text({}, work.faults);
    }
    Json answer;
    const auto take_back = [&] {
        for (auto at = work.changes.rbegin(); at != work.changes.rend(); ++at)
            write_value(values_, at->key, at->before, at->text_before, at->is_text);
    };
    // An unexpected fault of an operation: it is not done, and the others are
    // served.
    try {
        answer = run_operation(asked, work);
    } catch (const std::exception& wrong) {
        take_back();
        work.changes.clear();
        work.fault(Alarm::RequestBad, wrong.what());
        return answer_text({}, work.faults);
    }
    if ((!work.good() && !work.keep) || preview) {
        take_back();
        return answer_text(answer, work.faults);
    }
    // A file that is not worked on becomes one that is, with what could be read of it; what is
    // restored comes on top.
    if (work.confirms && disk_ && disk_->condition().broken) {
        if (const Result<void> confirmed = disk_->confirm(); !confirmed) {
            take_back();
            work.fault(confirmed.diagnosis());
            return answer_text({}, work.faults);
        }
    }
    if (!work.changes.empty()) {
        set_text(values_, done_key, done_text, work.changes);
        if (const Result<void> kept = commit_pending(work.changes, work.caller.name); !kept) {
            take_back();
            work.fault(kept.diagnosis());
            return answer_text({}, work.faults);
        }
        refresh_machine(work.changes);
        image_.publish(values_, work.changes);
        push_parameter_changes(work.changes);
        tell_kernel(work.changes, 0);
    }
    for (const auto& act : work.after)
        if (const Result<void> done = act(); !done) work.fault(done.diagnosis());
    if (work.confirms && work.good() && disk_) {
        if (const Result<void> confirmed = disk_->confirm(); !confirmed)
            work.fault(confirmed.diagnosis());
        look_at_condition();
    }
    if (work.good() && std::any_of(work.changes.begin(), work.changes.end(),
                                   [](const Change& c) { return c.key.kind == Kind::Parameter; }))
        if (const auto wrong = check_machine_config(values_.parameters); !wrong.empty())
            answer["warning"] = wrong.front().text();
    return answer_text(answer, work.faults);
}

std::string Service::operate_safely(const std::string& text, const StoreRequest& request) {
    try {
        return operate(text, request);
    } catch (const std::exception& wrong) {
        return answer_text({}, {Fault{Diagnosis{Alarm::RequestBad, {}, {}, wrong.what()}, 0, {}}});
    }
}

// The transaction of whoever died over it may have been finished: an id is done once.
std::string Service::refuse_begun(const StoreRequest& request) {
    operation_.clear();
    const Cell* last = values_.cell({Kind::Setting, 0, 0, 0, "operation"});
    if (last && last->text == std::to_string(supervisor_->header.writer_pid) + ":" +
                                  std::to_string(request.id))
        return answer_text({{"repeated", true}}, {});
    return answer_text(
        {}, {Fault{Diagnosis{Alarm::RequestBad,
                             {},
                             {},
                             "the store died when it read this request; it is not read again"},
                   0,
                   {}}});
}

// Once when the controller has run for a minute, then every PT_BACKUP_EVERY hours.
void Service::back_up_when_due() {
    if (!disk_ || files_.store_folder.empty()) return;
    const auto now = Clock::now();
    if (next_backup_ == Clock::time_point{}) next_backup_ = now + std::chrono::minutes(1);
    const double hours = params::get(values_.parameters, params::pt_backup_every);
    if (hours <= 0 || now < next_backup_) return;
    next_backup_ = now + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double, std::ratio<3600>>(hours));
    const auto keep =
        static_cast<std::size_t>(params::get(values_.parameters, params::pt_backup_keep));
    if (const Result<std::string> made = make_automatic_backup(
            *disk_, files_.store_folder, collect_files(files_.machine_folder, instance_), keep);
        !made)
        std::fprintf(stderr, "polyturn-toolmgmt: %s\n", made.diagnosis().text().c_str());
}

}  // namespace polyturn::toolmgmt
