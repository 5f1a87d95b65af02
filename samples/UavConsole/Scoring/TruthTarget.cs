using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>A target that is really there. Immutable.</summary>
internal sealed class TruthTarget(string name, TargetClassName targetClass, GeodeticPosition position)
{
    /// <summary>For people.</summary>
    public string Name { get; } = name;

    /// <summary>Exactly one.</summary>
    public TargetClassName Class { get; } = targetClass;

    /// <summary>Where it stands; the altitude is not used.</summary>
    public GeodeticPosition Position { get; } = position;
}
