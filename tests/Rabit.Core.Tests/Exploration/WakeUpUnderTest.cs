using System;
using Rabit.Core.Managers;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Sleep, wake and stop, as a model of them uses it.</summary>
internal abstract class WakeUpUnderTest
{
    public abstract void Wake(WakeUpCauses cause);

    public abstract void RequestStop();

    /// <summary>Sleeps and takes turns until it is stopped.</summary>
    public abstract void Run(NextTurn next, Func<WakeUps, TimeSpan?, NextTurn> takeTurn);
}
