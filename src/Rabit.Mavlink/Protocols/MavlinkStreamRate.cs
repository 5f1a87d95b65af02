using System;

namespace Rabit.Mavlink;

/// <summary>A message that is wanted at a rate, and the rate at which it arrives. A plain value.</summary>
/// <param name="MessageId">The message.</param>
/// <param name="WantedHertz">The rate requested.</param>
/// <param name="MeasuredHertz">
/// The rate at which it arrived over the last window; NaN before the first window after the request is over.
/// </param>
/// <param name="Answer">How the vehicle answered.</param>
/// <param name="Requests">How often it was requested.</param>
public readonly record struct MavlinkStreamRate(
    int MessageId, double WantedHertz, double MeasuredHertz, MavlinkRateAnswer Answer, int Requests)
{
    /// <summary>Whether the measured rate is away from the wanted one by more than a share of it.</summary>
    /// <param name="share">For example 0.2.</param>
    /// <returns>False also while nothing is measured.</returns>
    public bool IsOffBy(double share) => Math.Abs(MeasuredHertz - WantedHertz) > share * WantedHertz;
}
