using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading.Tasks;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>The fault matrix: docs/fault-matrix.md.</summary>
public sealed class FaultMatrixTests(ITestOutputHelper output)
{
    // How long a vehicle that was handed over is watched.
    private static readonly TimeSpan Watch = TimeSpan.FromSeconds(20);
    private static readonly TimeSpan ShortWatch = TimeSpan.FromSeconds(8);

    [Fact, Trait("Category", "Long")]
    public void Matrix_EveryCell_EndsAsWrittenBefore()
    {
        var clock = Stopwatch.StartNew();
        CellResult[] results = Fly(Selected(), Watch);
        foreach (CellResult result in results)
            output.WriteLine(result + (results.Length < 5 ? "\n" + result.Log : string.Empty));
        CellResult[] wrong = results.Where(r => r.IsAsExpected == r.Cell.Known is not null).ToArray();
        output.WriteLine(FormattableString.Invariant(
            $"{results.Length} flights, {results.Count(r => !r.IsAsExpected)} not as expected, {wrong.Length} of them or of the known ones new, {clock.Elapsed.TotalSeconds:0} s"));
        FaultMatrixDocument.Update(results, clock.Elapsed);
        Assert.True(wrong.Length == 0, string.Join("\n", wrong.Select(r => r.ToString())));
    }

    [Fact]
    public void Matrix_ShortCells_EndAsWrittenBefore()
    {
        List<FaultCell> cells = FaultMatrixCells.Short.ToList();
        Assert.True(cells.Count >= 30, $"{cells.Count}");
        CellResult[] results = Fly(cells, ShortWatch);
        foreach (CellResult result in results)
            output.WriteLine(result.ToString());
        string wrong = string.Join("\n", results.Where(r => !r.IsAsExpected).Select(r => r + "\n" + r.Log));
        Assert.True(wrong.Length == 0, wrong);
    }

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Matrix_NothingGoesWrong_IsAccomplished(SimulatedAutopilot model)
    {
        MissionStatus end = NominalTimeline.Of(model, FaultMatrixCells.Seeds[0]).Result;
        Assert.Equal((MissionPhase.Done, MissionOutcome.Accomplished), (end.Phase, end.Result.Outcome));
    }

    [Fact]
    public void Matrix_HasAtLeastTwoHundredCells()
    {
        Assert.True(FaultMatrixCells.All.Count >= 200, $"{FaultMatrixCells.All.Count}");
        Assert.Equal(
            FaultMatrixCells.All.Count,
            FaultMatrixCells.All.Select(c => (c.Fault.Name, c.Phase, c.Model)).Distinct().Count());
    }

    // RABIT_MATRIX flies only the cells whose name contains it: "Px4, link silent".
    private static List<FaultCell> Selected()
    {
        string part = Environment.GetEnvironmentVariable("RABIT_MATRIX") ?? string.Empty;
        return FaultMatrixCells.All.Where(c => Regex.IsMatch(c.ToString(), Regex.Escape(part))).ToList();
    }

    private static CellResult[] Fly(List<FaultCell> cells, TimeSpan watch)
    {
        var results = new ConcurrentDictionary<int, CellResult>();
        Parallel.For(
            0, cells.Count, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            index => results[index] = CellResult.Fly(cells[index], watch));
        return results.OrderBy(r => r.Key).Select(r => r.Value).ToArray();
    }
}
