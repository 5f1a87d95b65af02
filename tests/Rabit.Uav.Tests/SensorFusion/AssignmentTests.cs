using System;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Rabit.Uav.SensorFusion;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion;

public class AssignmentTests(ITestOutputHelper output)
{
    [Fact]
    public void Solve_ReferenceCases_FindsTheLeastTotal()
    {
        using JsonDocument data = TestData.Autonomy("tracking.json");
        foreach (JsonElement sample in data.RootElement.GetProperty("assignment").EnumerateArray())
        {
            double?[][] costs = sample.GetProperty("cost").EnumerateArray()
                .Select(row => row
                    .EnumerateArray()
                    .Select(c => c.ValueKind == JsonValueKind.Null ? (double?)null : c.GetDouble())
                    .ToArray()).ToArray();
            double miss = sample.GetProperty("miss_cost").GetDouble();
            Assert.Equal(
                sample.GetProperty("min_total_with_miss").GetDouble(),
                Total(costs, sample.GetProperty("cols").GetInt32(), miss), 1e-9);
        }
    }

    [Theory]
    [InlineData(11)]
    [InlineData(12)]
    public void Solve_RandomSmallCases_IsAsGoodAsTryingAll(int seed)
    {
        output.WriteLine($"seed {seed}");
        var random = new SeededNumbers(seed);
        for (int i = 0; i < 300; i++)
        {
            int rows = random.Below(6);
            int columns = random.Below(6);
            double?[][] costs = Enumerable.Range(0, rows).Select(_ => Enumerable.Range(0, columns)
                .Select(_ => random.Below(4) == 0 ? (double?)null : random.Uniform(-10, 20)).ToArray()).ToArray();
            double miss = random.Uniform(0, 25);
            Assert.True(
                Math.Abs(Total(costs, columns, miss) - TryAll(costs, 0, 0, miss)) < 1e-9, $"seed {seed}, case {i}");
        }
    }

    [Fact]
    public void Solve_SteadyState_AllocatesNothing()
    {
        var assignment = new Assignment();
        void Work()
        {
            assignment.Begin(8, 10, 100);
            for (int i = 0; i < 8; i++)
                assignment.Allow(i, (i * 3) % 10, i);
            assignment.Solve();
        }

        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    private static double Total(double?[][] costs, int columns, double miss)
    {
        var assignment = new Assignment();
        assignment.Begin(costs.Length, columns, miss);
        for (int r = 0; r < costs.Length; r++)
        {
            for (int c = 0; c < columns; c++)
            {
                if (costs[r][c] is { } cost)
                    assignment.Allow(r, c, cost);
            }
        }

        assignment.Solve();
        int[] taken = Enumerable.Range(0, costs.Length).Select(assignment.ColumnOf).ToArray();
        Assert.Equal(taken.Count(c => c >= 0), taken.Where(c => c >= 0).Distinct().Count());
        return taken.Select((column, row) => column < 0 ? miss : costs[row][column]!.Value).Sum();
    }

    private static double TryAll(double?[][] costs, int row, int taken, double miss)
    {
        if (row == costs.Length)
            return 0;
        double best = miss + TryAll(costs, row + 1, taken, miss);
        for (int c = 0; c < costs[row].Length; c++)
        {
            if ((taken & (1 << c)) == 0 && costs[row][c] is { } cost)
                best = Math.Min(best, cost + TryAll(costs, row + 1, taken | (1 << c), miss));
        }

        return best;
    }
}
