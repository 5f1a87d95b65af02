using System;
using System.Collections.Generic;

namespace Rabit.Uav.Reporting;

/// <summary>What a vehicle of a group sent to the others by radio. Immutable.</summary>
public sealed class RadioUse
{
    /// <summary>Oldest first; none where only the totals are known.</summary>
    public IReadOnlyList<RadioSample> Samples { get; init; } = [];

    /// <summary>Frames that it sent.</summary>
    public long FramesSent { get; init; }

    /// <summary>Bytes of them.</summary>
    public long BytesSent { get; init; }

    /// <summary>Frames for which there was no room.</summary>
    public long FramesRefused { get; init; }

    /// <summary>Receptions by the others, each of them counted.</summary>
    public long Delivered { get; init; }

    /// <summary>Receptions that failed: by loss, in a burst, in a partition.</summary>
    public long Lost { get; init; }

    /// <summary>How long its radio was on.</summary>
    public TimeSpan Duration { get; init; }

    /// <summary>The mean, kbit/s; NaN where it was not on.</summary>
    public double KilobitsPerSecond
        => Duration > TimeSpan.Zero ? BytesSent * 8 / 1000.0 / Duration.TotalSeconds : double.NaN;

    /// <summary>The part of the receptions that failed, 0 to 1; NaN where there were none.</summary>
    public double LossFraction => Lost + Delivered == 0 ? double.NaN : (double)Lost / (Lost + Delivered);
}
