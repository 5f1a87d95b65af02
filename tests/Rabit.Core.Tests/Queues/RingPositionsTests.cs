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
                    positions.MoveHead<SyncPoints>(Capacity);
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
                    positions.MoveHead<SyncPoints>(1);
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
}
