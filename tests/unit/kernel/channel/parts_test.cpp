// The parts of a channel by themselves: transitions that touch nothing else.
#include <gtest/gtest.h>

#include <memory>

#include "kernel/channel/parts/interrupt_watch.hpp"
#include "kernel/channel/parts/outbox.hpp"
#include "kernel/channel/parts/process_link.hpp"
#include "kernel/channel/parts/production.hpp"
#include "kernel/channel/parts/program_state.hpp"
#include "kernel/channel/parts/restart_stage.hpp"
#include "kernel/channel/parts/resume.hpp"
#include "kernel/channel/parts/retrace.hpp"
#include "kernel/channel/parts/thread_executor.hpp"

namespace polyturn::kernel {
namespace {

TEST(ProgramStatePart, KeepsSeveralReasonsToBrakeUntilEachIsGone) {
    ProgramState program;
    program.brake_for(Brake::Hold);
    program.brake_for(Brake::Reset);
    program.brake_for(Brake::Hold);
    EXPECT_TRUE(program.holds());
    EXPECT_TRUE(program.brakes.any_of(Brake::Alarm, Brake::Reset));
    program.release(Brake::Hold);
    EXPECT_FALSE(program.holds());
    EXPECT_TRUE(program.resets());
    EXPECT_FALSE(program.interrupted());
    program.brake_for(Brake::GroupEnd);
    EXPECT_TRUE(program.take_group_end());
    EXPECT_FALSE(program.take_group_end());
}

TEST(ProgramStatePart, IsIdleWhereNoProgramRunsAndLitWhereItDrives) {
    ProgramState program;
    for (const auto state :
         {ChannelState::Absent, ChannelState::Reset, ChannelState::Ended, ChannelState::Dead}) {
        program.enter(state);
        EXPECT_TRUE(program.idle());
        EXPECT_FALSE(program.runs());
        EXPECT_FALSE(program.start_lamp());
    }
    program.enter(ChannelState::Interrupted, StopReason::Alarm);
    EXPECT_FALSE(program.idle());
    EXPECT_FALSE(program.runs());
    program.enter(ChannelState::ProgramStop, StopReason::M00);
    EXPECT_TRUE(program.runs());
    EXPECT_FALSE(program.drives());
    EXPECT_TRUE(program.stopped_by(StopReason::M00));
    program.enter(ChannelState::Waiting);
    EXPECT_EQ(program.reason(), StopReason::M00) << "the reason stays until it is taken away";
    EXPECT_TRUE(program.start_lamp());
    program.brake_for(Brake::Hold);
    EXPECT_FALSE(program.start_lamp());
}

TEST(ProcessLinkPart, ListensOnlyWhileItIsAlive) {
    ProcessLink process;
    EXPECT_FALSE(process.listens()) << "absent";
    const auto segment = std::make_unique<ChannelSegment>();
    process.segment = segment.get();
    EXPECT_TRUE(process.listens());
    process.life = ProcessLink::Life::Frozen;
    EXPECT_FALSE(process.listens());
    EXPECT_TRUE(process.frozen());
    for (const auto life : {ProcessLink::Life::Dead, ProcessLink::Life::DeadAtRest}) {
        process.life = life;
        EXPECT_TRUE(process.dead());
        EXPECT_FALSE(process.frozen());
        EXPECT_FALSE(process.listens());
    }
}

TEST(ProductionPart, CountsLapsThatTookTime) {
    Production production;
    production.begin();
    production.end_lap();
    EXPECT_EQ(production.cycles, 0u) << "no time has passed";
    production.times.cycle_s = 10;
    production.end_lap();
    production.times.cycle_s = 16;
    production.end_lap();
    EXPECT_EQ(production.cycles, 2u);
    EXPECT_DOUBLE_EQ(production.last_cycle_s, 6);
    EXPECT_DOUBLE_EQ(production.mean_cycle_s(), 8);
    production.begin();
    EXPECT_FALSE(production.lap_ended);
    EXPECT_EQ(production.cycles, 2u) << "another run of the same program";
    production.forget_cycles();
    EXPECT_DOUBLE_EQ(production.mean_cycle_s(), 0);
}

TEST(OutboxPart, SendsInOrderWhatTheRingHasRoomForAndKeepsTheRest) {
    const auto ring = std::make_unique<RingHead<ChannelEvent, 64>>();
    RingTail tail;
    Outbox outbox;
    outbox.begin_at(0);
    std::uint64_t put = 0;
    const auto fill = [&] {
        while (!outbox.full()) outbox.put(ChannelEventKind::StoreChanged, 1, 7, put++, 0, {});
    };
    for (int k = 0; k < 4; ++k) {
        fill();
        EXPECT_EQ(outbox.newest(), put);
        EXPECT_TRUE(outbox.send(*ring, tail, 0));
    }
    EXPECT_TRUE(outbox.empty());
    fill();
    EXPECT_FALSE(outbox.send(*ring, tail, 0)) << "no room, nothing to wake for";
    EXPECT_TRUE(outbox.full());
    EXPECT_FALSE(outbox.has_room_for(1));
    outbox.put(ChannelEventKind::StoreChanged, 1, 7, 999, 0, {});  // one too many is dropped
    tail.tail.store(8);
    EXPECT_TRUE(outbox.send(*ring, tail, 0));
    EXPECT_TRUE(outbox.has_room_for(8));
    EXPECT_FALSE(outbox.has_room_for(9));
    EXPECT_EQ(outbox.sent(), 72u);
    EXPECT_EQ(ring->slot(71).record, 71u);
    EXPECT_EQ(ring->slot(71).seq, 72u);
}

TEST(OutboxPart, WakesForRoomInTheRingOnlyInLargePieces) {
    const auto ring = std::make_unique<RingHead<ChannelEvent, 64>>();
    const RingTail tail;
    Outbox outbox;
    outbox.begin_at(0);
    EXPECT_FALSE(outbox.send(*ring, tail, 1023));
    EXPECT_TRUE(outbox.send(*ring, tail, 1024));
    EXPECT_FALSE(outbox.send(*ring, tail, 2047));
}

TEST(RetracePart, AHandwheelTakesTheChosenWay) {
    Retrace retrace;
    retrace.way = Retrace::Way::Back;
    EXPECT_TRUE(retrace.chosen());
    retrace.set_wheel(true, -0.5);
    EXPECT_FALSE(retrace.chosen());
    EXPECT_TRUE(retrace.wheel.holds());
    EXPECT_DOUBLE_EQ(retrace.wheel.share(), -0.5);
    retrace.wheel.blocked = true;
    retrace.set_wheel(false, 0.7);
    EXPECT_FALSE(retrace.wheel.blocked);
    EXPECT_DOUBLE_EQ(retrace.wheel.share(), 1);
}

TEST(ThreadPart, IsCommittedWhileItMoves) {
    ThreadExecutor thread;
    EXPECT_FALSE(thread.committed());
    thread.stage = ThreadExecutor::Stage::Committed;
    EXPECT_FALSE(thread.moving());
    thread.moves(true);
    EXPECT_TRUE(thread.committed() && thread.moving());
    thread.moves(false);
    EXPECT_FALSE(thread.committed() || thread.moving());
}

TEST(ResumePart, AResetForgetsTheBlockByHandAndTheQuestion) {
    Resume resume;
    resume.by_hand = Resume::ByHand::Done;
    resume.question = 3;
    resume.start_wanted = resume.change_due = resume.aside = true;
    EXPECT_TRUE(resume.program_left());
    resume.clear();
    EXPECT_FALSE(resume.off_program() || resume.start_wanted || resume.change_due || resume.aside);
    EXPECT_EQ(resume.question, 0u);
}

TEST(RestartPart, ASearchBeginsWithoutItsGroup) {
    RestartStage restart;
    restart.complete = restart.refused = true;
    restart.search(4);
    EXPECT_TRUE(restart.searches());
    EXPECT_FALSE(restart.at_block() || restart.complete || restart.refused);
    EXPECT_EQ(restart.group, 4u);
}

}  // namespace
}  // namespace polyturn::kernel
