using System;

namespace Rabit.Mavlink;

/// <summary>A message that is wanted at a rate, and what became of that. A plain value.</summary>
/// <param name="MessageId">The message.</param>
/// <param name="WantedHertz">The rate asked for.</param>
/// <param name="MeasuredHertz">The rate at which it came in over the last window; NaN before the first window after asking is over.</param>
/// <param name="Answer">What the vehicle said.</param>
/// <param name="Requests">How often it was asked.</param>
public readonly record struct MavlinkStreamRate(int MessageId, double WantedHertz, double MeasuredHertz, MavlinkRateAnswer Answer, int Requests)
{
    /// <summary>Whether the measured rate is away from the wanted one by more than a share of it.</summary>
    /// <param name="share">For example 0.2.</param>
    /// <returns>False also while nothing is measured.</returns>
    public bool IsOffBy(double share) => Math.Abs(MeasuredHertz - WantedHertz) > share * WantedHertz;
}
