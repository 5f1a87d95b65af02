namespace Rabit.Core.Queues;

/// <summary>Whether values of a type may hold references, so that a place that was emptied must be cleared.</summary>
internal static class References
{
    /// <summary>
    /// Down-level it is not known without reflection: true for all but numbers. Clearing is cheap beside copying.
    /// </summary>
    public static bool In<T>() => Known<T>.In;

    private static class Known<T>
    {
        public static readonly bool In = !typeof(T).IsPrimitive;
    }
}
