using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>How a flight of the matrix ended, and where its report contradicts the truth.</summary>
internal static class MatrixJudge
{
    // The report counts 3 m by the estimated position, which is up to 2 m from the true one.
    private const double MaxTrueDistanceMetres = 5;

    private static readonly Regex OurLanding = new(@"command \d+: land\b", RegexOptions.CultureInvariant);

    private static readonly Regex OurHold = new("-> Holding: no progress", RegexOptions.CultureInvariant);

    public static MatrixEnd EndOf(MatrixFlight flight)
    {
        MissionStatus mission = flight.Mission;
        if (flight.Hangs)
            return MatrixEnd.Undefined;
        if (flight.Truth.HasCrashed)
            return MatrixEnd.Falls;
        return mission.Phase switch
        {
            MissionPhase.HandedOver => EndOfTakeover(mission.TakenOver ?? string.Empty),
            MissionPhase.Done => EndOfLanding(flight),
            MissionPhase.Failed when flight.Truth is { HasFlown: true, IsArmed: false, IsAirborne: false }
                => MatrixEnd.LandedWithoutUs,
            MissionPhase.Holding when mission.StopResult == MissionStopResult.Held => MatrixEnd.HoldsAtStop,
            MissionPhase.Returning or MissionPhase.Landing when mission.StopResult == MissionStopResult.None
                => MatrixEnd.StopsInItsReturn,
            _ => MatrixEnd.Undefined,
        };
    }

    /// <summary>What is wrong, whatever the end is.</summary>
    public static IEnumerable<string> FindFaults(MatrixFlight flight, FaultCell cell)
    {
        if (flight.PhaseAtFault != cell.Phase)
            yield return $"it went wrong in phase {flight.PhaseAtFault}";
        foreach (string fault in FindFaultsOfReport(flight).Concat(FindFaultsOfTakeover(flight, cell)))
            yield return fault;
        if (flight.Flight.Camera.BufferHolders().Count > 0)
            yield return "buffers of pictures are held";
    }

    private static MatrixEnd EndOfTakeover(string takenOver)
    {
        if (takenOver.StartsWith("the pilot took over", StringComparison.Ordinal))
            return MatrixEnd.PilotHasIt;
        if (takenOver.StartsWith("the autopilot's failsafe took over", StringComparison.Ordinal))
            return MatrixEnd.FailsafeHasIt;
        if (takenOver.StartsWith("another commander took over", StringComparison.Ordinal))
            return MatrixEnd.OtherCommanderHasIt;
        return takenOver.StartsWith("the autopilot rebooted", StringComparison.Ordinal)
            ? MatrixEnd.Rebooted
            : MatrixEnd.Undefined;
    }

    private static MatrixEnd EndOfLanding(MatrixFlight flight)
    {
        MissionResult result = flight.Mission.Result;
        if (result.Outcome == MissionOutcome.Accomplished)
            return MatrixEnd.Accomplished;
        bool isAway = TrueDistance(flight.Truth) > MaxTrueDistanceMetres
            || (result.Failures & MissionFailures.AwayFromHome) != 0;
        if (isAway || OurLanding.IsMatch(flight.Flight.Log))
            return MatrixEnd.LandsWhereItIs;
        return OurHold.IsMatch(flight.Flight.Log)
            ? MatrixEnd.HoldsThenReturns
            : MatrixEnd.ReturnsAndLands;
    }

    private static IEnumerable<string> FindFaultsOfReport(MatrixFlight flight)
    {
        SimulatedTruth truth = flight.Truth;
        MissionStatus mission = flight.Mission;
        bool isAccomplished = mission.Result.Outcome == MissionOutcome.Accomplished;
        if (isAccomplished && (truth.IsAirborne || truth.IsArmed))
            yield return "reported accomplished, and it is flying";
        if (isAccomplished && truth.HasCrashed)
            yield return "reported accomplished, and it crashed";
        if (isAccomplished && mission.TakenOver is not null)
            yield return "reported accomplished, and it was taken over: " + mission.TakenOver;
        if (isAccomplished && mission.Coverage < 0.98)
            yield return FormattableString.Invariant($"reported accomplished with {mission.Coverage:P0} seen");
        if (isAccomplished && TrueDistance(truth) > MaxTrueDistanceMetres)
            yield return FormattableString.Invariant($"reported accomplished {TrueDistance(truth):0} m from home");
        if (mission.Result.HasLanded && truth.IsAirborne)
            yield return "reported landed, and it is in the air";
        if (mission.Result.HasLanded && truth.HasCrashed)
            yield return "reported landed, and it crashed";
        if (mission.Phase == MissionPhase.Done && (truth.IsAirborne || truth.IsArmed))
            yield return "reported done, and it is flying";
        if (mission.Result.HasFlown != truth.HasFlown)
            yield return $"reported flown: {mission.Result.HasFlown}, truly {truth.HasFlown}";
    }

    private static IEnumerable<string> FindFaultsOfTakeover(MatrixFlight flight, FaultCell cell)
    {
        foreach (SentCommand sent in flight.SentAfterTakeover())
        {
            yield return FormattableString.Invariant(
                $"{sent.What} was sent at {sent.Time.TotalSeconds:0.00} s, after the takeover at {flight.Authority.Since.TotalSeconds:0.00} s");
            break;
        }

        if (cell.Expected == MatrixEnd.PilotHasIt && flight.ModesAfter.Any(m => !MayFollow(flight.ModeTaken, m)))
            yield return $"the pilot's mode {flight.ModeTaken} did not stand: {string.Join(", ", flight.ModesAfter)}";
    }

    private static bool MayFollow(string mode, string next)
        => mode == next || (mode is "RTL" or "AUTO.RTL" or "AUTO.LAND" && next is "LAND" or "AUTO.LAND" or "AUTO.LOITER");

    private static double TrueDistance(SimulatedTruth truth)
        => Math.Sqrt((truth.Pose.Position.North * truth.Pose.Position.North)
            + (truth.Pose.Position.East * truth.Pose.Position.East));
}
