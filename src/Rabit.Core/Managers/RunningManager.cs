using System;
using Rabit.Core.Wiring;

namespace Rabit.Core.Managers;

/// <summary>
/// Marks the manager that runs on the calling thread, so that an endpoint can distinguish its own manager from all
/// others. The one exception to "no static state" (contract 2.8): a thread-static mark costs less than asking for the
/// thread's id.
/// </summary>
internal static class RunningManager
{
    /// <summary>Written and read by the thread itself only.</summary>
    [ThreadStatic]
    public static EndpointOwner? Current;
}
