using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>
/// A connected piece of the ground that was seen. Corners in order, the first not repeated. Immutable.
/// </summary>
internal sealed class SeenPatch(
    IReadOnlyList<GeodeticPosition> outline, IReadOnlyList<IReadOnlyList<GeodeticPosition>> holes)
{
    public IReadOnlyList<GeodeticPosition> Outline { get; } = outline;

    /// <summary>Pieces inside that were not seen.</summary>
    public IReadOnlyList<IReadOnlyList<GeodeticPosition>> Holes { get; } = holes;
}
