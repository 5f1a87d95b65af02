using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What the autopilot had before anything was written. Immutable.</summary>
/// <param name="SystemId">Whose values they are.</param>
/// <param name="Parameters">The values of the parameters that were written.</param>
/// <param name="Fence">The items of its fence; null where the fence was not touched.</param>
internal sealed record Originals(
    byte SystemId, IReadOnlyList<AutopilotParameter> Parameters, IReadOnlyList<FenceItem>? Fence)
{
    /// <summary>
    /// The same with more: what is kept already is older, and so is what the autopilot had by itself.
    /// </summary>
    public Originals With(IEnumerable<AutopilotParameter> parameters, IReadOnlyList<FenceItem>? fence) => this with
    {
        Parameters = Parameters.Concat(parameters.Where(p => Parameters.All(known => known.Name != p.Name))).ToArray(),
        Fence = Fence ?? fence,
    };
}
