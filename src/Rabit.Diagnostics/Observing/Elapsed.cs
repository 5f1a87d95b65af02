using System;

namespace Rabit.Diagnostics.Observing;

/// <summary>The time between two samples, by the clock of the run and by that of the world.</summary>
internal readonly record struct Elapsed(TimeSpan Run, TimeSpan Real)
{
    /// <summary>Null where no time has passed.</summary>
    public double? Speed => Real > TimeSpan.Zero ? Math.Round(Run / Real, 3) : null;

    /// <summary>How many a second of the run; null where the clock of the run stood still, or was set back.</summary>
    public double? Rate(long count)
        => Run > TimeSpan.Zero ? Math.Round(Math.Max(count, 0) / Run.TotalSeconds, 3) : null;

    /// <summary>Which part of the real time something took.</summary>
    public double? PartOfReal(TimeSpan busy)
        => Real > TimeSpan.Zero ? Math.Round(Math.Clamp(busy / Real, 0, 1), 4) : null;
}
