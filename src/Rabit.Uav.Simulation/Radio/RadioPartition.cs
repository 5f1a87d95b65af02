using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Simulation;

/// <summary>A time in which some stations of a simulated radio receive only each other. Immutable.</summary>
/// <param name="At">When it begins, by the clock of the group.</param>
/// <param name="Duration">How long it lasts.</param>
/// <param name="Stations">
/// The stations on one side, by their numbers from 0: vehicles in their order. All others are on the other side.
/// </param>
public sealed record RadioPartition(TimeSpan At, TimeSpan Duration, IReadOnlyList<int> Stations)
{
    internal bool Separates(int from, int to, TimeSpan now)
        => now >= At && now < At + Duration && Stations.Contains(from) != Stations.Contains(to);
}
