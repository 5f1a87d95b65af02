using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Watches a mission for its <see cref="MissionResult"/>. Time-free, no I/O; one thread.</summary>
internal sealed class MissionAssessment
{
    // A vehicle that stayed below this never left the ground: the height above home is as noisy as that.
    private const double FlownHeightMetres = 1;

    private double _maxHeightMetres;
    private double _outsideFenceMetres;

    /// <summary>Takes in where the vehicle is; at each unit of work.</summary>
    public void Update(MissionFlight flight)
    {
        if (flight.Vehicle.PositionTime is null)
            return;
        if (flight.Vehicle.IsArmed)
            _maxHeightMetres = Math.Max(_maxHeightMetres, flight.HeightMetres);
        if (flight.Plan is { } plan)
            _outsideFenceMetres = Math.Max(_outsideFenceMetres, -plan.InsideMetres(flight.Position));
    }

    public MissionResult Assess(MissionFlight flight, MissionPhase phase)
    {
        bool hasFlown = _maxHeightMetres > FlownHeightMetres;
        MotorStop stop = flight.Touchdown.Stop;
        bool hasLanded = hasFlown && stop == MotorStop.Landed;
        bool isPlaceKnown = stop == MotorStop.None ? flight.Vehicle.PositionTime is not null
            : flight.Touchdown.IsPlaceKnown;
        double distance = isPlaceKnown ? flight.DistanceFromHomeMetres : double.NaN;
        // A fixed wing is landed by its pilot, on his runway.
        bool isOurLanding = !flight.IsFixedWing;
        bool isGivenUp = flight.Aborted is not null || phase == MissionPhase.Failed;
        MissionFailures failures = If(MissionFailures.GivenUp, hasFlown && isGivenUp)
            | If(MissionFailures.NotFlown, !hasFlown)
            | If(MissionFailures.CalledOff, !hasFlown && flight.IsCalledOff)
            | If(MissionFailures.NotLanded, hasFlown && !hasLanded)
            | If(
                MissionFailures.AwayFromHome,
                hasLanded && isOurLanding && !(distance <= MissionResult.MaxLandingDistanceMetres))
            | If(MissionFailures.OutsideFence, _outsideFenceMetres > 0)
            | If(MissionFailures.TakenOver, flight.IsTakenOver)
            | If(
                MissionFailures.AreaNotSeen,
                hasFlown && flight.Route is not null && flight.SeenFraction < flight.RequiredCoverage);
        return new MissionResult
        {
            Outcome = OutcomeOf(phase, failures),
            Failures = failures,
            RequiredCoverage = flight.RequiredCoverage,
            HasFlown = hasFlown,
            HasLanded = hasLanded,
            DistanceFromHomeMetres = distance,
            OutsideFenceMetres = _outsideFenceMetres,
        };
    }

    private static MissionFailures If(MissionFailures failure, bool holds) => holds ? failure : MissionFailures.None;

    private static MissionOutcome OutcomeOf(MissionPhase phase, MissionFailures failures) => phase switch
    {
        MissionPhase.NoMission => MissionOutcome.None,
        MissionPhase.Failed => MissionOutcome.Failed,
        MissionPhase.Done or MissionPhase.HandedOver
            => failures == MissionFailures.None ? MissionOutcome.Accomplished : MissionOutcome.Failed,
        _ => MissionOutcome.InProgress,
    };
}
