// libs: polyturn_toolmgmt
// The store's figures (issue 6): a T call among 1000 tools under 200 us; an offset change on disk under 10 ms; 10 000 life
// updates a second; a start with 1000 tools and a million lines of history under 1 s.
#include <benchmark/benchmark.h>
#include <sqlite3.h>

#include <filesystem>
#include <memory>

#include "ipc/machine/load_machine.hpp"
#include "ipc/params/param_file.hpp"
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
        for (const char* line : {"N2900=00000001", "N2902=1000", "PT_TURRET_MAGAZINE L1=0", "N2910=1000", "N2901 L1=00000100"}) {
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
    std::string path = (fs::temp_directory_path() / ("polyturn-bench-" + std::to_string(getpid()))).string();
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
        if (!disk || !disk->commit(shop.changes, "setup")) return state.SkipWithError("the disk refuses");
    }
    sqlite3* db = nullptr;
    sqlite3_open((folder.path + "/" + Database::kFile).c_str(), &db);
    sqlite3_exec(db, "PRAGMA synchronous=OFF; WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000000) "
                     "INSERT INTO history(utc, who, what, old, new) SELECT '2026-01-31T12:34:56.789Z', 'operator', 'L1 offset ' || (i % 32) || ' wear X', '0.01', '0.02' FROM n",
                 nullptr, nullptr, nullptr);
    sqlite3_close(db);
    for (auto _ : state) {
        auto disk = Database::open(folder.path);
        auto values = std::make_unique<StoreValues>();
        clear(*values);
        std::vector<Diagnosis> warnings;
        if (!disk || !disk->read_into(*values, warnings) || !values->tools.rows[999].used) state.SkipWithError("the store is not read");
    }
}
BENCHMARK(BM_Start)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace polyturn::toolmgmt

BENCHMARK_MAIN();
