using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Why a command of the operator cannot be carried out now, though the phase allows it.</summary>
internal static class OperatorFaults
{
    // The vehicle holds its position over a place to within a few metres.
    private const double FenceReserveMetres = 5;

    // A revisit flies straight to its place: a vehicle that was left low climbs first, which a continue does.
    private const double LowMetres = 7;

    /// <summary>Null where it can.</summary>
    public static string? Find(MissionFlight flight, MissionPhase phase, OperatorRequest request)
    {
        bool goesOn = request.Command is not (
            OperatorCommand.Hold or OperatorCommand.Return or OperatorCommand.Land or OperatorCommand.Confirm
            or OperatorCommand.Reject);
        if (flight.IsStopRequested && goesOn)
            return "the program stops";
        return request.Command switch
        {
            OperatorCommand.Continue when phase == MissionPhase.Holding => FindNoPlan(flight),
            OperatorCommand.Land when flight.IsFixedWing => "a fixed wing is landed by its pilot",
            OperatorCommand.SkipLane => flight.Route?.Current is null ? "no lane is left" : null,
            OperatorCommand.ChangeSpeed => FindFaultOfSpeed(flight, request.SpeedMetresPerSecond),
            OperatorCommand.Confirm or OperatorCommand.Reject => FindTrackFault(flight, request.TrackId),
            OperatorCommand.Revisit or OperatorCommand.RevisitPlace => FindRevisitFault(flight, phase, request),
            _ => null,
        };
    }

    private static string? FindNoPlan(MissionFlight flight) => flight.Plan is null ? flight.PlanInFlight() : null;

    private static string? FindTrackFault(MissionFlight flight, int trackId)
        => Revisits.Find(flight, trackId) is null ? $"there is no track {MissionNumbers.Of(trackId)}" : null;

    private static string? FindFaultOfSpeed(MissionFlight flight, double metresPerSecond)
        => flight.IsFixedWing
            ? "a fixed wing flies the speed of its autopilot"
            : MissionPlanRules.FindFaultOfSpeed(metresPerSecond) ?? flight.Plan?.FindFaultOfSpeed(metresPerSecond);

    private static bool IsLow(MissionFlight flight)
        => flight.HeightMetres
            < flight.Plan!.HeightAboveHome(flight.Position, flight.Mission.HeightMetres) + flight.HeightOffsetMetres
                - LowMetres;

    private static string? FindRevisitFault(MissionFlight flight, MissionPhase phase, OperatorRequest request)
    {
        if (flight.IsFixedWing)
            return "a fixed wing revisits nothing";
        if (flight.Plan is not { } plan)
            return "where home is, is not known";
        if (phase is MissionPhase.Holding or MissionPhase.InTransit && IsLow(flight))
        {
            return $"it is low, at {MissionNumbers.Of(flight.HeightMetres)} m: "
                + (phase == MissionPhase.Holding ? "a continue comes first" : "it climbs first");
        }

        if (request.Command == OperatorCommand.RevisitPlace)
            return FindPlaceFault(flight, PlaceOf(plan, request.Place));
        if (Revisits.Find(flight, request.TrackId) is not { } track)
            return FindTrackFault(flight, request.TrackId);
        return track.State == TrackState.Rejected
            ? $"track {MissionNumbers.Of(track.Id)} was rejected"
            : FindPlaceFault(flight, Revisits.PositionOf(track, flight));
    }

    /// <summary>A place in the plane of the plan.</summary>
    public static PlanePoint PlaceOf(FlightPlan plan, GeodeticPosition place)
    {
        NedPosition ned = plan.Frame.ToNed(GeodeticPosition.FromRadians(
            place.Latitude.Radians, place.Longitude.Radians, plan.Frame.Origin.AltitudeAmslMetres));
        return new PlanePoint(ned.North, ned.East);
    }

    // Comparisons with NaN are false.
    private static string? FindPlaceFault(MissionFlight flight, PlanePoint place)
    {
        if (!(flight.Plan!.Fence.SignedDistance(place) >= FenceReserveMetres))
            return "it is at the fence or outside";
        if (RevisitPass.Plan(flight, place) is null)
            return "no pass over it stays inside the fence";
        double reach = (flight.Mission.MaxDistanceMetres ?? double.MaxValue) - MissionPlanRules.FenceReserveMetres;
        return place.Length <= reach
            ? null
            : $"it is {MissionNumbers.Of(place.Length)} m from home; the limit is {MissionNumbers.Of(reach)} m";
    }
}
