using System.Collections.Immutable;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>
/// The fence that the autopilot has. Posted by Autopilot Interface when it is read first and when it has changed.
/// Immutable.
/// </summary>
public sealed class AutopilotFence
{
    /// <summary>It is not read.</summary>
    public static AutopilotFence Unknown { get; } = new();

    /// <summary>Whether it was read.</summary>
    public bool IsKnown { get; init; }

    /// <summary>How often it was changed by others since it was read first.</summary>
    public int Changes { get; init; }

    /// <summary>Its items, as the mission protocol carries them; none where there is no fence.</summary>
    public ImmutableArray<MissionItemInt> Items { get; init; } = [];
}
