using System.Collections.Generic;
using Rabit.Geodesy;

namespace UavConsole;

/// <summary>One of several vehicles on the map. Immutable.</summary>
internal sealed class MapVehicle
{
    /// <summary>What stands where it is.</summary>
    public char Mark { get; init; }

    /// <summary>The path that was flown, oldest first, in the frame of the map, metres.</summary>
    public IReadOnlyList<NedPosition> Path { get; init; } = [];
}
