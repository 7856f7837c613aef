// A program or a job is selected. Its files are read by a worker, then the machine must be ready
// for it, then it is sent; what the job has otherwise than this controller is looked up behind
// that, by a worker again, and reported with the answer. What the same program on the socket asks
// behind it waits for that answer: no start gets in front of its program.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/model/machine/store/job_differences.hpp"
#include "kernel/supervisor/base/reach.hpp"
#include "kernel/supervisor/base/refusal.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/press/press_words.hpp"
#include "kernel/supervisor/start/start_session.hpp"

namespace polyturn::supervisor {

namespace {

constexpr auto kResetSeen = std::chrono::milliseconds(200);  // some ticks, and one that is late
constexpr auto kRoom = std::chrono::seconds(5);

using Stores = std::map<unsigned, std::unique_ptr<ChannelStore>>;

// What a job has otherwise than this controller, which goes on with its own.
std::vector<std::string> differences(const text::Job& job, const std::string& params_file,
                                     const MachineConfig& machine, const Stores& stores) {
    std::vector<std::string> out;
    const std::string base =
        std::filesystem::absolute(std::filesystem::path(params_file).replace_extension()).string();
    if (for_another_machine(job, base))
        out.push_back(fmt::format(
            fmt::runtime(say("the job is for the machine {}, and this controller runs {}")),
            job.machine, params_file));
    text::Setup setup;
    if (!job.setup.empty()) {
        auto read = text::load_setup(job.setup);
        if (read)
            setup = std::move(*read);
        else
            out.push_back(text_in(read.diagnosis(), display_language_now()));
    }
    const StoreOf store_of = [&](unsigned channel) -> const ChannelStore* {
        const auto found = stores.find(channel);
        return found == stores.end() ? nullptr : found->second.get();
    };
    for (const JobZero& zero : job_zeros(job, setup, machine, store_of)) {
        if (zero.same()) continue;
        const std::string what = fmt::format("L{} {} {}", zero.channel, zero.system, zero.axis);
        out.push_back(
            std::isnan(zero.entered)
                ? fmt::format(fmt::runtime(
                                  say("the job has {} = {:.4f}, which this machine does not have")),
                              what, zero.wanted)
                : fmt::format(fmt::runtime(say(
                                  "the job has {} = {:.4f}, entered is {:.4f}, and that holds")),
                              what, zero.wanted, zero.entered));
    }
    std::map<unsigned, std::string> others;  // the screens' sheet and `status` show the numbers
    for (const JobOffset& one : job_offsets(setup, machine, store_of))
        if (!one.same())
            others[one.channel] +=
                (others[one.channel].empty() ? "" : ", ") + std::to_string(one.number);
    for (const auto& [channel, numbers] : others)
        out.push_back(fmt::format(
            fmt::runtime(
                say("L{}: other offsets than in the job's setup are entered, and those hold: {}")),
            channel, numbers));
    return out;
}

struct Read {
    Result<std::vector<Command>> commands;
    std::optional<text::Job> job;
};

// The file that is named, and those that a job names. Asked before anything of them is reported.
Result<void> in_reach(const Reach& reach, const std::string& named, UserLevel level) {
    if (named.empty()) return {};
    if (auto good = reach.may_read(named, level); !good || !text::is_job_file(named)) return good;
    const auto job = text::load_job(named);
    if (!job) return {};  // reported where it is carried out
    for (const auto& [channel, program] : job->programs)
        if (auto good = reach.may_read(program.file, level); !good) return good;
    return job->setup.empty() ? Result<void>() : reach.may_read(job->setup, level);
}

}  // namespace

StartSession::Taken StartSession::select(RequestServer::Client client, const Request& request,
                                         const Who& who) {
    // before any file is looked at
    if (!may(client, who, UserLevel::Operator, "press")) return Taken::Yes;
    // PT_PROGRAM_FOLDERS may have changed since the start
    auto table = std::make_shared<params::Table>();
    if (!controller_->store().parameters.read(*table)) *table = *loaded_.table;
    const std::string own_folder =
        std::filesystem::path(loaded_.params_file).parent_path().string();
    const bool offered = workers_.offer([this, client, who, words = request.words,
                                         folder = request.folder, machine = shared_machine_, table,
                                         own_folder]() -> Workers::Done {
        if (const auto reached =
                in_reach(reach_of(*table, own_folder), selected_file(words, folder), who.level);
            !reached)
            return
                [this, client, why = reached.diagnosis()] { server_.answer(client, refusal(why)); };
        auto read = std::make_shared<Read>(
            Read{parse_press(words, *machine, folder), selected_job(words, folder)});
        return [this, client, who, read] {
            if (!read->commands) return server_.answer(client, refusal(read->commands.diagnosis()));
            selections_.push_back({client, who, std::move(*read->commands), std::move(read->job),
                                   std::chrono::steady_clock::now() + kResetSeen, false});
        };
    });
    return offered ? Taken::Holds : Taken::Later;
}

void StartSession::move_selections() {
    const auto now = std::chrono::steady_clock::now();
    std::erase_if(selections_, [&](Selection& one) {
        const auto over = [&](const std::string& answer) {
            server_.answer(one.client, answer);
            return true;
        };
        if (!one.sent) {
            // Refused before anything of it is kept: the parts wanted and the language would be
            // those of the program that runs.
            const bool meets_a_program =
                std::any_of(one.commands.begin(), one.commands.end(), [&](const Command& command) {
                    return command.kind == static_cast<std::uint32_t>(CommandKind::Select) &&
                           runs(command.channel);
                });
            if (meets_a_program)
                return now < one.until
                           ? false
                           : over(refusal(
                                 {Alarm::NotReady,
                                  {},
                                  {},
                                  "another program is selected only in reset or after the end"}));
            if (!may_send(one.client, one.commands, one.who)) return true;
            if (!controller_->try_send(one.commands, false))
                return now < one.until + kRoom
                           ? false
                           : over(refusal(
                                 {Alarm::NotServed, {}, {}, "the kernel takes no commands"}));
            one.sent = true;
            for (const Command& command : one.commands)
                if (command.kind == static_cast<std::uint32_t>(CommandKind::Select))
                    job_language_[command.channel - 1] = static_cast<Dialect>(command.value);
            if (!one.job) return over(R"({"ok":true})");
            if (auto lines = parts_wanted(*one.job); !lines.empty()) {
                Errand wanted;
                wanted.lines = std::move(lines);
                (void)errand(0, std::move(wanted), one.who);
            }
        }
        auto stores = std::make_shared<Stores>();
        for (unsigned channel = 1; channel <= kMaxChannels; ++channel) {
            auto store = std::make_unique<ChannelStore>();
            if (machine_.channel(channel).exists() &&
                controller_->store().channels[channel - 1].read(*store))
                (*stores)[channel] = std::move(store);
        }
        return workers_.offer([this, client = one.client, job = *one.job,
                               file = loaded_.params_file, machine = shared_machine_,
                               stores]() -> Workers::Done {
            const auto told = differences(job, file, *machine, *stores);
            std::string answer =
                told.empty() ? std::string(R"({"ok":true})")
                             : nlohmann::json{{"ok", true}, {"notes", told}}.dump(
                                   -1, ' ', false, nlohmann::json::error_handler_t::replace);
            return [this, client, answer = std::move(answer)] { server_.answer(client, answer); };
        });
    });
}

}  // namespace polyturn::supervisor
