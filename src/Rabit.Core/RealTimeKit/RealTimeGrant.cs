namespace Rabit.Core;

/// <summary>
/// One line of a <see cref="RealTimeReport"/>: what was requested, and whether the machine granted it. Immutable.
/// </summary>
public sealed class RealTimeGrant
{
    internal RealTimeGrant(string requested, string? reason)
    {
        Requested = requested;
        Reason = reason;
    }

    /// <summary>What was requested, with its figure.</summary>
    public string Requested { get; }

    /// <summary>Whether all of it was granted.</summary>
    public bool IsGranted => Reason is null;

    /// <summary>
    /// Why it was not granted, with the system's name of the error and what would help; null when it was.
    /// </summary>
    public string? Reason { get; }

    /// <summary>One line.</summary>
    public override string ToString() => IsGranted ? $"{Requested}: granted" : $"{Requested}: not granted, {Reason}";
}
