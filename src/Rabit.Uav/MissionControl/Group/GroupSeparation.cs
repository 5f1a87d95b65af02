using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Finds the vehicles, of the group or of another mission, that are, or soon will be, too near: less than
/// <see cref="HorizontalMetres"/> over ground and <see cref="GroupOptions.SeparationMetres"/> in height. While each is
/// in its layer there are none; one that lands where it is, or is held on its way down, is in the layers of others.
/// One thread.
/// </summary>
internal sealed class GroupSeparation(GroupMembers members)
{
    /// <summary>Vehicles of one height are at least this far apart, metres.</summary>
    public const double HorizontalMetres = 30;

    // More than has to be: positions are off, and a vehicle that is held drifts.
    private const double MarginMetres = 5;

    // Time to stop from the speed of a search, or to leave the place below one that sinks.
    private const double HorizonSeconds = 8;
    private const double StepSeconds = 0.5;

    // Within this of one's own landing place others may be near: they land beside it.
    private const double LandingMetres = 15;

    // Heights of a vehicle in its layer vary by less.
    private const double InLayerMetres = 3;

    private const double OnGroundMetres = 2;

    /// <summary>The first vehicle that we would come too near to; null where there is none.</summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="systemId">Ours.</param>
    /// <param name="own">What we report.</param>
    /// <param name="velocity">Over ground, as we would go on.</param>
    public SeparationConflict? FindConflict(
        MissionFlight flight, byte systemId, in GroupReport own, PlanePoint velocity)
    {
        if (flight.Position.Length <= LandingMetres)
            return null;
        SeparationConflict? first = null;
        foreach ((byte id, GroupTraffic traffic) in members.PresentTraffic(flight.Now))
        {
            if (IsFlying(traffic.Report) && HasPriority(id, traffic.Report, systemId, own)
                && Predict(flight, own, velocity, id, traffic) is { } conflict
                && (first is null || conflict.SecondsToGo < first.Value.SecondsToGo))
                first = conflict;
        }

        return first;
    }

    /// <summary>A vehicle below us, through whose layer we would sink here; null where there is none.</summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="own">What we report.</param>
    public byte? FindBelow(MissionFlight flight, in GroupReport own)
        => FindBetween(flight, double.NegativeInfinity, own.Position.AltitudeAmslMetres);

    /// <summary>A vehicle above us, through whose layer we would climb here; null where there is none.</summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="own">What we report.</param>
    public byte? FindAbove(MissionFlight flight, in GroupReport own) => FindBetween(
        flight, own.Position.AltitudeAmslMetres, own.SearchAltitudeAmslMetres + GroupOptions.SeparationMetres);

    // Over or under this place, or soon.
    private byte? FindBetween(MissionFlight flight, double minAltitudeAmslMetres, double maxAltitudeAmslMetres)
    {
        foreach ((byte id, GroupTraffic traffic) in members.PresentTraffic(flight.Now))
        {
            double altitude = traffic.Report.Position.AltitudeAmslMetres;
            bool isBetween = altitude >= minAltitudeAmslMetres && altitude < maxAltitudeAmslMetres;
            if (!isBetween || !IsFlying(traffic.Report))
                continue;
            for (double s = 0; s <= HorizonSeconds; s += StepSeconds)
            {
                if (flight.Position.DistanceTo(PlaceOf(flight, traffic, s)) < HorizontalMetres + MarginMetres)
                    return id;
            }
        }

        return null;
    }

    /// <summary>
    /// Whether a vehicle flies that is neither over its landing place nor sure to stay in its layer.
    /// </summary>
    public bool IsAnyOutOfLayer(TimeSpan now) => members.PresentTraffic(now).Select(t => t.Traffic.Report).Any(
        r => IsFlying(r) && (r.State == GroupMemberState.Leaving || !IsInLayer(r))
            && DistanceFromLanding(r) > LandingMetres);

    /// <summary>Whether a vehicle flies where we would climb to our layer; not one over its landing place.</summary>
    /// <param name="place">Where we stand.</param>
    /// <param name="own">What we report.</param>
    /// <param name="report">What it reports.</param>
    public static bool IsInTheWayOfTheClimb(GeodeticPosition place, in GroupReport own, in GroupReport report)
    {
        double above = report.Position.AltitudeAmslMetres - own.SearchAltitudeAmslMetres;
        return IsFlying(report) && above < GroupOptions.SeparationMetres
            && DistanceFromLanding(report) > LandingMetres
            && Distance(place, report.Position) < HorizontalMetres + MarginMetres;
    }

    private static PlanePoint PlaceOf(MissionFlight flight, GroupTraffic traffic, double seconds)
    {
        NedPosition at = flight.Plan!.Frame.ToNed(traffic.Report.Position);
        double t = Math.Max(0, (flight.Now - traffic.Time).ExactSeconds) + seconds;
        return new PlanePoint(at.North + (traffic.Velocity.North * t), at.East + (traffic.Velocity.East * t));
    }

    private static SeparationConflict? Predict(
        MissionFlight flight, in GroupReport own, PlanePoint velocity, byte id, GroupTraffic traffic)
    {
        double age = Math.Max(0, (flight.Now - traffic.Time).ExactSeconds);
        double above = traffic.Report.Position.AltitudeAmslMetres - own.Position.AltitudeAmslMetres;
        double sinks = IsInLayer(traffic.Report) && CanGiveWay(traffic.Report) ? 0 : traffic.Velocity.Down;
        for (double s = 0; s <= HorizonSeconds; s += StepSeconds)
        {
            PlanePoint place = PlaceOf(flight, traffic, s);
            double height = above - (sinks * (age + s)) - (ClimbOf(flight) * s);
            double apart = (flight.Position + (s * velocity)).DistanceTo(place);
            if (apart < HorizontalMetres + MarginMetres && Math.Abs(height) < GroupOptions.SeparationMetres)
                return new SeparationConflict(id, place, height, s);
        }

        return null;
    }

    // In its layer a vehicle only sways.
    private static double ClimbOf(MissionFlight flight)
    {
        bool isClimbing = Math.Abs(flight.GoalHeightMetres - flight.HeightMetres) > InLayerMetres;
        return isClimbing ? -flight.Vehicle.VelocityNed.Down : 0;
    }

    // Who cannot give way goes first: it lands, is held, is flown by its pilot, climbs over its landing place. Of two
    // that can it is the one that is not in its layer, since it is on its way there; else the lower system id.
    private static bool HasPriority(byte id, in GroupReport report, byte systemId, in GroupReport own)
    {
        if (!CanGiveWay(report))
            return true;
        return IsInLayer(own) == IsInLayer(report) ? id < systemId : IsInLayer(own);
    }

    private static bool CanGiveWay(in GroupReport report)
        => report.State is GroupMemberState.Available or GroupMemberState.Following
            && DistanceFromLanding(report) > LandingMetres;

    private static double DistanceFromLanding(in GroupReport report)
        => Distance(report.LandingPlace, report.Position);

    private static double Distance(GeodeticPosition a, GeodeticPosition b)
        => NedPosition.Origin.HorizontalDistanceTo(LocalNedFrame.IgnoringGeoid(a).ToNed(b));

    private static bool IsInLayer(in GroupReport report) => Math.Abs(
        report.Position.AltitudeAmslMetres - report.SearchAltitudeAmslMetres) <= InLayerMetres;

    private static bool IsFlying(in GroupReport report)
        => report.Position.AltitudeAmslMetres - report.LandingPlace.AltitudeAmslMetres > OnGroundMetres;
}
