using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>One thing that is done with the autopilot, until it has an outcome. One thread.</summary>
internal abstract class SetupStep
{
    /// <summary>Begins it; called again until it has begun.</summary>
    public abstract bool TryStart(TimeSpan now);

    /// <summary>Looks for its outcome.</summary>
    /// <param name="now">The time.</param>
    /// <param name="fault">Why it did not succeed, as text; null where it did.</param>
    /// <returns>Whether it is over.</returns>
    public abstract bool TryFinish(TimeSpan now, out string? fault);
}
