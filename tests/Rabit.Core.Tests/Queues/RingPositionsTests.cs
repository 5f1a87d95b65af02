using System;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Xunit;

namespace Rabit.Core.Tests.Queues;

/// <summary>Positions alone, where billions of values go by without being written.</summary>
public sealed class RingPositionsTests
{
    private const int Capacity = 1 << 24;

    // More than 2^31 values, less than 2^32.
    private const int Rounds = 160;

    [Fact, Trait("Clause", "3.1")]
    public void Reserve_HeldUpWhileMoreThanHalfOfTheRangeGoesBy_LeavesNoRoomInAFullQueue()
    {
        for (int point = 1; ; point++)
        {
            var positions = new RingPositions(0, isAlone: false);
            positions.Reserve<SyncPoints>(Capacity, Capacity, out _);
            HeldUpPoints.HoldUpAt(point, () =>
            {
                for (int i = 0; i < Rounds; i++)
                {
                    positions.MoveHead<SyncPoints>(positions.Head<SyncPoints>(), Capacity);
                    positions.Reserve<SyncPoints>(Capacity, Capacity, out _);
                }
            });

            int reserved = positions.Reserve<HeldUpPoints>(1, Capacity, out _);

            if (!HeldUpPoints.WasHeldUp)
                return;
            Assert.Equal(0, reserved);
            Assert.True(
                positions.Reserve<SyncPoints>(1, Capacity, out _) == 0,
                $"Held up at point {point}, a sender overwrites what is in the full queue.");
        }
    }

    [Fact, Trait("Clause", "3.1")]
    public void Counters_ValuesGoByBetweenTheLooks_ShowNoMoreThanThereWereAtOnce()
    {
        for (int point = 1; ; point++)
        {
            var positions = new RingPositions(0, isAlone: false);
            positions.Reserve<SyncPoints>(1, 8, out _);
            HeldUpPoints.HoldUpAt(point, () =>
            {
                for (int i = 0; i < 5; i++)
                {
                    positions.MoveHead<SyncPoints>(positions.Head<SyncPoints>(), 1);
                    positions.Reserve<SyncPoints>(1, 8, out _);
                }
            });

            QueueCounters counters = positions.Counters<HeldUpPoints>(8);

            if (!HeldUpPoints.WasHeldUp)
                return;
            Assert.True(
                counters.Resident == 1 && counters.HighWater == 1,
                $"Held up at point {point}, the counters show what never was: {counters}");
            Assert.Equal(counters.Pushed, counters.Popped + counters.Resident);
        }
    }

    // Far beyond 2^32, from starts on both sides of a wrap.
    [Theory, Trait("Clause", "3.1")]
    [InlineData(0)]
    [InlineData(int.MaxValue - 3)]
    [InlineData(int.MinValue)]
    [InlineData(-3)]
    public void Counters_ThousandsOfMillionsGoBy_AreExact(int start)
    {
        foreach (bool isAlone in new[] { false, true })
        {
            var positions = new RingPositions(start, isAlone);
            long popped = 0;
            for (int i = 0; i < 5 * Rounds; i++)
            {
                PushAll(ref positions, isAlone);
                Assert.Equal((popped + Capacity, popped), (Read(ref positions).Pushed, Read(ref positions).Popped));
                positions.MoveHead<SyncPoints>(positions.Head<SyncPoints>(), Capacity);
                popped += Capacity;
                Assert.Equal((popped, popped), (Read(ref positions).Pushed, Read(ref positions).Popped));
            }
        }
    }

    [Theory, Trait("Clause", "3.1")]
    [InlineData(int.MaxValue)]
    [InlineData(-1)]
    public void Counters_HeadCrossesHalfOfItsRange_AreExactBetweenItsStores(int start)
    {
        for (int point = 1; ; point++)
        {
            var positions = new RingPositions(start, isAlone: false);
            positions.Reserve<SyncPoints>(1, 8, out _);
            QueueCounters counters = default;
            HeldUpPoints.HoldUpAt(point, () => counters = positions.Counters<SyncPoints>(8));

            positions.MoveHead<HeldUpPoints>(positions.Head<HeldUpPoints>(), 1);

            if (!HeldUpPoints.WasHeldUp)
                return;
            Assert.Equal(1, counters.Pushed);
            Assert.InRange(counters.Popped, 0, 1);
        }
    }

    private static QueueCounters Read(ref RingPositions positions) => positions.Counters<SyncPoints>(Capacity);

    private static void PushAll(ref RingPositions positions, bool isAlone)
    {
        if (!isAlone)
        {
            Assert.Equal(Capacity, positions.Reserve<SyncPoints>(Capacity, Capacity, out _));
            return;
        }

        Assert.Equal(Capacity, positions.Find<SyncPoints>(Capacity, Capacity, out int position));
        positions.MoveTail<SyncPoints>(unchecked(position + Capacity));
    }
}
