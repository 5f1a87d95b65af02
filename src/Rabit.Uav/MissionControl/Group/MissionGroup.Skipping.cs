using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

// What one vehicle leaves out at the operator's command, all leave out.
internal sealed partial class MissionGroup
{
    private int _skippedShared;
    private bool _isLaneLeft;

    /// <summary>Whether the lane that is flown is left out from here on; once.</summary>
    public bool TakeLaneLeft()
    {
        bool isLeft = _isLaneLeft;
        _isLaneLeft = false;
        return isLeft;
    }

    private void ShareSkipped(SearchRoute route, SharedLanes lanes)
    {
        for (; _skippedShared < route.Skipped; _skippedShared++)
            lanes.Skip(route.SkippedLanes[_skippedShared].Leg);
    }

    private void LeaveOut(MissionFlight flight, SearchRoute route, IReadOnlyList<SkippedLane> skipped)
    {
        foreach (SkippedLane lane in skipped)
            _isLaneLeft |= route.LeaveOut(lane);
        _seenCells = -1; // the legs that are left are looked at again
        flight.Log($"{MissionNumbers.Of(skipped.Sum(s => s.Leg.Length))} m of lanes are left out: the operator "
            + "commanded another vehicle so");
    }
}
