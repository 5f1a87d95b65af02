using System;
using Rabit.Core.Reactors;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core;

/// <summary>What a source may use of the run that reads it. Safe from any thread.</summary>
public sealed class ReaderContext
{
    private readonly RunClock _clock;
    private readonly WakeUpEvent _wakeUp;
    private readonly StopDelay? _stop;

    internal ReaderContext(RunClock clock, WakeUpEvent wakeUp, StopDelay? stop)
    {
        _clock = clock;
        _wakeUp = wakeUp;
        _stop = stop;
    }

    /// <summary>The time by the clock of the run; the same as <see cref="RabitManager.Now"/>.</summary>
    public TimeSpan Now => _clock.Now;

    /// <summary>The clock of the run.</summary>
    public TimeProvider Clock => _clock.Provider;

    /// <summary>
    /// Whether a stop of the run was requested, also one that a manager delays
    /// (<see cref="RabitManager.DelaysStop"/>): the source is still read then, but what happens to it may be part of
    /// the stop. Once true it stays true.
    /// </summary>
    public bool IsStopRequested => _stop?.IsRequested ?? false;

    /// <summary>
    /// Ends a wait that <see cref="IReaderSource{T}.Read"/> asked for: there may be something to read.
    /// </summary>
    public void Signal() => _wakeUp.Wake(WakeUpCauses.Device);
}
