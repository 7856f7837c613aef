// SIGKILL of the store at random moments: whatever was acknowledged is there afterwards, and
// nothing is half written. Acknowledged is an operator's change whose answer came (ok), and a
// program's write before the index `on_disk`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <tuple>

#include "../unit/toolmgmt/store_rig.hpp"
#include "tests/places.hpp"
#include "tests/seeds.hpp"

namespace {

using namespace polyturn;
using polyturn::test::StoreRig;

const std::string kMachine = std::string(kSourceFolder) + "/examples/machines/twin-turret";

unsigned rounds() {
    const char* chosen = std::getenv("POLYTURN_STORE_KILLS");
    return chosen ? static_cast<unsigned>(std::atoi(chosen)) : 40;
}

// What is known about one cell: its last acknowledged value and everything asked since.
struct Cell {
    double acknowledged = 0.0;
    std::vector<double> asked;
    bool possible(double value) const {
        return value == acknowledged || std::find(asked.begin(), asked.end(), value) != asked.end();
    }
    // values of one cell are asked for and acknowledged in the same order
    void acknowledge(double value) {
        asked.erase(asked.begin(), std::find(asked.begin(), asked.end(), value) + 1);
        acknowledged = value;
    }
};

TEST(StoreKilled, LosesNothingThatWasAcknowledged) {
    StoreRig rig("kill");
    rig.make_kernel();
    const std::vector<std::string> arguments = {"--store", rig.folder + "/store", "--machine",
                                                kMachine};
    std::mt19937 random(test_seed(20'26));
    // wear X of offsets of L1 by operator; #500.. of L2 by program
    std::map<int, Cell> offsets, variables;
    // persist index behind it -> variable, value
    std::map<std::uint64_t, std::pair<int, double>> written;
    // request id -> offset, value; a successor answers what is left
    std::map<std::uint64_t, std::pair<int, double>> open;
    double next = 0.0;
    std::size_t acknowledged = 0;
    for (unsigned round = 0; round < rounds(); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        ASSERT_TRUE(rig.start(arguments)) << rig.messages();
        // What the new process shows now.
        const auto l1 = rig.channel(1), l2 = rig.channel(2);
        for (auto& [number, cell] : offsets) {
            const double value = l1->offsets[static_cast<std::size_t>(number)].wear[0];
            ASSERT_TRUE(cell.possible(value))
                << "offset " << number << ": " << value << ", acknowledged " << cell.acknowledged;
        }
        for (auto& [index, cell] : variables) {
            const double value = l2->variables[static_cast<std::size_t>(index)];
            const double seen = std::isnan(value) ? 0.0 : value;
            ASSERT_TRUE(cell.possible(seen))
                << "variable " << index << ": " << seen << ", acknowledged " << cell.acknowledged;
        }
        const auto until =
            std::chrono::steady_clock::now() + std::chrono::microseconds(random() % 150'000);
        while (std::chrono::steady_clock::now() < until) {
            next += 1.0 / 1024;  // exact in binary and below the wear limit for a long time
            if (random() % 2 && open.size() < 100) {
                const int number = 1 + static_cast<int>(random() % 30);
                const double value = std::fmod(next, 1.0);
                offsets[number].asked.push_back(value);
                open[rig.send(offset_request(1, number, OffsetTable::Wear, OffsetField::X,
                                             value))] = {number, value};
            } else if ((*rig.kernel)->persist.head - (*rig.store)->persist_tail.tail < 4000) {
                const int index = static_cast<int>(random() % 50);
                variables[index].asked.push_back(next);
                written[rig.push(variable_request(2, "#" + std::to_string(500 + index), next))] = {
                    index, next};
            }
            while (const auto answer = rig.take_answer()) {
                const auto found = open.find(answer->id);
                // answered twice: killed between the answer and its tail
                if (found == open.end()) continue;
                ASSERT_EQ(answer->ok, 1u) << answer->text.data();
                offsets[found->second.first].acknowledge(found->second.second);
                open.erase(found);
                ++acknowledged;
            }
            if (random() % 4 == 0) usleep(static_cast<useconds_t>(random() % 300));
        }
        rig.kill_now();
        // Read after the death: what on_disk said last was acknowledged.
        const auto on_disk = (*rig.store)->on_disk.load();
        while (!written.empty() && written.begin()->first <= on_disk) {
            const auto [index, value] = written.begin()->second;
            variables[index].acknowledge(value);
            written.erase(written.begin());
            ++acknowledged;
        }
    }
    EXPECT_GT(acknowledged, 100u);
    RecordProperty("acknowledged", static_cast<int>(acknowledged));
}

// Tools that are set and moved, life that is counted, all at once: what was acknowledged is there
// after each kill, and no two tools ever stand in one place.
TEST(StoreKilled, LosesNothingOfToolsAndLife) {
    using Json = nlohmann::json;
    StoreRig rig("kill-tools");
    rig.make_kernel();
    const std::vector<std::string> arguments = {
        "--store", rig.folder + "/store", "--machine", kMachine, "--set", "N2900=00000001"};
    std::mt19937 random(test_seed(77));
    const auto send = [&](const Json& operation) {
        const std::string text = operation.dump();
        constexpr std::size_t kPiece = sizeof(StoreRequest{}.name) - 1;
        std::uint64_t last = 0;
        for (std::size_t at = 0; at < text.size(); at += kPiece) {
            StoreRequest request =
                store_request(StoreRequestKind::Operation, 0, static_cast<std::int32_t>(at),
                              at + kPiece < text.size() ? kMoreFollows : 0, 0);
            request.level = static_cast<std::uint32_t>(UserLevel::Maker);
            put_name(request, std::string_view(text).substr(at, kPiece));
            last = rig.send(request);
        }
        return last;
    };
    constexpr int kMany = 5;
    std::map<int, Cell> life, pot;
    // request -> is it a move, tool, value
    std::map<std::uint64_t, std::tuple<bool, int, double>> open;
    std::map<std::uint64_t, std::string> pieces;
    double pieces_sent = 0;
    std::uint64_t last_use = 0;
    std::size_t acknowledged = 0;
    // what was asked and answered for the life of each tool since the kill before the last one: a
    // value that is lost shows here how
    std::map<int, std::vector<std::string>> told_of;
    const auto story = [&](int tool) {
        std::string out;
        for (const std::string& line : told_of[tool]) out += "\n  " + line;
        return out;
    };
    const auto note = [&](int tool, const std::string& line) {
        std::vector<std::string>& lines = told_of[tool];
        lines.push_back(line);
        if (lines.size() > 60) lines.erase(lines.begin(), lines.begin() + 20);
    };
    const auto collect = [&] {
        while (const auto answer = rig.take_answer()) {
            const auto found = open.find(answer->id);
            if (found == open.end()) continue;
            pieces[answer->id] += answer->text.data();
            if (answer->more) continue;
            const auto [moves, tool, value] = found->second;
            if (!moves)
                note(tool, std::to_string(answer->id) + " life " + std::to_string(value) + ": " +
                               pieces[answer->id].substr(0, 120));
            const Json told = Json::parse(pieces[answer->id], nullptr, false);
            const bool good = told.is_object() && told.value("ok", false);
            Cell& cell = moves ? pot[tool] : life[tool];
            const auto at = std::find(cell.asked.begin(), cell.asked.end(), value);
            if (good && at != cell.asked.end()) {
                cell.acknowledge(value);
                ++acknowledged;
            } else if (at != cell.asked.end())
                cell.asked.erase(at);  // the place was taken
            open.erase(found);
        }
    };
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    for (int tool = 1; tool <= kMany; ++tool) {
        life[tool].asked.push_back(1000);
        pot[tool].asked.push_back(tool);
        open[send({{"do", "tools.add"},
                   {"tool", tool},
                   {"fields",
                    {{"type", tool},
                     {"life_kind", tool == 5 ? "pieces" : "minutes"},
                     {"life", 1000}}}})] = {false, tool, 1000};
        open[send({{"do", "tools.load"}, {"tool", tool}, {"magazine", 1}, {"pot", tool}})] = {
            true, tool, tool};
    }
    for (int ms = 0; ms < 5000 && !open.empty(); ++ms) {
        collect();
        sleep_ms(1);
    }
    ASSERT_TRUE(open.empty());
    for (unsigned round = 0; round < rounds(); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        const auto until =
            std::chrono::steady_clock::now() + std::chrono::microseconds(random() % 120'000);
        while (std::chrono::steady_clock::now() < until) {
            const int tool = 1 + static_cast<int>(random() % kMany);
            if (random() % 3 == 0) {
                StoreRequest use{};
                use.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolLife);
                use.number = 5;
                use.field = static_cast<std::int32_t>(LifeKind::Pieces);
                use.value = 1;
                use.channel = 1;
                last_use = rig.push(use);
                ++pieces_sent;
            } else if (open.size() < 20) {
                const bool moves = random() % 2;
                const double value = moves ? 1 + static_cast<double>(random() % 12)
                                           : 1000 + static_cast<double>(random() % 100'000);
                (moves ? pot : life)[tool].asked.push_back(value);
                if (!moves) note(tool, "asked for " + std::to_string(value));
                open[moves ? send({{"do", "tools.move"},
                                   {"tool", tool},
                                   {"magazine", 1},
                                   {"pot", value}})
                           : send({{"do", "tools.set"},
                                   {"tool", tool},
                                   {"fields", {{"life", value}}}})] = {moves, tool, value};
            }
            collect();
            usleep(static_cast<useconds_t>(random() % 2000));
        }
        rig.kill_now();
        for (int tool = 1; tool <= kMany; ++tool)
            note(tool, "killed, " + std::to_string(open.size()) + " not answered");
        ASSERT_TRUE(rig.start(arguments)) << rig.messages();
        // the successor answers what was left
        for (int ms = 0; ms < 5000 && !open.empty(); ++ms) {
            collect();
            sleep_ms(1);
        }
        const auto tools = std::make_unique<ToolTable>();
        ASSERT_TRUE((*rig.store)->tools.read(*tools));
        std::set<int> taken;
        for (int tool = 1; tool <= kMany; ++tool) {
            const ToolRow& row = tools->rows[static_cast<std::size_t>(tool - 1)];
            ASSERT_TRUE(row.used);
            EXPECT_TRUE(life[tool].possible(row.life))
                << "tool " << tool << ": " << row.life << ", acknowledged "
                << life[tool].acknowledged << story(tool);
            EXPECT_TRUE(pot[tool].possible(row.pot)) << "tool " << tool << " in pot " << row.pot
                                                     << ", acknowledged " << pot[tool].acknowledged;
            EXPECT_TRUE(taken.insert(row.pot).second) << "two tools in pot " << row.pot;
        }
    }
    ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, last_use));
    const auto tools = std::make_unique<ToolTable>();
    for (int ms = 0; ms < 1000; ++ms, sleep_ms(1))
        if ((*rig.store)->tools.read(*tools) && tools->rows[4].counter == pieces_sent) break;
    EXPECT_EQ(tools->rows[4].counter, pieces_sent);
    EXPECT_GT(acknowledged, 2u * kMany);
}

// The kernel's ring still holds what only the image of the dead store had: the next store takes it
// from there, so that a program loses nothing as long as the kernel lives.
TEST(StoreKilled, AProgramsWritesAreTakenAgainFromTheKernel) {
    StoreRig rig("again");
    rig.make_kernel();
    const std::vector<std::string> arguments = {"--store", rig.folder + "/store", "--machine",
                                                kMachine};
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    std::uint64_t index = 0;
    for (int i = 0; i < 500; ++i)
        index = rig.push(variable_request(1, "#" + std::to_string(500 + i), i));
    ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail, index));
    rig.kill_now();  // most likely before the batch reached the disk
    ASSERT_TRUE(rig.start(arguments)) << rig.messages();
    ASSERT_TRUE(StoreRig::reached((*rig.store)->on_disk, index));
    const auto l1 = rig.channel(1);
    for (int i = 0; i < 500; ++i) EXPECT_EQ(l1->variables[static_cast<std::size_t>(i)], i);
}

// Nobody attaches again when the store is started anew: it goes on in its predecessor's segment,
// also without a disk.
TEST(StoreKilled, ItsSuccessorGoesOnInTheSameSegment) {
    for (const bool memory : {false, true}) {
        StoreRig rig(memory ? "same-memory" : "same-disk");
        rig.make_kernel();
        std::vector<std::string> arguments = {"--machine", kMachine, "--set", "N1600 L2=3"};
        if (memory)
            arguments.push_back("--memory");
        else
            arguments.insert(arguments.end(), {"--store", rig.folder + "/store"});
        ASSERT_TRUE(rig.start(arguments)) << rig.messages();
        auto seen_by_others = PeerSegment<StoreSegment>::attach(rig.instance);
        ASSERT_TRUE(seen_by_others);
        for (int round = 1; round <= 20; ++round) {
            ASSERT_TRUE(
                rig.ask(offset_request(1, 1, OffsetTable::Geometry, OffsetField::X, round)));
            const auto index = rig.push(variable_request(1, "#600", round));
            ASSERT_TRUE(StoreRig::reached((*seen_by_others)->persist_tail.tail, index));
            // answered by whoever lives then
            rig.send(parameter_request("N1600 L1=" + std::to_string(round)));
            rig.kill_now();
            ASSERT_TRUE(rig.start(arguments)) << rig.messages();
            const auto done = rig.push(variable_request(1, "#601", round));
            ASSERT_TRUE(StoreRig::reached((*seen_by_others)->persist_tail.tail, done));
            auto l1 = std::make_unique<ChannelStore>();
            ASSERT_TRUE((*seen_by_others)->channels[0].read(*l1));
            EXPECT_EQ(l1->offsets[1].geometry[0], round);
            EXPECT_EQ(l1->variables[100], round);
            EXPECT_EQ(l1->variables[101], round);
            EXPECT_EQ(rig.value_of("N1600 L1"), std::to_string(round));
            EXPECT_EQ(rig.value_of("N1600 L2"), "3");
            (*rig.kernel)->param_tail.tail.store((*seen_by_others)->param_changes.head.load());
        }
    }
}

// What an earlier controller of the same name left behind is not taken for one's own.
TEST(StoreOfADeadController, IsReplaced) {
    StoreRig rig("stale");
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    ASSERT_TRUE(rig.ask(parameter_request("N1600 L1=7")));
    rig.kill_now();
    // another controller than the one that the dead store served
    rig.supervisor->header.writer_pid = 1;
    rig.supervisor->requests.head = 0;
    rig.supervisor->answer_tail.tail = 0;
    ASSERT_TRUE(rig.start({"--memory", "--machine", kMachine})) << rig.messages();
    EXPECT_EQ(rig.value_of("N1600 L1"), "2");
    EXPECT_EQ((*rig.store)->param_changes.head.load(), 0u);
}

// A new kernel begins a new ring: what the dead one pushed last still counts, and the new one is
// served from its start.
TEST(StoreOfADeadKernel, FinishesItsRingAndServesTheNextOne) {
    StoreRig rig("kernel");
    rig.make_kernel();
    ASSERT_TRUE(rig.start({"--store", rig.folder + "/store", "--machine", kMachine}))
        << rig.messages();
    ASSERT_TRUE(StoreRig::reached((*rig.store)->persist_tail.tail,
                                  rig.push(variable_request(1, "#500", 1))));
    // The next kernel under the same name; its pid differs, as the supervisor's table says.
    auto fresh = OwnSegment<KernelSegment>::create(rig.instance, 2);
    ASSERT_TRUE(fresh);
    (*fresh)->header.writer_pid = getpid() + 1;
    fresh->publish();
    rig.push(variable_request(1, "#501", 2));  // the old one's last words
    rig.supervisor->processes[kProcessKernel].pid = getpid() + 1;
    rig.kernel.emplace(std::move(*fresh));
    rig.push(variable_request(1, "#502", 3));
    for (int ms = 0; ms < 5000 && rig.channel(1)->variables[2] != 3; ++ms) sleep_ms(1);
    const auto l1 = rig.channel(1);
    EXPECT_EQ(l1->variables[0], 1);
    EXPECT_EQ(l1->variables[1], 2);
    EXPECT_EQ(l1->variables[2], 3);
    EXPECT_TRUE(StoreRig::reached((*rig.store)->on_disk, 1));
    EXPECT_EQ((*rig.store)->persist_tail.tail.load(), 1u);
}

}  // namespace
