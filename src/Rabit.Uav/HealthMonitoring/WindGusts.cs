using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The strongest wind of the last 10 s that is no outlier: it was reported in two different seconds. So the gusts that
/// come with a wind are judged, and a single wrong estimate is not.
/// </summary>
internal sealed class WindGusts
{
    private const int SecondsKept = 10;

    // By the second of the run; of another second it is out of date.
    private readonly (long Second, double Speed)[] _strongest = new (long, double)[SecondsKept];

    public WindGusts()
    {
        for (int i = 0; i < SecondsKept; i++)
            _strongest[i] = (long.MinValue, double.NaN);
    }

    /// <summary>Takes the estimate, and gives the gusts, metres per second; NaN where they are not known.</summary>
    public double Update(in VehicleState vehicle, TimeSpan now)
    {
        if (vehicle.WindTime is { } time && !double.IsNaN(vehicle.WindMetresPerSecond))
            Take((long)Math.Floor(time.ExactSeconds), vehicle.WindMetresPerSecond);
        long oldest = (long)Math.Floor(now.ExactSeconds) - SecondsKept;
        (double first, double second) = (double.NegativeInfinity, double.NegativeInfinity);
        foreach ((long at, double speed) in _strongest)
        {
            if (at <= oldest)
                continue;
            second = Math.Max(second, Math.Min(first, speed));
            first = Math.Max(first, speed);
        }

        return double.IsNegativeInfinity(second) ? double.NaN : second;
    }

    private void Take(long second, double speed)
    {
        ref (long Second, double Speed) kept = ref _strongest[(int)(second % SecondsKept)];
        kept = kept.Second == second ? (second, Math.Max(kept.Speed, speed)) : (second, speed);
    }
}
