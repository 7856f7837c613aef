// When a record acts, by its kind and by what it says.
#include "kernel/records/record_kinds.hpp"

#include <gtest/gtest.h>

#include <set>

namespace polyturn::kernel {
namespace {

PathRecord of(RecordKind kind, std::int32_t code = 0, std::uint32_t flags = 0, double value = 0) {
    PathRecord r{};
    r.kind = static_cast<std::uint8_t>(kind);
    r.code = code;
    r.flags = flags;
    r.value = value;
    return r;
}

TEST(RecordKinds, AreDrivenOrStandOrActBetweenTwoMoves) {
    using K = RecordKind;
    const std::set<K> motion{K::Line, K::Arc, K::Curve},
        instant{K::SpindleSpeed, K::Variable, K::Offset,   K::Message,  K::Part,
                K::Interrupts,   K::Marker,   K::ToolData, K::LifeGroup},
        by_contents{K::SpindleMode, K::Flag, K::PositioningAxis};
    for (std::size_t i = 1; i < kRecordKinds; ++i) {
        const auto kind = static_cast<K>(i);
        const PathRecord r = of(kind);
        EXPECT_EQ(is_motion(r), motion.contains(kind)) << i;
        if (by_contents.contains(kind)) continue;
        EXPECT_EQ(stops_path(r), !motion.contains(kind) && !instant.contains(kind)) << i;
    }
    EXPECT_TRUE(stops_path(of(K::None)));
    EXPECT_TRUE(stops_path(of(static_cast<K>(200)))) << "unknown: it is refused at standstill";
}

TEST(RecordKinds, SayWhatWritesToTheStoreWithoutStopping) {
    using K = RecordKind;
    const std::set<K> writes{K::Variable, K::Offset, K::ToolData, K::LifeGroup};
    for (std::size_t i = 0; i < kRecordKinds; ++i)
        EXPECT_EQ(writes_store(of(static_cast<K>(i))), writes.contains(static_cast<K>(i))) << i;
}

TEST(RecordKinds, StopThePathWhereTheirContentsNeedStandstill) {
    const auto mode = [](SpindleModeCode code, std::uint32_t flags = 0) {
        return stops_path(of(RecordKind::SpindleMode, static_cast<std::int32_t>(code), flags));
    };
    EXPECT_TRUE(mode(SpindleModeCode::Position));
    EXPECT_FALSE(mode(SpindleModeCode::Position, kPositioning));
    EXPECT_TRUE(mode(SpindleModeCode::Couple));
    EXPECT_TRUE(mode(SpindleModeCode::Uncouple));
    EXPECT_FALSE(mode(SpindleModeCode::SurfaceSpeed));
    const auto step = [](PositioningStep code) {
        return stops_path(of(RecordKind::PositioningAxis, static_cast<std::int32_t>(code)));
    };
    EXPECT_TRUE(step(PositioningStep::Begin));
    EXPECT_TRUE(step(PositioningStep::Room));
    EXPECT_FALSE(step(PositioningStep::Move));
    EXPECT_FALSE(step(PositioningStep::Plain));
    EXPECT_TRUE(stops_path(of(RecordKind::Flag, kFlagControl, 0, kControlGroupEnds)));
    EXPECT_FALSE(stops_path(of(RecordKind::Flag, kFlagControl)));
    EXPECT_TRUE(stops_path(of(RecordKind::Line, 0, kThread)));
}

}  // namespace
}  // namespace polyturn::kernel
