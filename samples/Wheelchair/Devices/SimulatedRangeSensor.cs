using System;
using Rabit.Core;

namespace Wheelchair.Devices;

/// <summary>Measures the distance to the wall, until it breaks.</summary>
internal sealed class SimulatedRangeSensor(SimulatedChair chair) : PeriodicDevice<RangeReading>
{
    /// <summary>When it stops sending, to try what happens then. Set before the start.</summary>
    public TimeSpan BreaksAt { get; set; } = TimeSpan.MaxValue;

    protected override ReaderStep Measure(TimeSpan now, out RangeReading value)
    {
        value = new RangeReading(chair.DistanceToWall(now), now);
        return now < BreaksAt ? ReaderStep.Value : ReaderStep.WaitForSignal;
    }
}
