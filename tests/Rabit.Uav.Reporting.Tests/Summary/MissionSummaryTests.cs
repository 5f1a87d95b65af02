using System;
using System.IO;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>Why a mission failed, in words: by Mission Control's result and by the score.</summary>
public sealed class MissionSummaryTests
{
    [Fact]
    public void Failures_GivenUpAndTruthNotKnown_NamesTheReason()
        => Assert.Equal(
            "the search was given up before its end: no pictures",
            Assert.Single(Of(Landed(MissionFailures.GivenUp, "no pictures")).Failures));

    [Fact]
    public void Failures_GivenUpAfterAllTargetsWereFound_AreNone()
    {
        var summary = new MissionSummary(Landed(MissionFailures.GivenUp, "no pictures"), new MissionScore());

        Assert.True(summary is { HasPassed: true, Aborted: "no pictures" });
    }

    [Fact]
    public void HasPassed_FlownToItsEndAndTruthNotKnown_IsTrue() => Assert.True(Of(Landed()).HasPassed);

    [Fact]
    public void Failures_StillInTheAir_SaysWhereAndThatItIsNotCommanded()
    {
        FlightRecord record = Flown(
            new MissionResult { HasFlown = true, Failures = MissionFailures.NotLanded }, isArmed: true);

        Assert.Equal(
            "it has not landed: it is armed, 29.8 m high, in mode GUIDED; it is not commanded any more",
            Assert.Single(Of(record).Failures));
    }

    [Fact]
    public void Failures_NotFlown_SaysWhy()
        => Assert.Equal(
            "it did not fly (the autopilot refuses to arm)",
            Assert.Single(
                Of(
                    Flown(
                        new MissionResult { Failures = MissionFailures.NotFlown },
                        text: "the autopilot refuses to arm")).Failures));

    [Theory]
    [InlineData("waiting: no position", "mission not started (waiting: no position): FAILED")]
    [InlineData(null, "mission not started: FAILED")]
    public void Text_VehicleWasNeverReady_SaysWhatWasWaitedFor(string? text, string expected)
    {
        var result = new MissionResult { Failures = MissionFailures.NotFlown };
        var record = new FlightRecord { Mission = new MissionStatus { Text = text, Result = result } };

        using var written = new StringWriter();
        SummaryText.Write(written, new FlightSummary(record) { Mission = Of(record) });

        Assert.Contains(expected, written.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Failures_LandedWhereIsNotKnown_SaysSo()
        => Assert.Equal(
            "where it landed is not known",
            Assert.Single(Of(Landed(MissionFailures.AwayFromHome, distance: double.NaN)).Failures));

    [Fact]
    public void Failures_OutsideTheFence_SaysHowFar()
        => Assert.Equal(
            "it was 4.0 m outside the fence",
            Assert.Single(
                Of(Flown(new MissionResult { HasFlown = true, HasLanded = true, OutsideFenceMetres = 4 })).Failures));

    [Fact]
    public void Failures_FarFromHomeInTruth_CountsTheTruth()
    {
        var summary = new MissionSummary(Landed(), new MissionScore { DistanceFromHomeMetres = 3.1 });

        Assert.Equal(["it landed 3.1 m from home"], summary.Failures);
        Assert.True(
            new MissionSummary(Landed(MissionFailures.AwayFromHome, distance: 3.2), new MissionScore
            {
                DistanceFromHomeMetres = 2.9
            }).HasPassed);
    }

    [Fact]
    public void Failures_TargetMissedAndFalseTrack_NamesBoth()
    {
        FlightRecord record = MadeUpFlight.Record(finds: 4, hasFalseTrack: true);

        Assert.Equal(
            ["target T5 (magenta) was not found", "track 8 (red) was confirmed and is not a target"],
            new MissionSummary(record, MadeUpTargets.Score(record)).Failures);
    }

    [Fact]
    public void Figures_GoodFlight_AreThoseOfTheRecord()
    {
        FlightRecord record = MadeUpFlight.Record();
        var summary = new MissionSummary(record, MadeUpTargets.Score(record));

        Assert.Empty(summary.Failures);
        Assert.Equal(0.64, summary.DistanceFromHomeMetres, 2);
        Assert.Equal(35, summary.BatteryUsedPercent, 3);
    }

    [Fact]
    public void Failures_TakenOverAndLandedAtHome_SaysByWhom()
    {
        FlightRecord record = Landed(MissionFailures.TakenOver, takenOver: "the pilot took over: mode RTL");
        Assert.Equal(
            "the pilot took over: mode RTL",
            Assert.Single(new MissionSummary(record, new MissionScore()).Failures));
    }

    [Fact]
    public void HasPassed_WithoutTruth_DoesNotCountTargets()
        => Assert.True(Of(MadeUpFlight.Record(finds: 0)) is { HasPassed: true, Score: null });

    private static MissionSummary Of(FlightRecord record) => new(record, score: null);

    private static FlightRecord Landed(
        MissionFailures failures = MissionFailures.None, string? aborted = null, double distance = 0.5,
        string? takenOver = null)
        => Flown(
            new MissionResult
            {
                HasFlown = true,
                HasLanded = true,
                DistanceFromHomeMetres = distance,
                Failures = failures
            },
            aborted: aborted, takenOver: takenOver);

    private static FlightRecord Flown(
        in MissionResult result, string? aborted = null, bool isArmed = false, string? text = null,
        string? takenOver = null)
        => new()
        {
            Mission = new MissionStatus
            {
                TakenOver = takenOver,
                Plan = MadeUpSite.Plan,
                Phase = MissionPhase.Done,
                Aborted = aborted,
                Text = text,
                Result = result
            },
            Vehicle = new VehicleState
            {
                IsArmed = isArmed,
                Mode = "GUIDED",
                HeightAboveHomeMetres = 29.8,
                PositionTime = TimeSpan.FromSeconds(90),
                Position = MadeUpSite.Home,
            },
        };
}
