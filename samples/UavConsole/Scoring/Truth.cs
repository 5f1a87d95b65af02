using System.Collections.Generic;
using Rabit.Geodesy;

namespace UavConsole;

/// <summary>What is really there: from the simulation, or from a file that somebody with a tape measure wrote. Immutable.</summary>
internal sealed class Truth(GeodeticPosition home, IReadOnlyList<TruthTarget> targets)
{
    /// <summary>Where the vehicle starts; the altitude is not used.</summary>
    public GeodeticPosition Home { get; } = home;

    /// <summary>Every target there is.</summary>
    public IReadOnlyList<TruthTarget> Targets { get; } = targets;
}
