using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>What came of one flight of the matrix.</summary>
internal sealed class CellResult
{
    private CellResult(FaultCell cell, TimeSpan at, MatrixFlight flight, TimeSpan took)
    {
        (Cell, At, Took) = (cell, at, took);
        Ended = MatrixJudge.EndOf(flight);
        Faults = MatrixJudge.FindFaults(flight, cell).ToArray();
        Log = flight.Flight.Log;
        Text = FormattableString.Invariant(
            $"{flight.Mission.Phase} {flight.Mission.Result.Outcome} ({flight.Mission.Result.Failures}), '{flight.Mission.Text}', taken over: {flight.Mission.TakenOver ?? "no"}, aborted: {flight.Mission.Aborted ?? "no"}, truly in {flight.Truth.Mode}, airborne {flight.Truth.IsAirborne}, crashed {flight.Truth.HasCrashed}");
    }

    public FaultCell Cell { get; }

    /// <summary>When it went wrong, by the clock of the run.</summary>
    public TimeSpan At { get; }

    /// <summary>How long the flight took to simulate.</summary>
    public TimeSpan Took { get; }

    public MatrixEnd Ended { get; }

    /// <summary>What the report says and the truth does not, and what was sent and must not be.</summary>
    public IReadOnlyList<string> Faults { get; }

    public string Text { get; }

    public string Log { get; }

    public bool IsAsExpected => Ended == Cell.Expected && Faults.Count == 0;

    public static CellResult Fly(FaultCell cell, TimeSpan watch)
    {
        NominalTimeline nominal = NominalTimeline.Of(cell.Model, cell.Seed);
        TimeSpan at = nominal.TimeOf(cell.Phase);
        TimeSpan? holdAt = cell.Phase == MissionPhase.Holding ? nominal.HoldAt : null;
        var clock = Stopwatch.StartNew();
        using var flight = new MatrixFlight(cell, cell.Model, cell.Seed, at, holdAt);
        flight.Fly(watch);
        return new CellResult(cell, at, flight, clock.Elapsed);
    }

    public override string ToString()
        => FormattableString.Invariant(
            $"{(IsAsExpected ? "as expected" : "NOT AS EXPECTED")}: {Cell} at {At.TotalSeconds:0.0} s: {Ended}, expected {Cell.Expected} ({Cell.Reason}); {Took.TotalSeconds:0.0} s. {string.Join("; ", Faults)}")
            + (IsAsExpected ? string.Empty : "\n    " + Text);
}
