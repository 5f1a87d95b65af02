namespace Rabit.Uav.MissionControl;

/// <summary>What a phase has to say after a look at things: an event and why. A plain value.</summary>
internal readonly struct MissionStep(MissionEvent what, string reason)
{
    /// <summary>Nothing happened.</summary>
    public static MissionStep Stay => default;

    public MissionEvent What { get; } = what;

    /// <summary>Why, for people; never null.</summary>
    public string Reason { get; } = reason;
}
