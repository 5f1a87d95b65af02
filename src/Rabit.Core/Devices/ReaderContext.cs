using System;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core;

/// <summary>What a source may use of the run that reads it. Safe from any thread.</summary>
public sealed class ReaderContext
{
    private readonly RunClock _clock;
    private readonly WakeUpEvent _wakeUp;

    internal ReaderContext(RunClock clock, WakeUpEvent wakeUp)
    {
        _clock = clock;
        _wakeUp = wakeUp;
    }

    /// <summary>The time by the clock of the run; the same as <see cref="RabitManager.Now"/>.</summary>
    public TimeSpan Now => _clock.Now;

    /// <summary>The clock of the run.</summary>
    public TimeProvider Clock => _clock.Provider;

    /// <summary>
    /// Ends a wait that <see cref="IReaderSource{T}.Read"/> asked for: there may be something to read.
    /// </summary>
    public void Signal() => _wakeUp.Wake(WakeUpCauses.Device);
}
