// libs: polyturn_toolmgmt GTest::gtest
//
// The store's figures (issue 6): a T call among 1000 tools under 200 us; an offset change on disk
// under 10 ms; 10 000 life updates a second; a start with 1000 tools and a million lines of history
// under 1 s.
#include <benchmark/benchmark.h>
#include <sqlite3.h>

#include <filesystem>
#include <memory>

#include "../unit/toolmgmt/store_rig.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/params/param_file.hpp"
#include "tests/places.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/tools/places.hpp"
#include "toolmgmt/tools/search.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

namespace fs = std::filesystem;

struct Shop {
    std::unique_ptr<StoreValues> values = std::make_unique<StoreValues>();
    std::unique_ptr<ToolPlaceTable> places = std::make_unique<ToolPlaceTable>();
    std::vector<Change> changes;
    Shop() {
        clear(*values);
        values->parameters = *load_machine_file({}).table;
        for (const char* line : {"N2900=00000001", "N2902=1000", "PT_TURRET_MAGAZINE L1=0",
                                 "N2910=1000", "N2901 L1=00000100"}) {
            const auto assignment = params::parse_assignment(line);
            if (assignment) params::apply(values->parameters, {&*assignment, 1}).ok();
        }
        for (std::int32_t n = 1; n <= 1000; ++n) {
            set_tool_number(*values, n, "exists", 1, changes);
            set_tool_number(*values, n, "type", 1 + n / 4, changes);
            set_tool_number(*values, n, "life_kind", 1, changes);
            set_tool_number(*values, n, "life", 60, changes);
            set_tool_number(*values, n, "counter", n % 50, changes);
            set_tool_number(*values, n, "magazine", 1, changes);
            set_tool_number(*values, n, "pot", n, changes);
            set_tool_text(*values, n, "name", "TOOL_" + std::to_string(n), changes);
        }
        derive_places(*values, *places);
    }
};

struct Folder {
    std::string path =
        (fs::temp_directory_path() / ("polyturn-bench-" + std::to_string(getpid()))).string();
    Folder() { fs::remove_all(path); }
    ~Folder() {
        std::error_code none;
        fs::remove_all(path, none);
    }
};

void BM_ToolCall(benchmark::State& state) {
    const Shop shop;
    StoreRequest request{};
    request.channel = 1;
    int n = 0;
    for (auto _ : state) {
        request.value = 1 + (n++ * 7) % 250;
        benchmark::DoNotOptimize(answer_tool_call(request, *shop.values, *shop.places));
    }
}
BENCHMARK(BM_ToolCall)->Unit(benchmark::kMicrosecond);

void BM_OffsetOnDisk(benchmark::State& state) {
    const Folder folder;
    auto disk = Database::open(folder.path);
    double value = 0;
    for (auto _ : state) {
        const Change change{{Kind::Offset, 1, 3, 256, {}}, value, value + 0.001, {}, {}, false};
        value += 0.001;
        if (!disk || !disk->commit({change}, "operator")) state.SkipWithError("the disk refuses");
    }
}
BENCHMARK(BM_OffsetOnDisk)->Unit(benchmark::kMillisecond);

void BM_LifeUpdate(benchmark::State& state) {
    Shop shop;
    std::vector<Change> changes;
    std::int32_t n = 0;
    for (auto _ : state) {
        changes.clear();
        use_up(*shop.values, 1 + n++ % 1000, LifeKind::Minutes, 1e-9, changes);
        benchmark::DoNotOptimize(changes.data());
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_LifeUpdate);

void BM_Start(benchmark::State& state) {
    const Folder folder;
    {
        Shop shop;
        auto disk = Database::open(folder.path);
        if (!disk || !disk->commit(shop.changes, "setup"))
            return state.SkipWithError("the disk refuses");
    }
    sqlite3* db = nullptr;
    sqlite3_open((folder.path + "/" + Database::kFile).c_str(), &db);
    sqlite3_exec(
        db,
        "PRAGMA synchronous=OFF; WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n "
        "WHERE i < 1000000) "
        "INSERT INTO history(utc, who, what, old, new) SELECT '2026-01-31T12:34:56.789Z', "
        "'operator', 'L1 offset ' || (i % 32) || ' wear X', '0.01', '0.02' FROM n",
        nullptr, nullptr, nullptr);
    sqlite3_close(db);
    for (auto _ : state) {
        auto disk = Database::open(folder.path);
        auto values = std::make_unique<StoreValues>();
        clear(*values);
        std::vector<Diagnosis> warnings;
        if (!disk || !disk->read_into(*values, warnings) || !values->tools.rows[999].used)
            state.SkipWithError("the store is not read");
    }
}
BENCHMARK(BM_Start)->Unit(benchmark::kMillisecond)->Iterations(5);

// --- through the real process, as the kernel sees it

const std::string kMachine = std::string(kSourceFolder) + "/examples/machines/twin-turret";

// A store on disk with 1000 tools in magazine 1, and its process.
struct Running {
    test::StoreRig rig{"bench"};
    bool good = false;
    explicit Running(int history = 0) {
        fs::create_directories(rig.folder + "/store");
        {
            Shop shop;
            auto disk = Database::open(rig.folder + "/store");
            if (!disk || !disk->commit(shop.changes, "setup")) return;
        }
        if (history > 0) {
            sqlite3* db = nullptr;
            sqlite3_open((rig.folder + "/store/" + Database::kFile).c_str(), &db);
            const std::string fill =
                "PRAGMA synchronous=OFF; WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
                "FROM n WHERE i < " +
                std::to_string(history) +
                ") INSERT INTO history(utc, who, what, old, new) SELECT '2026-01-31T12:34:56.789Z',"
                " 'operator', 'L1 offset ' || (i % 32) || ' wear X', '0.01', '0.02' FROM n";
            sqlite3_exec(db, fill.c_str(), nullptr, nullptr, nullptr);
            sqlite3_close(db);
        }
        rig.make_kernel();
        good = start();
    }
    bool start() {
        return rig.start({"--store", rig.folder + "/store", "--machine", kMachine, "--set",
                          "N2900=00000001", "--set", "N2902=1000", "--set",
                          "PT_TURRET_MAGAZINE L1=0", "--set", "N2910=1000", "--set",
                          "N2901 L1=00000100"});
    }
    std::uint64_t push(StoreRequest request) {
        const auto index = rig.push(request);
        (*rig.kernel)->store_bell.ring();
        return index;
    }
    void await(std::uint64_t index) {
        while ((*rig.store)->persist_tail.tail.load(std::memory_order_acquire) < index) {}
        (*rig.kernel)->tool_tail.tail.store((*rig.store)->tool_answers.head.load());
    }
};

void BM_ToolCallOfTheProcess(benchmark::State& state) {
    Running running;
    if (!running.good)
        return state.SkipWithError(("the store does not start: " + running.rig.messages()).c_str());
    StoreRequest call{};
    call.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolCall);
    call.channel = 1;
    int n = 0;
    for (auto _ : state) {
        call.value = 1 + (n++ * 7) % 250;
        running.await(running.push(call));
    }
}
BENCHMARK(BM_ToolCallOfTheProcess)->Unit(benchmark::kMicrosecond)->UseRealTime()->Iterations(2000);

// An operator's change: asked, on disk, answered.
void BM_OffsetOfTheProcess(benchmark::State& state) {
    Running running;
    if (!running.good)
        return state.SkipWithError(("the store does not start: " + running.rig.messages()).c_str());
    double value = 0;
    for (auto _ : state) {
        value = value > 0.9 ? 0.001 : value + 0.001;
        const auto answer =
            running.rig.ask(offset_request(1, 3, OffsetTable::Wear, OffsetField::X, value));
        if (!answer || !answer->ok) return state.SkipWithError("refused");
    }
}
BENCHMARK(BM_OffsetOfTheProcess)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(300);

// 10 000 life updates: the kernel only writes into its ring; how long until the store has them in
// its image.
void BM_TenThousandLifeUpdates(benchmark::State& state) {
    Running running;
    if (!running.good)
        return state.SkipWithError(("the store does not start: " + running.rig.messages()).c_str());
    StoreRequest use{};
    use.kind = static_cast<std::uint32_t>(StoreRequestKind::ToolLife);
    use.field = static_cast<std::int32_t>(LifeKind::Minutes);
    use.value = 1e-9;
    use.channel = 1;
    for (auto _ : state) {
        std::uint64_t last = 0;
        for (int i = 0; i < 10'000; ++i) {
            while ((*running.rig.kernel)->persist.head.load() -
                       (*running.rig.store)->persist_tail.tail.load() >=
                   8000) {}
            use.number = 1 + i % 1000;
            last = running.push(use);
        }
        running.await(last);
    }
}
BENCHMARK(BM_TenThousandLifeUpdates)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

void BM_StartOfTheProcess(benchmark::State& state) {
    Running running(1'000'000);
    if (!running.good)
        return state.SkipWithError(("the store does not start: " + running.rig.messages()).c_str());
    for (auto _ : state) {
        state.PauseTiming();
        running.rig.kill_now();
        state.ResumeTiming();
        if (!running.start())
            return state.SkipWithError(
                ("the store does not start: " + running.rig.messages()).c_str());
    }
}
BENCHMARK(BM_StartOfTheProcess)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

}  // namespace
}  // namespace polyturn::toolmgmt

BENCHMARK_MAIN();
