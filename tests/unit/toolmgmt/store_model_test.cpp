// Random requests against a plain std::map, with the file reopened in between; and files that end
// in the middle of a write.
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "ipc/model/machine/load_machine.hpp"
#include "tests/places.hpp"
#include "tests/property.hpp"
#include "toolmgmt/apply_request.hpp"
#include "toolmgmt/database.hpp"

namespace {

using namespace polyturn;
using namespace polyturn::toolmgmt;
namespace fs = std::filesystem;

struct Folder {
    explicit Folder(const std::string& name)
        : path(fs::temp_directory_path() / ("polyturn-" + name + "-" + std::to_string(getpid()))) {
        fs::remove_all(path);
    }
    ~Folder() {
        std::error_code none;
        fs::remove_all(path, none);
    }
    fs::path path;
};

const params::Table& machine_table() {
    static const LoadedMachine loaded =
        load_machine_file(std::string(kSourceFolder) + "/examples/machines/twin-turret");
    return *loaded.table;
}

std::unique_ptr<StoreValues> fresh_values() {
    auto values = std::make_unique<StoreValues>();
    clear(*values);
    values->parameters = machine_table();
    return values;
}

using Model = std::map<Key, double>;

// A request that is right, and what the model must hold after it.
StoreRequest random_request(Model& model) {
    const auto channel = *rc::gen::inRange(1, 3);
    const double value = *rc::gen::element(0.0, -0.0, 1.0, -2.5, 0.1, 1e-300, 123456.789,
                                           *rc::gen::arbitrary<double>());
    const double finite = std::isfinite(value) ? value + 0.0 : 7.0;  // -0 is stored as 0
    switch (*rc::gen::inRange(0, 6)) {
        case 0: {
            const auto number = *rc::gen::inRange(1, 33);
            const auto field = static_cast<OffsetField>(*rc::gen::inRange(0, 4));
            model[{Kind::Offset, channel, number, static_cast<int>(field), {}}] = finite;
            return offset_request(static_cast<unsigned>(channel), number, OffsetTable::Geometry,
                                  field, finite);
        }
        case 1: {
            const auto number = *rc::gen::inRange(1, 33);
            model[{Kind::Offset, channel, number, 256 + 2, {}}] = finite;
            return offset_request(static_cast<unsigned>(channel), number, OffsetTable::Wear,
                                  OffsetField::Z, finite);
        }
        case 2: {
            const auto row = *rc::gen::inRange(0, static_cast<int>(kWorkZeros)),
                       place = *rc::gen::inRange(0, 3);
            model[{Kind::WorkZero, channel, row, place, {}}] = finite;
            return work_zero_request(static_cast<unsigned>(channel), row, place, finite);
        }
        case 3: {
            const auto index = *rc::gen::inRange(0, 500);
            const double or_empty = *rc::gen::element(finite, std::nan(""));
            model[{Kind::Variable, channel, index, 0, {}}] = or_empty;
            return variable_request(static_cast<unsigned>(channel),
                                    "#" + std::to_string(500 + index), or_empty);
        }
        case 4: {
            const auto axis = *rc::gen::inRange(1, 97);
            model[{Kind::Position, axis, 0, 0, {}}] = finite;
            return store_request(StoreRequestKind::LastPosition, 0, axis, 0, finite);
        }
        default: {
            const int cut = *rc::gen::inRange(0, 1000);
            model[{Kind::Parameter, channel, 0, 0, "N1600"}] = cut;
            return parameter_request("N1600 L" + std::to_string(channel) + "=" +
                                     std::to_string(cut));
        }
    }
}

bool same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void compare(const Model& model, StoreValues& values) {
    for (const auto& [key, expected] : model) {
        const double* at = number_at(values, key);
        RC_ASSERT(at != nullptr);
        if (!same(*at, expected))
            RC_FAIL(describe(key) + " is " + std::to_string(*at) + ", should be " +
                    std::to_string(expected));
    }
}

TEST(StoreModel, HoldsExactlyWhatAMapHoldsAfterEveryReopening) {
    const bool good = holds("requests and reopenings", [] {
        const Folder folder("model");
        const MachineConfig machine = derive_machine_config(machine_table());
        Model model;
        for (int opening = *rc::gen::inRange(1, 4); opening > 0; --opening) {
            auto disk = Database::open(folder.path);
            RC_ASSERT(disk.ok());
            auto values = fresh_values();
            std::vector<Diagnosis> warnings;
            RC_ASSERT(disk->read_into(*values, warnings).ok());
            RC_ASSERT(warnings.empty());
            compare(model, *values);
            for (int batch = *rc::gen::inRange(0, 6); batch > 0; --batch) {
                std::vector<Change> changes;
                std::map<Key, Change> merged;
                for (int count = *rc::gen::inRange(0, 12); count > 0; --count) {
                    const auto applied =
                        apply_request(random_request(model), Origin::Program, machine, *values);
                    RC_ASSERT(applied.ok());
                    for (const Change& change : applied->changes) merged[change.key] = change;
                }
                for (const auto& [key, change] : merged) changes.push_back(change);
                RC_ASSERT(disk->commit(changes, "test").ok());
            }
            compare(model, *values);
        }
    });
    EXPECT_TRUE(good);
}

TEST(StoreModel, NeverTakesWhatARequestOfRandomBytesAsksUnlessItIsWhole) {
    const MachineConfig machine = derive_machine_config(machine_table());
    auto values = fresh_values();
    std::mt19937_64 random(test_seed(5));
    for (int i = 0; i < 20'000; ++i) {
        StoreRequest request{};
        request.kind = static_cast<std::uint32_t>(random() % 12);
        request.channel = static_cast<std::uint32_t>(random() % 4 ? random() % 20 : random());
        request.number = static_cast<std::int32_t>(random() % 4 ? random() % 1200 : random());
        request.field = static_cast<std::int32_t>(random() % 4 ? random() % 800 : random());
        request.value = std::bit_cast<double>(random());
        if (random() % 2)
            for (char& byte : request.name) byte = static_cast<char>(random());
        const auto origin = random() % 2 ? Origin::Operator : Origin::Program;
        const auto applied = apply_request(request, origin, machine, *values);
        if (applied) continue;
        EXPECT_FALSE(applied.diagnosis().text().empty());
    }
    for (const ChannelStore& store : values->channels) {
        EXPECT_EQ(store.offsets[0].geometry[0], 0.0);  // number 0 stays zero
        for (const OffsetCell& cell : store.offsets)
            EXPECT_TRUE(std::isfinite(cell.geometry[0]) && std::isfinite(cell.wear[2]));
        for (const double zero : store.zeros) EXPECT_TRUE(std::isfinite(zero));
    }
}

// A computer that loses power tears the last writes of the log. Every file that can be left behind
// opens with the values of some commit, never with half of one: #500 and #501 are always written
// together and must be equal.
TEST(StoreTorn, OpensWithWholeCommitsOnly) {
    const Folder origin("torn"), copy("torn-copy");
    const MachineConfig machine = derive_machine_config(machine_table());
    constexpr int kCommits = 60;
    auto disk = Database::open(origin.path);
    ASSERT_TRUE(disk);
    auto values = fresh_values();
    for (int i = 1; i <= kCommits; ++i) {
        std::vector<Change> changes;
        for (const char* name : {"#500", "#501"}) {
            const auto applied =
                apply_request(variable_request(1, name, i), Origin::Program, machine, *values);
            ASSERT_TRUE(applied);
            changes.push_back(applied->changes.at(0));
        }
        ASSERT_TRUE(disk->commit(changes, "test"));
    }
    // The file as it lies there while the store still runs: base and log.
    const fs::path base = origin.path / Database::kFile, log = fs::path(base.string() + "-wal");
    ASSERT_TRUE(fs::exists(log));
    const auto size = fs::file_size(log);
    std::mt19937_64 random(test_seed(17));
    int newest = 0, oldest = kCommits;
    for (int i = 0; i < 150; ++i) {
        fs::remove_all(copy.path);
        fs::create_directories(copy.path);
        fs::copy_file(base, copy.path / Database::kFile);
        const fs::path torn = copy.path / log.filename();
        fs::copy_file(log, torn);
        const auto cut = i == 0 ? size : random() % (size + 1);
        if (i % 3 == 0) {
            fs::resize_file(torn, cut);  // never arrived
        } else {
            std::fstream file(torn, std::ios::in | std::ios::out | std::ios::binary);
            // arrived as something else, as a sector or as a bit
            file.seekp(static_cast<std::streamoff>(cut));
            for (std::uint64_t left = i % 3 == 1 ? std::min<std::uint64_t>(512, size - cut)
                                                 : (cut < size);
                 left > 0; --left)
                file.put(static_cast<char>(random()));
        }
        auto opened = Database::open(copy.path);
        ASSERT_TRUE(opened) << opened.diagnosis().text();
        auto found = fresh_values();
        std::vector<Diagnosis> warnings;
        ASSERT_TRUE(opened->read_into(*found, warnings));
        const double first = found->channels[0].variables[0],
                     second = found->channels[0].variables[1];
        ASSERT_TRUE(same(first, second)) << first << " and " << second << ", torn at " << cut;
        const int value = std::isnan(first) ? 0 : static_cast<int>(first);
        newest = std::max(newest, value);
        oldest = std::min(oldest, value);
    }
    EXPECT_EQ(newest, kCommits);      // nothing torn: nothing lost
    EXPECT_LT(oldest, kCommits / 2);  // and the test did tear
}

TEST(StoreHistory, SaysWhenWhoWhatOldAndNew) {
    const Folder folder("history");
    const MachineConfig machine = derive_machine_config(machine_table());
    auto disk = Database::open(folder.path);
    ASSERT_TRUE(disk);
    auto values = fresh_values();
    const StoreRequest requests[] = {parameter_request("N0304 A3=12000"),
                                     parameter_request("N0003 L1=Top"),
                                     offset_request(1, 3, OffsetTable::Wear, OffsetField::X, 0.25),
                                     variable_request(2, "#512", 1.5),
                                     variable_request(2, "#512", std::nan("")),
                                     work_zero_request(1, 13, 1, -4)};
    for (const StoreRequest& request : requests) {
        const auto applied = apply_request(request, Origin::Operator, machine, *values);
        ASSERT_TRUE(applied);
        ASSERT_TRUE(disk->commit(applied->changes, "operator"));
    }
    const auto lines = disk->history(10);
    ASSERT_TRUE(lines);
    const char* const kExpected[] = {"L1 G54.1P3 place 2: 0 -> -4", "L2 #512: 1.5 -> empty",
                                     "L2 #512: empty -> 1.5",       "L1 offset 3 wear X: 0 -> 0.25",
                                     "N0003 L1: Upper -> Top",      "N0304 A3: 20000 -> 12000"};
    ASSERT_EQ(lines->size(), std::size(kExpected));
    for (std::size_t i = 0; i < std::size(kExpected); ++i) {
        const std::string& line = (*lines)[i];
        EXPECT_EQ(line.substr(25), std::string("operator ") + kExpected[i]);
        EXPECT_EQ(line[10], 'T');
        EXPECT_EQ(line[23], 'Z');
    }
}

}  // namespace
