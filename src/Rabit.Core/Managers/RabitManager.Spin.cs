using System;

namespace Rabit.Core;

/// <content>A look for wake-ups before the sleep.</content>
public abstract partial class RabitManager
{
    private static readonly TimeSpan MaxSpin = TimeSpan.FromTicks(1000);

    private TimeSpan _spinBeforeSleep;

    /// <summary>
    /// How long the manager looks for a wake-up, at full load of its CPU, before it sleeps: at most 100 µs, zero by
    /// default. A wake-up that comes in that time costs neither a sleep nor the wake of a thread, some 50 µs on two
    /// CPUs: for two managers that answer each other at once. What it costs is in
    /// <see cref="ManagerStatus.SpinTime"/>. It is not done where the process has one CPU, or another thread of the run
    /// was pinned, until the end of its start-up, to the only CPU that this one was pinned to: who is to wake it could
    /// not run then. In virtual time it does nothing. The unit of work may change it; the change holds from the next
    /// sleep. On Mono and .NET Framework state it by <see cref="TimeSpan.FromTicks"/>: there
    /// <c>TimeSpan.FromMilliseconds</c> makes whole milliseconds of a fraction, and none of 0.1.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative, or above 100 µs.</exception>
    public TimeSpan SpinBeforeSleep
    {
        get => _spinBeforeSleep;
        protected set
        {
            if (value < TimeSpan.Zero || value > MaxSpin)
                throw new ArgumentOutOfRangeException(
                    nameof(value), value, $"The spin of manager '{Name}' before it sleeps must be 0 to 100 µs.");
            _spinBeforeSleep = value;
        }
    }
}
