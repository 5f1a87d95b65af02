using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// What the others know of us.
internal sealed partial class MissionGroup
{
    // A barometer that drifts further, or a satellite receiver that is wrong, must not lead us to the ground.
    private const double MaxOffsetMetres = 5;

    // Goals are not to change all the time.
    private const double OffsetStepMetres = 0.5;

    private readonly AltitudeCorrection _altitude = new();
    private double? _reference;   // the correction on the ground, or when it was first known in the air

    private GroupReport ReportOf(MissionFlight flight, MissionPhase phase)
    {
        GeodeticPosition landing = Raised(
            flight.Plan?.Frame.Origin ?? flight.Vehicle.Position, _reference ?? 0);
        EnergyStatus energy = flight.Energy.Status;
        return new GroupReport
        {
            LanesKey = KeyOf(flight.Mission),
            State = StateOf(flight, phase),
            Position = Raised(flight.Vehicle.Position, _altitude.Metres ?? 0),
            LandingPlace = landing,
            SearchAltitudeAmslMetres = landing.AltitudeAmslMetres + flight.Mission.HeightMetres,
            SpeedMetresPerSecond = flight.Mission.SpeedMetresPerSecond,
            SearchTime = energy.IsKnown ? energy.TimeToReturn : TimeSpan.OfSeconds(UnlimitedSeconds),
            MetresLeft = _doneSince is null ? flight.Route?.MetresLeft ?? 0 : 0,
            SeenFraction = flight.Route?.Coverage.Fraction ?? 0,
            DivisionAuthor = _division.Author,
            DivisionNumber = _division.Number,
        };
    }

    // The autopilot holds what its barometer says: the goals follow the drift, so that the true height stays.
    private void UpdateAltitude(MissionFlight flight)
    {
        _altitude.Update(flight.Vehicle, flight.Now);
        _reference = flight.IsFlying ? _reference ?? _altitude.Metres : _altitude.Metres;
        double offset = LimitedOffset(flight, -(_altitude.Metres - _reference ?? 0));
        if (Math.Abs(offset - flight.HeightOffsetMetres) >= OffsetStepMetres)
            flight.HeightOffsetMetres = OffsetStepMetres * Math.Truncate(offset / OffsetStepMetres);
    }

    private static double LimitedOffset(MissionFlight flight, double metres)
    {
        MissionPlan mission = flight.Mission;
        double revisit = mission.Revisit.HeightMetres ?? mission.HeightMetres;
        double up = (mission.MaxHeightMetres ?? MissionPlanRules.MaxHeightMetres) - MissionPlanRules.HeightReserveMetres
            - Math.Max(mission.HeightMetres, revisit);
        double down = Math.Min(mission.HeightMetres, revisit) - MissionPlanRules.MinHeightMetres;
        return Math.Max(
            -Math.Min(MaxOffsetMetres, Math.Max(0, down)),
            Math.Min(Math.Min(MaxOffsetMetres, Math.Max(0, up)), metres));
    }

    private static GeodeticPosition Raised(GeodeticPosition position, double metres) => GeodeticPosition.FromRadians(
        position.Latitude.Radians, position.Longitude.Radians, position.AltitudeAmslMetres + metres);

    // Who cannot command its autopilot can take over nothing.
    private GroupMemberState StateOf(MissionFlight flight, MissionPhase phase) => phase switch
    {
        MissionPhase.WaitingForVehicle or MissionPhase.Holding => GroupMemberState.Waiting,
        _ when !flight.IsConnected => GroupMemberState.Leaving,
        MissionPhase.Revisiting when CurrentFollow is not null => GroupMemberState.Following,
        MissionPhase.Arming or MissionPhase.TakingOff or MissionPhase.InTransit or MissionPhase.Searching
            or MissionPhase.Revisiting => GroupMemberState.Available,
        _ => GroupMemberState.Leaving,
    };
}
