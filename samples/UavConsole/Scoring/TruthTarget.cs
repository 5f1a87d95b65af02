using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>A target that is really there. Immutable.</summary>
internal sealed class TruthTarget(string name, TargetColours colour, GeodeticPosition position)
{
    /// <summary>For people.</summary>
    public string Name { get; } = name;

    /// <summary>Exactly one.</summary>
    public TargetColours Colour { get; } = colour;

    /// <summary>Where it stands; the altitude is not used.</summary>
    public GeodeticPosition Position { get; } = position;
}
