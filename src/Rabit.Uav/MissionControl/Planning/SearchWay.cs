using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>A planned search. Immutable.</summary>
internal sealed class SearchWay(IReadOnlyList<PlanePoint> corners, IReadOnlyList<LaneSegment> legs)
{
    /// <summary>The whole way, corner by corner.</summary>
    public IReadOnlyList<PlanePoint> Corners { get; } = corners;

    /// <summary>What of it is flown as legs, in order; between them the vehicle may fly as it likes.</summary>
    public IReadOnlyList<LaneSegment> Legs { get; } = legs;

    /// <summary>Metres.</summary>
    public double Length
    {
        get
        {
            double sum = 0;
            for (int i = 0; i + 1 < Corners.Count; i++)
                sum += Corners[i].DistanceTo(Corners[i + 1]);
            return sum;
        }
    }
}
