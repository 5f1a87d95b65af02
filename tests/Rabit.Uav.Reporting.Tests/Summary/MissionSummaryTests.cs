using System;
using System.IO;
using System.Text.Json;
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
    public void HasPassed_FlownToItsEndAndTruthNotKnown_IsTrue() => Assert.True(Of(Landed()).HasPassed);

    // Finding mission.md 19: 93.4 % were accomplished. The truth of the targets does not make up for it.
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Failures_AreaNotSeen_IsTheFirst(bool isTruthKnown)
    {
        var summary = new MissionSummary(
            NotSeen(MissionFailures.GivenUp), isTruthKnown ? new MissionScore() : null);

        Assert.False(summary.HasPassed);
        Assert.Equal("the area was not fully seen: 93.4 % of it, 98 % are required", summary.Failures[0]);
        Assert.Equal(summary.Failures[0], summary.Headlines[0]);
        Assert.Equal(98, summary.RequiredCoveragePercent, 6);
    }

    [Theory]
    [InlineData(1, "the operator skipped a lane")]
    [InlineData(3, "the operator skipped 3 lanes")]
    public void Failures_AreaNotSeenAndLanesSkipped_SaysSo(int lanes, string expected)
        => Assert.Equal(
            "the area was not fully seen: 93.4 % of it, 98 % are required; " + expected,
            Of(NotSeen(lanesSkipped: lanes)).Failures[0]);

    [Theory]
    [InlineData(true, 0.98, "nothing was found: no target was confirmed")]
    [InlineData(false, 0, "nothing was searched for: there was no camera")]
    public void Headlines_NoTargetConfirmed_SaysSo(bool hasCamera, double required, string expected)
    {
        MissionSummary summary = Of(Landed(result: Home with { RequiredCoverage = required }, hasCamera: hasCamera));

        Assert.Equal([expected], summary.Headlines);
        Assert.True(summary.HasPassed);
    }

    [Fact]
    public void Headlines_TargetsFound_AreNone() => Assert.Empty(Of(MadeUpFlight.Record()).Headlines);

    [Fact]
    public void Headlines_NotFlown_SaySoFirst()
    {
        MissionSummary summary = Of(Flown(new MissionResult { Failures = MissionFailures.NotFlown }));
        Assert.Equal(["it did not fly"], summary.Headlines);
        Assert.Equal("it did not fly", summary.Failures[0]);
    }

    [Fact]
    public void Text_AreaNotSeenAndNothingFound_IsSaidFirst()
    {
        using var written = new StringWriter();
        FlightRecord record = NotSeen();
        SummaryText.Write(written, new FlightSummary(record) { Mission = Of(record), StopReason = "over" });

        string[] lines = written.ToString().Split('\n');
        Assert.Equal("--- summary: over ---", lines[0].TrimEnd());
        Assert.Equal("ATTENTION: the area was not fully seen: 93.4 % of it, 98 % are required", lines[1].TrimEnd());
        Assert.Equal("ATTENTION: nothing was found: no target was confirmed", lines[2].TrimEnd());
    }

    [Fact]
    public void Html_AreaNotSeenAndNothingFound_IsSaidBeforeTheMap()
    {
        using var written = new StringWriter();
        FlightRecord record = NotSeen();
        HtmlReport.Write(written, new FlightSummary(record) { Mission = Of(record) });

        string page = written.ToString();
        int tiles = page.IndexOf("class=\"tiles\"", StringComparison.Ordinal);
        Assert.InRange(page.IndexOf("the area was not fully seen: 93.4 %", StringComparison.Ordinal), 1, tiles);
        Assert.InRange(page.IndexOf("nothing was found", StringComparison.Ordinal), 1, tiles);
        Assert.Contains("98 % required", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Json_AreaNotSeen_SaysWhatIsRequired()
    {
        using JsonDocument json = Json(NotSeen());
        JsonElement mission = json.RootElement.GetProperty("mission");

        Assert.Equal(98, mission.GetProperty("requiredCoveragePercent").GetDouble(), 3);
        Assert.Equal(2, mission.GetProperty("headlines").GetArrayLength());
        Assert.Equal(JsonValueKind.Null, mission.GetProperty("energy").ValueKind);
    }

    [Fact]
    public void Energy_Known_IsInTextAndJson()
    {
        FlightRecord record = MadeUpFlight.Record();
        using var written = new StringWriter();
        SummaryText.Write(written, new FlightSummary(record) { Mission = Of(record) });
        using JsonDocument json = Json(record);
        JsonElement energy = json.RootElement.GetProperty("mission").GetProperty("energy");

        Assert.Contains(
            "energy: 58 % left (+- 3 %) of a battery with 91 % of its stated capacity (+- 5 %)", written.ToString(),
            StringComparison.Ordinal);
        Assert.Equal(58, energy.GetProperty("leftPercent").GetDouble(), 3);
        Assert.Equal(290, energy.GetProperty("planSeconds").GetDouble(), 3);
    }

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

    // --hold and --return: there is no plan, and so no home that we know.
    [Fact]
    public void Failures_OnlyBroughtDown_SaysWhoKnowsWhereHomeIs()
    {
        MissionSummary summary = Of(new FlightRecord
        {
            Mission = new MissionStatus { Result = Home with { DistanceFromHomeMetres = double.NaN } },
        });

        Assert.Equal(
            "nothing was searched: the vehicle was flying already and was only brought down; how far from home it "
                + "landed only the autopilot knows",
            Assert.Single(summary.Failures));
        Assert.Empty(summary.Headlines);
    }

    [Fact]
    public void Text_OnlyBroughtDown_DoesNotSayThatItWasNotStarted()
    {
        var record = new FlightRecord { Mission = new MissionStatus { Text = "landed", Result = Home } };

        using var written = new StringWriter();
        SummaryText.Write(written, new FlightSummary(record) { Mission = Of(record) });

        Assert.Contains("flown without a plan (landed): ", written.ToString(), StringComparison.Ordinal);
    }

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

    // With all its targets found it has passed only where a coverage was required, and reached.
    [Theory]
    [InlineData(0, "the search was given up before its end: the wind")]
    [InlineData(0.9, null)]
    public void Failures_GivenUpAfterAllTargetsWereFound_DependOnTheRequiredCoverage(double required, string? expected)
    {
        var result = new MissionResult
        {
            HasFlown = true,
            HasLanded = true,
            Failures = MissionFailures.GivenUp,
            RequiredCoverage = required,
        };
        var record = new FlightRecord
        {
            Mission = new MissionStatus { Plan = MadeUpSite.Plan, Result = result, Aborted = "the wind" },
        };

        var summary = new MissionSummary(record, new MissionScore { DistanceFromHomeMetres = 0.4 });

        Assert.Equal(expected is null ? [] : [expected], summary.Failures);
        Assert.Equal(expected is null, summary.HasPassed);
        Assert.Equal("the wind", summary.Aborted);
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
        Assert.Equal(0.58, summary.Energy.ChargeLeft);
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

    private static MissionResult Home => new() { HasFlown = true, HasLanded = true, DistanceFromHomeMetres = 0.5 };

    private static MissionSummary Of(FlightRecord record) => new(record, score: null);

    private static FlightRecord NotSeen(MissionFailures failures = MissionFailures.None, int lanesSkipped = 0)
        => Landed(
            result: Home with { RequiredCoverage = 0.98, Failures = MissionFailures.AreaNotSeen | failures },
            coverage: 0.934, hasCamera: true, lanesSkipped);

    private static JsonDocument Json(FlightRecord record)
    {
        using var written = new MemoryStream();
        SummaryJson.Write(written, new FlightSummary(record) { Mission = Of(record) });
        return JsonDocument.Parse(written.ToArray());
    }

    private static FlightRecord Landed(
        MissionResult result, double coverage = 1, bool hasCamera = false, int lanesSkipped = 0) => new()
        {
            Mission = new MissionStatus
            {
                Plan = MadeUpSite.Plan,
                Phase = MissionPhase.Done,
                Coverage = coverage,
                LanesSkipped = lanesSkipped,
                Result = result,
            },
            Imaging = new ImagingStatus { HasCamera = hasCamera },
        };

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
