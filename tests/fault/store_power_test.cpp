// Power cuts: what was acknowledged is in every state that the disk could be left in. The judge
// shares nothing with the store but SQLite's reader: file_recorder.cpp writes down what the real
// process does to its files, this plays it on disks that keep of what no fsync has covered nothing,
// all or any part of it, by sectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "../unit/toolmgmt/store_rig.hpp"
#include "file_record.hpp"
#include "tests/places.hpp"
#include "tests/seeds.hpp"
#include "toolmgmt/database.hpp"

namespace {

using namespace polyturn;
using polyturn::test::FileRecord;
using polyturn::test::StoreRig;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string kMachine = std::string(kSourceFolder) + "/examples/machines/twin-turret";

// A disk that forgets: what is durable, and what has only been asked for.
class Disk {
public:
    void play(const FileRecord& head, const std::string& path, const std::string& bytes) {
        const std::string folder = fs::path(path).parent_path();
        switch (head.kind) {
            case FileRecord::Create:
                if (!now_.contains(path)) {
                    now_[path] = fresh();
                    pending_.push_back({folder, FileRecord::Create, path, {}, now_[path]});
                }
                return;
            case FileRecord::Write:
                file(path).open.push_back({false, head.at, bytes});
                return;
            case FileRecord::Truncate:
                file(path).open.push_back({true, head.at, {}});
                return;
            case FileRecord::Unlink:
                now_.erase(path);
                pending_.push_back({folder, FileRecord::Unlink, path, {}, 0});
                return;
            case FileRecord::Rename:
                now_[bytes] = now_[path];
                now_.erase(path);
                pending_.push_back({folder, FileRecord::Rename, path, bytes, 0});
                return;
            case FileRecord::Sync:
                break;
        }
        if (now_.contains(path)) {
            File& one = file(path);
            for (const Change& change : one.open) apply(one.durable, change);
            one.open.clear();
            return;
        }
        for (const Name& name : pending_)  // a folder: its names
            if (name.folder == path) apply(names_, name);
        std::erase_if(pending_, [&](const Name& name) { return name.folder == path; });
    }
    // What a power cut leaves; `keeps`: of what is open, out of 100.
    void leave(const std::string& root, const std::string& into, unsigned keeps,
               std::mt19937& random) const {
        auto names = names_;
        for (const Name& name : pending_) {  // names come in order
            if (random() % 100 >= keeps) break;
            apply(names, name);
        }
        for (const auto& [path, id] : names) {
            const File& from = files_.at(id);
            std::string content = from.durable;
            for (const Change& change : from.open) {
                if (change.cut) {
                    if (random() % 100 < keeps) apply(content, change);
                    continue;
                }
                for (std::size_t at = 0; at < change.bytes.size(); at += 512)
                    if (random() % 100 < keeps)
                        apply(content, {false, change.at + at, change.bytes.substr(at, 512)});
            }
            const fs::path to = into + path.substr(root.size());
            fs::create_directories(to.parent_path());
            std::ofstream(to, std::ios::binary) << content;
        }
    }

private:
    struct Change {
        bool cut;
        std::uint64_t at;
        std::string bytes;
    };
    struct File {
        std::string durable;
        std::vector<Change> open;
    };
    struct Name {
        std::string folder;
        FileRecord::Kind kind;
        std::string path, to;
        int id;
    };
    int fresh() {
        files_[++last_];
        return last_;
    }
    File& file(const std::string& path) {
        // was there before the record began
        if (!now_.contains(path)) {
            now_[path] = fresh();
            names_[path] = now_[path];
        }
        return files_[now_[path]];
    }
    static void apply(std::string& content, const Change& change) {
        if (change.cut) return content.resize(change.at);
        if (content.size() < change.at + change.bytes.size())
            content.resize(change.at + change.bytes.size());
        content.replace(change.at, change.bytes.size(), change.bytes);
    }
    static void apply(std::map<std::string, int>& names, const Name& name) {
        if (name.kind == FileRecord::Create)
            names[name.path] = name.id;
        else if (name.kind == FileRecord::Unlink)
            names.erase(name.path);
        else if (const auto at = names.find(name.path); at != names.end()) {
            names[name.to] = at->second;
            names.erase(name.path);
        }
    }
    std::map<std::string, int> now_, names_;  // as processes see them; on the disk
    std::map<int, File> files_;
    std::vector<Name> pending_;
    int last_ = 0;
};

struct Acknowledged {
    std::uint64_t moment;  // length of the record when the answer was there
    int offset;
    double value;
};

class PowerCuts : public ::testing::Test {
protected:
    PowerCuts() : rig("power") { record = rig.folder + "/record"; }
    bool start(int kill_at, int kill_at_write = 0) {
        setenv("LD_PRELOAD", POLYTURN_FILE_RECORDER, 1);
        setenv("ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0", 1);
        setenv("POLYTURN_RECORD", record.c_str(), 1);
        setenv("POLYTURN_RECORD_ROOT", (rig.folder + "/store").c_str(), 1);
        if (kill_at > 0) setenv("POLYTURN_RECORD_KILL", std::to_string(kill_at).c_str(), 1);
        if (kill_at_write > 0)
            setenv("POLYTURN_RECORD_KILL_WRITE", std::to_string(kill_at_write).c_str(), 1);
        const bool good = rig.start({"--store", rig.folder + "/store", "--machine", kMachine});
        for (const char* name :
             {"LD_PRELOAD", "POLYTURN_RECORD", "POLYTURN_RECORD_ROOT", "POLYTURN_RECORD_KILL",
              "POLYTURN_RECORD_KILL_WRITE", "ASAN_OPTIONS"})
            unsetenv(name);
        return good;
    }
    std::uint64_t recorded() const {
        std::error_code none;
        const auto size = fs::file_size(record, none);
        return none ? 0 : size;
    }
    std::uint64_t ask(int offset, double value) {
        const std::string text = Json{{"do", "offsets.set"}, {"channel", 1}, {"number", offset},
                                      {"table", "geometry"}, {"field", "X"}, {"value", value}}
                                     .dump();
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
    }
    // The whole answer to `id`; nothing when the process ends first.
    std::optional<Json> answer(std::uint64_t id) {
        std::string text;
        for (int i = 0; i < 100'000; ++i) {
            while (const auto piece = rig.take_answer()) {
                if (piece->id != id) continue;
                text += piece->text.data();
                if (!piece->more) return Json::parse(text, nullptr, false);
            }
            if (rig.ended()) return {};
            usleep(100);
        }
        return {};
    }

    StoreRig rig;
    std::string record;
    std::mt19937 random{static_cast<std::mt19937::result_type>(test_seed(2026))};
};

TEST_F(PowerCuts, LeaveWhatWasAcknowledgedAlsoByAStoreThatHasJustRecovered) {
    std::vector<Acknowledged> acknowledged_values;
    double value = 0;
    int repeated = 0, refused = 0;
    ASSERT_TRUE(start(0)) << rig.messages();
    const auto begun = recorded();
    for (int round = 0; round < 24; ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        rig.kill_now();
        // killed while it started
        if (!(round % 2 ? start(1 + static_cast<int>(random() % 24))
                        : start(0, 1 + static_cast<int>(random() % 60)))) {
            ASSERT_TRUE(start(0)) << rig.messages();
        }
        std::uint64_t id = 0;
        int offset = 0;
        const auto take = [&](const Json& told) {
            if (told.value("ok", false)) {
                acknowledged_values.push_back({recorded(), offset, value});
                repeated += told.value("repeated", false);
            } else {
                EXPECT_EQ(told.value("number", ""), "PT0335") << told.dump();
                ++refused;
            }
        };
        for (int i = 0; i < 8 && !rig.ended(); ++i) {
            offset = 1 + static_cast<int>(random() % 20);
            value += 0.001;
            id = ask(offset, value);
            const auto told = answer(id);
            if (!told) break;
            take(*told);
            id = 0;
        }
        if (id == 0) continue;
        ASSERT_TRUE(start(0)) << rig.messages();  // answers what its predecessor left
        const auto told = answer(id);
        ASSERT_TRUE(told) << "the request was lost with its reader";
        take(*told);
        EXPECT_EQ(rig.messages().find("PT04"), std::string::npos) << rig.messages();
    }
    rig.kill_now();
    ASSERT_GT(acknowledged_values.size(), 50u);
    EXPECT_GT(repeated, 0) << "no store answered for its predecessor";
    RecordProperty("refused", refused);

    // Each moment behind an answer, and as many others.
    std::vector<std::uint64_t> moments;
    for (const Acknowledged& one : acknowledged_values) moments.push_back(one.moment);
    for (int i = 0; i < 60; ++i) moments.push_back(begun + random() % (recorded() - begun));
    std::sort(moments.begin(), moments.end());
    std::ifstream in(record, std::ios::binary);
    const std::string all(std::istreambuf_iterator<char>(in), {});
    const std::string root = rig.folder + "/store", copy = rig.folder + "/copy";
    Disk disk;
    std::size_t at = 0, next = 0, states = 0;
    int lost = 0, alarms = 0;
    for (const std::uint64_t moment : moments) {
        while (at + sizeof(FileRecord) <= all.size() && at < moment) {
            FileRecord head{};
            std::memcpy(&head, all.data() + at, sizeof head);
            disk.play(head, all.substr(at + sizeof head, head.path_size),
                      all.substr(at + sizeof head + head.path_size, head.size));
            at += sizeof head + head.path_size + head.size;
        }
        std::map<int, double> known;
        for (next = 0;
             next < acknowledged_values.size() && acknowledged_values[next].moment <= moment;
             ++next)
            known[acknowledged_values[next].offset] = acknowledged_values[next].value;
        for (const unsigned keeps : {0u, 50u, 95u}) {
            fs::remove_all(copy);
            disk.leave(root, copy, keeps, random);
            auto store = toolmgmt::Database::open(copy);
            ASSERT_TRUE(store) << store.diagnosis().text();
            auto values = std::make_unique<toolmgmt::StoreValues>();
            toolmgmt::clear(*values);
            std::vector<Diagnosis> warnings;
            ASSERT_TRUE(store->read_into(*values, warnings));
            ++states;
            for (const auto& [offset, acknowledged] : known)
                if (values->channels[0].offsets[static_cast<std::size_t>(offset)].geometry[0] <
                    acknowledged)
                    ++lost;
            if (store->condition().unfit && ++alarms == 1)
                ADD_FAILURE() << "false alarm: " << store->condition().unfit->text() << ", keeps "
                              << keeps;
        }
    }
    EXPECT_EQ(lost, 0) << "of " << acknowledged_values.size() << " acknowledged values in "
                       << states << " states";
    EXPECT_EQ(alarms, 0) << "of " << states << " states";
    RecordProperty("states", static_cast<int>(states));
}

}  // namespace
