using System.Collections.Generic;

namespace Rabit.Uav.Reporting;

/// <summary>State and counts of one manager over time. Immutable.</summary>
/// <param name="name">Of the manager.</param>
/// <param name="samples">Oldest first.</param>
public sealed class ManagerTimeLine(string name, IReadOnlyList<ManagerSample> samples)
{
    /// <summary>Of the manager.</summary>
    public string Name { get; } = name;

    /// <summary>Oldest first.</summary>
    public IReadOnlyList<ManagerSample> Samples { get; } = samples;
}
