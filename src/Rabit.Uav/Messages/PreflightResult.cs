namespace Rabit.Uav.Messages;

/// <summary>The result of one line of the pre-flight checklist.</summary>
public enum PreflightResult
{
    /// <summary>As it should be.</summary>
    Pass,

    /// <summary>The flight is possible; the operator should know.</summary>
    Warn,

    /// <summary>The flight is refused, unless the line is overridden by its name.</summary>
    Fail,

    /// <summary>Not reported, and not needed for the flight to be safe.</summary>
    Unknown,
}
