using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>Dwell and hysteresis of a row, and which of several wins.</summary>
public class HealthRuleSetTests
{
    private static readonly HealthOptions Options = new();

    private static readonly HealthRule<Reading>[] Rows =
    [
        new(HealthReasons.WindHigh, HealthLevel.Warning, HealthAdvice.Hold)
        {
            When = static (in Reading r, HealthOptions _) => r.Value > 10,
            Until = static (in Reading r, HealthOptions _) => r.Value < 8,
            Dwell = static _ => TimeSpan.FromSeconds(2),
            ClearDwell = static _ => TimeSpan.FromSeconds(3),
            Figure = static (in Reading r) => (long)r.Value,
        },
        new(HealthReasons.WindHigh, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.WindHigh,
            When = static (in Reading r, HealthOptions _) => r.Value > 20,
        },
    ];

    [Theory]
    // shorter than the dwell
    [InlineData(new double[] { 11, 11 }, new[] { false, false })]
    [InlineData(new double[] { 11, 11, 11 }, new[] { false, false, true })]
    // interrupted: it begins again
    [InlineData(new double[] { 11, 11, 10, 11, 11, 11 }, new[] { false, false, false, false, false, true })]
    // between the two limits nothing changes, neither way
    [InlineData(new double[] { 9, 9, 9, 9 }, new[] { false, false, false, false })]
    [InlineData(new double[] { 11, 11, 11, 9, 9, 9, 9, 9 }, new[] { false, false, true, true, true, true, true, true })]
    [InlineData(new double[] { 11, 11, 11, 7, 7, 7, 7 }, new[] { false, false, true, true, true, true, false })]
    [InlineData(new double[] { 11, 11, 11, 7, 7, 9, 7, 7, 7, 7 },
        new[] { false, false, true, true, true, true, true, true, true, false })]
    public void Evaluate_DwellAndHysteresis_AreKept(double[] everySecond, bool[] expected)
    {
        var rules = new HealthRuleSet<Reading>(Rows);
        Assert.Equal(expected, everySecond.Select((value, second) => Evaluate(rules, value, second).Count > 0));
    }

    [Fact]
    public void Evaluate_TwoSubjects_AreKeptApart()
    {
        var a = new HealthRuleSet<Reading>(Rows);
        var b = new HealthRuleSet<Reading>(Rows);
        for (int second = 0; second < 3; second++)
        {
            Assert.Equal(second == 2 ? 1 : 0, Evaluate(a, 11, second).Count);
            Assert.Empty(Evaluate(b, 0, second));
        }
    }

    [Fact]
    public void Evaluate_TwoRowsOfOneReason_ReportsTheMoreSevere()
    {
        var rules = new HealthRuleSet<Reading>(Rows);
        var findings = new List<HealthFinding> { new(HealthReasons.WindHigh, HealthLevel.Warning, "other", 1) };
        for (int second = 0; second < 3; second++)
            rules.Evaluate(new Reading(25), "x", Options, TimeSpan.FromSeconds(second), findings);

        // What was found of others stays.
        Assert.Equal("other", findings[0].Subject);
        Assert.Equal(
            (HealthLevel.Critical, HealthAdvice.ReturnToLaunch),
            (findings[findings.Count - 1].Level, findings[findings.Count - 1].Advice));
        Assert.Single(Evaluate(rules, 25, 3));
    }

    private static List<HealthFinding> Evaluate(HealthRuleSet<Reading> rules, double value, int second)
    {
        var findings = new List<HealthFinding>();
        rules.Evaluate(new Reading(value), subject: null, Options, TimeSpan.FromSeconds(second), findings);
        return findings;
    }

    private readonly struct Reading(double value)
    {
        public double Value { get; } = value;
    }
}
