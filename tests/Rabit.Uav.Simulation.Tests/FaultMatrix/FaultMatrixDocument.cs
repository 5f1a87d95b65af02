using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>
/// Writes docs/fault-matrix.md, where RABIT_UPDATE_DOCS=1 asks for it and the whole matrix was flown.
/// </summary>
internal static class FaultMatrixDocument
{
    private const string Introduction =
        """
        # Fault matrix

        Fault x phase x autopilot, each flown in the simulation by all six managers. How each flight has to end was written before it was flown, with the reason
        (`FaultMatrixCells` in tests/Rabit.Uav.Simulation.Tests/FaultMatrix). A flight that ends otherwise fails, and so does one whose report says what the truth does not: accomplished though taken
        over, landed though crashed, a command sent after a takeover. In the phase Holding the operator holds in a lane and has the search resumed 25 s after the fault.

        `RABIT_UPDATE_DOCS=1 dotnet test -s tests/long.runsettings tests/Rabit.Uav.Simulation.Tests --filter FullyQualifiedName~FaultMatrixTests` flies it and writes this page;
        `RABIT_MATRIX="Px4, link silent"` flies the cells whose name contains that.

        The failsafes of the simulated autopilots are set as the pre-flight checklist wants them, with a ground station on its own radio: `MatrixWorld`.

        """;

    public static void Update(IReadOnlyList<CellResult> results, TimeSpan took)
    {
        bool isAsked = Environment.GetEnvironmentVariable("RABIT_UPDATE_DOCS") == "1";
        if (isAsked && results.Count == FaultMatrixCells.All.Count)
            File.WriteAllText(Path.Combine(Repository.Root, "docs", "fault-matrix.md"), Write(results, took));
    }

    private static string Write(IReadOnlyList<CellResult> results, TimeSpan took)
    {
        var text = new StringBuilder(Introduction.Replace("\r\n", "\n"));
        int wrong = results.Count(r => !r.IsAsExpected);
        text.Append(FormattableString.Invariant(
            $"Flown: {results.Count} flights, {wrong} not as expected, at commit {Commit()}, in {took.TotalSeconds:0} s"));
        text.Append(FormattableString.Invariant($" on {Environment.ProcessorCount} cores.\n\n"));
        text.Append("| sign | the flight ends |\n|---|---|\n");
        foreach (KeyValuePair<char, MatrixEnd> letter in FaultMatrixCells.Letters)
            text.Append(FormattableString.Invariant($"| {letter.Key} | {Describe(letter.Value)} |\n"));
        text.Append("\nA sign with an exclamation mark: not as expected; what was expected is in brackets. Those are ")
            .Append("known: below.\n\n");
        text.Append("| fault | autopilot | seed |")
            .Append(string.Concat(FaultMatrixCells.Phases.Select(p => $" {p} |")));
        text.Append(" seconds | reason |\n|---|---|---|");
        text.Append(string.Concat(FaultMatrixCells.Phases.Select(_ => "---|"))).Append("---|---|\n");
        foreach (IGrouping<(string, SimulatedAutopilot), CellResult> row in results.GroupBy(
            r => (r.Cell.Fault.Name, r.Cell.Model)))
            WriteRow(text, row.ToArray());
        text.Append("\n## Known\n\n| cell | why |\n|---|---|\n");
        foreach (CellResult result in results.Where(r => r.Cell.Known is not null))
            text.Append(FormattableString.Invariant($"| {result.Cell} | {result.Cell.Known} |\n"));
        return text.ToString();
    }

    private static void WriteRow(StringBuilder text, CellResult[] row)
    {
        FaultCell cell = row[0].Cell;
        text.Append(FormattableString.Invariant($"| {cell.Fault.Name} | {cell.Model} | {cell.Seed} |"));
        foreach (MissionPhase phase in FaultMatrixCells.Phases)
            text.Append(' ').Append(Letter(row.SingleOrDefault(r => r.Cell.Phase == phase))).Append(" |");
        text.Append(FormattableString.Invariant($" {row.Sum(r => r.Took.TotalSeconds):0} | {cell.Reason} |\n"));
    }

    private static string Letter(CellResult? result)
    {
        if (result is null)
            return string.Empty;
        char expected = FaultMatrixCells.Letters.Single(l => l.Value == result.Cell.Expected).Key;
        if (result.IsAsExpected)
            return expected.ToString();
        if (result.Ended == result.Cell.Expected)
            return expected + "!";
        char ended = FaultMatrixCells.Letters.Where(l => l.Value == result.Ended).Select(l => l.Key)
            .Append('?').First();
        return $"{ended}! ({expected})";
    }

    private static string Describe(MatrixEnd end) => end switch
    {
        MatrixEnd.Accomplished => "the mission goes on and is accomplished",
        MatrixEnd.ReturnsAndLands => "the mission is given up; the vehicle returns and lands at home",
        MatrixEnd.LandsWhereItIs => "the vehicle lands elsewhere than at home, or where is not known",
        MatrixEnd.HoldsThenReturns => "no progress: the vehicle holds, then returns and lands at home",
        MatrixEnd.PilotHasIt => "handed over: the pilot's mode stands, nothing more is sent",
        MatrixEnd.FailsafeHasIt => "handed over: the autopilot's failsafe acts, nothing more is sent",
        MatrixEnd.OtherCommanderHasIt => "handed over: another commander's target stands, nothing more is sent",
        MatrixEnd.Rebooted => "handed over: the autopilot has rebooted, nothing more is sent",
        MatrixEnd.Falls => "the vehicle falls; the report claims neither a landing nor a mission accomplished",
        MatrixEnd.LandedWithoutUs => "reported failed: the vehicle stands on the ground, disarmed, without a command of ours",
        MatrixEnd.HoldsAtStop => "the program ends once the vehicle holds",
        _ => "the program ends and leaves the vehicle in its return or landing",
    };

    // The head of the repository, by its files.
    private static string Commit()
        => Environment.GetEnvironmentVariable("RABIT_COMMIT") ?? "unknown";
}
