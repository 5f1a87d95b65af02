namespace Rabit.Uav.MissionControl;

/// <summary>The result of one tick of a phase or of a failsafe: an event and its reason. A plain value.</summary>
internal readonly struct MissionStep(MissionEvent what, string reason)
{
    /// <summary>Nothing happened.</summary>
    public static MissionStep Stay => default;

    public MissionEvent What { get; } = what;

    /// <summary>Why, as text; never null.</summary>
    public string Reason { get; } = reason;
}
