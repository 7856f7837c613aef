#include "kernel/plc/plc_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "kernel/plc/plc_api.h"

namespace polyturn::plc {
namespace {
namespace fs = std::filesystem;

struct Kept {
    fs::path folder = fs::path(::testing::TempDir()) / ("plc_memory_" + std::to_string(::getpid()));
    std::string path = (folder / "plc.memory").string();
    Kept() {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    ~Kept() { fs::remove_all(folder); }

    void write(PlcMemory& memory, int value) const {
        memory.begin_cycle();
        EXPECT_EQ(memory.write(3, &value, sizeof value), POLYTURN_PLC_MEMORY_DONE);
        memory.end_cycle();
    }
    // What the next PLC finds; -1 nothing.
    int read() const {
        PlcMemory memory;
        memory.open(path, false);
        memory.begin_cycle();
        int value = -1;
        return memory.read(3, &value, sizeof value) == POLYTURN_PLC_MEMORY_DONE ? value : -1;
    }
};

TEST(PlcMemory, KeepsTheLastOfManyWritesBehindItsEnd) {
    Kept kept;
    {
        PlcMemory memory;
        memory.open(kept.path, false);
        for (int i = 1; i <= 500; ++i) kept.write(memory, i);
    }
    EXPECT_EQ(kept.read(), 500);
}

TEST(PlcMemory, BringsItToTheDiskOnceThereIsPlace) {
    Kept kept;
    // nothing can be written beside the old file
    fs::create_directories(kept.path + ".new/in the way");
    PlcMemory memory;
    memory.open(kept.path, false);
    kept.write(memory, 7);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(kept.read(), -1);
    fs::remove_all(kept.path + ".new");
    for (int i = 0; i < 100 && kept.read() != 7; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(kept.read(), 7);
}

}  // namespace
}  // namespace polyturn::plc
