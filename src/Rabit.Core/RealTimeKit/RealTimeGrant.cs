namespace Rabit.Core;

/// <summary>One line of a <see cref="RealTimeReport"/>: what was asked, and whether the machine granted it. Immutable.</summary>
public sealed class RealTimeGrant
{
    internal RealTimeGrant(string asked, string? whyNot)
    {
        Asked = asked;
        WhyNot = whyNot;
    }

    /// <summary>What was asked, with its figure.</summary>
    public string Asked { get; }

    /// <summary>Whether all of it was granted.</summary>
    public bool IsGranted => WhyNot is null;

    /// <summary>Why it was not, with the system's name of the error and what would help; null when it was.</summary>
    public string? WhyNot { get; }

    /// <summary>One line.</summary>
    public override string ToString() => IsGranted ? $"{Asked}: granted" : $"{Asked}: not granted, {WhyNot}";
}
