using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>A queue in which a push of async code may wait, for a limited time.</summary>
internal interface ITimeLimitedQueue
{
    /// <summary>Woken when a push begins to wait. Set while wiring.</summary>
    WakeUpEvent? TimeKeeper { set; }

    /// <summary>Gives up the pushes that have waited for too long.</summary>
    /// <returns>When the next one will have; <see cref="TimeSpan.MaxValue"/> when none waits.</returns>
    TimeSpan ExpirePushes(TimeSpan now);
}
