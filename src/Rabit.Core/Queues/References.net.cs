using System.Runtime.CompilerServices;

namespace Rabit.Core.Queues;

/// <summary>Whether values of a type may hold references, so that a place that was emptied must be cleared.</summary>
internal static class References
{
    /// <summary>Known when the code is compiled: what it guards is left out or in.</summary>
    public static bool In<T>() => RuntimeHelpers.IsReferenceOrContainsReferences<T>();
}
