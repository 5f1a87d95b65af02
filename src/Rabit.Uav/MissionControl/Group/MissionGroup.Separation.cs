using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

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

    /// <summary>What of the others is in the way of a take-off; null where nothing is.</summary>
    public string? FindConflict(MissionFlight flight)
    {
        if (SystemId == 0)
            return "our system id is not known yet";
        if ((flight.Health.Reasons & HealthReasons.AddressConflict) != 0)
        {
            return $"another vehicle has our system id {MissionNumbers.Of(SystemId)}, or two links lead to ours: each "
                + "vehicle needs one of its own";
        }

        foreach ((byte id, GroupTraffic traffic) in _members.PresentTraffic(flight.Now))
        {
            GroupReport report = traffic.Report;
            NedPosition off = LocalNedFrame.IgnoringGeoid(flight.Vehicle.Position).ToNed(report.LandingPlace);
            double apart = new PlanePoint(off.North, off.East).Length;
            if (apart < MinLandingDistanceMetres)
            {
                return $"vehicle {MissionNumbers.Of(id)} lands {MissionNumbers.Of(apart)} m from here; at least "
                    + $"{MissionNumbers.Of(MinLandingDistanceMetres)} m are needed";
            }

            if (GroupSeparation.IsInTheWayOfTheClimb(flight.Vehicle.Position, _own, report))
                return $"vehicle {MissionNumbers.Of(id)} flies over this place, in the way of the climb";

            // Of another mission it is not known whether it flies over the same ground.
            double height = Math.Abs(report.SearchAltitudeAmslMetres - _own.SearchAltitudeAmslMetres);
            if (height < GroupOptions.SeparationMetres && _members.IsPresent(id, flight.Now) && GoesFirst(id, report))
            {
                return $"vehicle {MissionNumbers.Of(id)} searches {MissionNumbers.Of(height)} m above or below our "
                    + $"height; at least {MissionNumbers.Of(GroupOptions.SeparationMetres)} m are needed: "
                    + $"each needs a {nameof(GroupOptions.HeightLayer)} of its own, far enough from the next one for "
                    + $"the errors of heights ({nameof(GroupOptions.LayerSpacingMetres)})";
            }
        }

        return null;
    }

    private bool GoesFirst(byte id, in GroupReport report) => report.State switch
    {
        GroupMemberState.Available or GroupMemberState.Following => true,
        GroupMemberState.Waiting => id < SystemId || IsInTheAir(report),
        _ => IsInTheAir(report),
    };

    private static bool IsInTheAir(in GroupReport report)
        => report.Position.AltitudeAmslMetres - report.LandingPlace.AltitudeAmslMetres > FlyingMetres;
}
