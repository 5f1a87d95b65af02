using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Sleep, wake and stop, as a model of them uses it.</summary>
internal abstract class WakeUpUnderTest
{
    public abstract void Wake(WakeUpCauses cause);

    public abstract void RequestStop();

    /// <summary>Sleeps and takes turns until it is stopped.</summary>
    public abstract void Run(NextStep next, Func<ConsumedWakeUps, TimeSpan?, NextStep> runStep);
}
