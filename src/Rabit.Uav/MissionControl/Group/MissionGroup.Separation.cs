namespace Rabit.Uav.MissionControl;

// Vehicles that are not in their layer are given way to.
internal sealed partial class MissionGroup
{
    private GroupSeparation? _separation;
    private GiveWay? _giveWay;

    private GroupSeparation Separation => _separation ??= new GroupSeparation(_members);

    /// <summary>
    /// Gives way to a vehicle that is in our height and would come too near; on a leg, in each tick before its goal.
    /// </summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="blockedBy">
    /// Which vehicle stays in the way, as text: what is done now is to be left. Null where none does.
    /// </param>
    /// <returns>Whether the goal is ours: the phase does nothing then.</returns>
    public bool KeepClear(MissionFlight flight, out string? blockedBy)
    {
        blockedBy = null;
        _giveWay ??= new GiveWay(Separation, log);
        if (SystemId == 0 || _giveWay.Tick(flight, SystemId, _own) is not { } other)
            return false;
        if (!_giveWay.IsBlocked(flight.Now))
            return true;
        blockedBy = $"vehicle {MissionNumbers.Of(other)} stays in the way";
        _giveWay.End();
        return true;
    }

    /// <summary>The vehicle through whose layer we would sink here; null where there is none.</summary>
    public byte? FindBelow(MissionFlight flight) => Separation.FindBelow(flight, _own);

    /// <summary>The vehicle through whose layer we would climb here; null where there is none.</summary>
    public byte? FindAbove(MissionFlight flight) => Separation.FindAbove(flight, _own);

    /// <summary>Whether another vehicle may be in the way of a return, which gives way to none.</summary>
    public bool IsAnyOutOfLayer(MissionFlight flight) => Separation.IsAnyOutOfLayer(flight.Now);

    /// <summary>No leg is flown any more.</summary>
    public void EndGiveWay() => _giveWay?.End();
}
