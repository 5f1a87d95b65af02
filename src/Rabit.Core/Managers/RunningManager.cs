using System;
using System.Runtime.CompilerServices;
using Rabit.Core.Wiring;

namespace Rabit.Core.Managers;

/// <summary>
/// Which manager runs on the calling thread, so that an endpoint can distinguish its own manager from all others. The
/// one exception to "no static state" (contract 2.8): a thread-static mark costs less than asking for the thread's id.
/// </summary>
/// <remarks>
/// Where the stack can be marked (<see cref="StackMark"/>) that is asked first: it costs a third of the thread-static
/// field, which is a call into the runtime. A mark on the stack says only yes; the field decides everything else.
/// </remarks>
internal static class RunningManager
{
    // Written and read by the thread itself only.
    [ThreadStatic]
    private static EndpointOwner? _current;

    /// <summary>The manager that runs on this thread; null for none.</summary>
    public static EndpointOwner? Current => _current;

    /// <summary>Whether this manager runs on this thread: the check of every use of an endpoint.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Is(EndpointOwner owner) => owner.Mark.IsHere() || _current == owner;

    /// <summary>
    /// As <see cref="Is"/>, but false decides nothing where the stack can be marked: a look that calls nothing.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsSeenToBe(EndpointOwner owner) => StackMark.Exists ? owner.Mark.IsHere() : _current == owner;

    /// <summary>From now on this manager, or none, runs on this thread.</summary>
    /// <returns>The one that ran before it.</returns>
    public static EndpointOwner? Replace(EndpointOwner? owner)
    {
        EndpointOwner? outer = _current;
        _current = owner;
        return outer;
    }
}
