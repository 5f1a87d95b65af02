namespace Rabit.Uav.Messages;

/// <summary>One line of the pre-flight checklist. Immutable.</summary>
/// <param name="Name">What is checked; the name by which the line is overridden.</param>
/// <param name="Result">The result.</param>
/// <param name="Value">What was found, as text.</param>
/// <param name="HowToSet">What to do about it, as text; empty where nothing is to be done.</param>
/// <param name="IsOverridden">Whether the operator has overridden the line by its name.</param>
public sealed record PreflightLine(
    string Name, PreflightResult Result, string Value, string HowToSet, bool IsOverridden)
{
    /// <summary>Whether the flight is refused for this line.</summary>
    public bool Refuses => Result == PreflightResult.Fail && !IsOverridden;

    /// <summary>The line as text, for example <c>fail BATT_FS_LOW_ACT: 0 (none); set it to 2</c>.</summary>
    public override string ToString()
        => $"{(Result == PreflightResult.Unknown ? "unknown" : Result.ToString().ToLowerInvariant())} {Name}: {Value}"
            + (IsOverridden ? " (overridden)" : string.Empty)
            + (HowToSet.Length > 0 ? "; " + HowToSet : string.Empty);
}
