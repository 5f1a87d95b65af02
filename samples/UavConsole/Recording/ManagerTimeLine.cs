using System.Collections.Generic;

namespace UavConsole;

/// <summary>The life of one manager, sampled. Immutable.</summary>
internal sealed class ManagerTimeLine(string name, IReadOnlyList<ManagerSample> samples)
{
    public string Name { get; } = name;

    /// <summary>Oldest first.</summary>
    public IReadOnlyList<ManagerSample> Samples { get; } = samples;
}
