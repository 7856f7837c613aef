// The running store: takes requests of operator (through the supervisor) and programs (through the
// kernel), brings them to the image and to the disk.
//
//   operator   checked -> on disk -> image -> answer. Refused by the disk: nothing changed, and the
//              answer says so.
//   program    image at once, in path order -> the disk within kBatchMs, several in one
//              transaction.
//
// One thread does both. A disk that takes long to sync delays the next image, never the kernel in
// real time, for it does not wait for the store; in virtual time the kernel waits for persist_tail,
// which moves only after the image is out.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ipc/image/segments.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "toolmgmt/apply_request.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/store_image.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

class LoginLimit;

class Service {
public:
    static constexpr std::chrono::milliseconds kBatchMs{40};  // architecture 9 allows 100
    static constexpr std::chrono::milliseconds kIdle{2000};   // then the log is folded in

    // disk: nullptr keeps nothing. `values` are already what the image is to show.
    struct Files {
        std::string machine_folder;  // what a backup takes along; empty: none
        std::string store_folder;    // for automatic backups
    };
    Service(std::string instance, PeerSegment<SupervisorSegment> supervisor, StoreImage image,
            StoreValues& values, Database* disk, Files files);

    ~Service();

    // Looks once for work and does it; false when there was none.
    bool step();
    // Sleeps until there may be work again.
    void wait();
    // Everything that is still pending goes to the disk.
    void finish();

private:
    using Clock = std::chrono::steady_clock;

    void look_for_kernel();
    void replay();
    bool take_persist();
    bool take_requests();
    Result<Applied> apply_operator(const StoreRequest& request);
    bool answer_tool_call(const StoreRequest& request);
    std::string operate(const std::string& text, const StoreRequest& request);
    std::string user_name(const StoreRequest& request) const;
    void send_answers();
    void tell_kernel(const std::vector<Change>& changes, std::uint64_t request);
    void tell_not_kept(const Diagnosis& why);  // on stderr, and a message to the operator
    void back_up_when_due();
    // without any, and without ever any, everybody whom the socket lets in may do everything
    bool has_users() const;
    // to the kernel: data were lost, or all is well again
    void tell_condition();
    void fold_when_idle();
    void look_at_condition();  // the disk's has changed
    // The request at the tail was begun by a predecessor that died of it, or while it worked on it.
    unsigned begun_before(std::uint64_t id);
    void answer_what_was_begun();
    void push_answer(std::uint64_t id, std::string_view text);
    void mark_begun(std::uint64_t id, unsigned times);
    std::string operate_safely(const std::string& text, const StoreRequest& request);
    // in the file: how far the kernel's ring is on disk
    std::string mark() const;
    void answer(const StoreRequest& request, const Result<Applied>& applied);
    void push_parameter_changes(const std::vector<Change>& changes);
    void keep_pending(const std::vector<Change>& changes);
    Result<void> commit_pending(const std::vector<Change>& more, std::string_view who);
    void undo(const std::vector<Change>& changes);
    void refresh_machine(const std::vector<Change>& changes);

    std::string instance_;
    PeerSegment<SupervisorSegment> supervisor_;
    PeerSegment<KernelSegment> kernel_;
    StoreImage image_;
    StoreValues& values_;
    Database* disk_;
    MachineConfig machine_;
    std::uint64_t import_id_ = 0;
    std::vector<StoreRequest> import_;  // lines of an import whose end has not come yet
    std::map<Key, Change> pending_;     // in the image, not yet on disk
    std::uint64_t pending_index_ = 0;   // persist requests before it are in the image
    // from here to the tail they were in the image of a dead predecessor only
    std::uint64_t replay_from_ = 0;
    Clock::time_point pending_since_{}, next_try_{};
    std::uint32_t supervisor_seen_ = 0, kernel_seen_ = 0;
    Files files_;
    std::unique_ptr<ToolPlaceTable> places_;
    std::string operation_;  // pieces of one whose end has not come yet
    // why nothing that programs write reaches the disk; empty: it does
    std::string disk_refuses_;
    std::deque<StoreAnswer> out_;  // answers for which there is no room yet
    Clock::time_point next_backup_{}, quiet_since_{};
    bool unfit_ = false, told_ = true;  // reported: the kernel knows
    std::string unfit_text_;
    std::unique_ptr<LoginLimit> logins_;
    std::string refuse_begun(const StoreRequest& request);
};

}  // namespace polyturn::toolmgmt
