using System;

namespace Rabit.Uav.Simulation;

/// <summary>A time in which the simulated camera gives no pictures. A plain value.</summary>
/// <param name="from">
/// When it begins, by the clock of the run: the first picture that is missing begins then or later.
/// </param>
/// <param name="duration">How long it lasts.</param>
public readonly struct CameraFreeze(TimeSpan from, TimeSpan duration)
{
    /// <summary>
    /// When it begins, by the clock of the run: the first picture that is missing begins then or later.
    /// </summary>
    public TimeSpan From { get; } = from;

    /// <summary>How long it lasts.</summary>
    public TimeSpan Duration { get; } = duration;

    internal bool Contains(TimeSpan time) => time >= From && time - From < Duration;
}
