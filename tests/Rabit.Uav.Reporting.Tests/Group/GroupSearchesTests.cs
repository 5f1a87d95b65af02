using System;
using System.IO;
using System.Linq;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests.Group;

/// <summary>What became of the search where vehicles of a group gave it up.</summary>
public sealed class GroupSearchesTests
{
    private const MissionFailures CalledHome = MissionFailures.GivenUp | MissionFailures.AreaNotSeen;

    [Fact]
    public void CalledHome_OthersCompletedTheSearch_IsARemarkAndNoFailure()
    {
        var group = new GroupFlightSummary([Vehicle(1), Vehicle(2, CalledHome, 0.4)]);
        Assert.Empty(group.VehicleFailures);
        Assert.Equal(2, group.Remarks.Count);
        Assert.Equal(
            "vehicle 2: the search was given up before its end: return, by system 255; the others completed the search",
            group.Remarks[1]);
        using var page = new StringWriter();
        GroupHtmlReport.Write(page, group);
        Assert.Contains("Mission accomplished", page.ToString(), StringComparison.Ordinal);
        Assert.Contains("by system 255; the others completed", page.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void CalledHome_ByAllBeforeTheEnd_Failed()
    {
        var group = new GroupFlightSummary([Vehicle(1, CalledHome, 0.4), Vehicle(2, CalledHome, 0.4)]);
        Assert.Empty(group.Remarks);
        Assert.Equal(4, group.VehicleFailures.Count);
    }

    // As much was seen as is required: nothing was missed.
    [Fact]
    public void CalledHome_ByAllAfterAllWasSeen_IsARemark()
    {
        var group = new GroupFlightSummary([Vehicle(1, MissionFailures.GivenUp, 0.99), Vehicle(2, CalledHome, 0.4)]);
        Assert.Empty(group.VehicleFailures);
        Assert.Equal(3, group.Remarks.Count);
    }

    [Fact]
    public void CalledHome_NothingIsRequiredAndNoneFinished_Failed()
    {
        var group = new GroupFlightSummary(
            [Vehicle(1, MissionFailures.GivenUp, 0.99, required: 0), Vehicle(2, MissionFailures.GivenUp, 0, 0)]);
        Assert.Equal(2, group.VehicleFailures.Count);
    }

    [Fact]
    public void NotLandedOrNotFlown_OthersCompletedTheSearch_IsAFailureAllTheSame()
    {
        var group = new GroupFlightSummary(
            [Vehicle(1), Vehicle(2, CalledHome | MissionFailures.NotLanded, 0.4, hasLanded: false),
                Vehicle(3, MissionFailures.NotFlown, 0, hasFlown: false)]);
        Assert.Equal(2, group.VehicleFailures.Count);
        Assert.StartsWith("vehicle 2: it has not landed", group.VehicleFailures[0], StringComparison.Ordinal);
        Assert.StartsWith("vehicle 3: it did not fly", group.VehicleFailures[1], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void CalledOffBeforeTakeOff_IsARemarkWhereOthersCompletedTheSearch(bool isCompleted)
    {
        const MissionFailures CalledOff = MissionFailures.NotFlown | MissionFailures.CalledOff;
        var group = new GroupFlightSummary(
            [isCompleted ? Vehicle(1) : Vehicle(1, CalledHome, 0.4), Vehicle(2, CalledOff, 0, hasFlown: false)]);
        Assert.Equal(isCompleted ? 0 : 3, group.VehicleFailures.Count);
        Assert.Equal(
            isCompleted ? ["vehicle 2: it did not fly; the others completed the search"] : [], group.Remarks);
    }

    // No other vehicle flies a lane that the operator of one skipped.
    [Fact]
    public void AreaNotSeen_OperatorSkippedLanesOfSeveral_EachNamesThemAll()
    {
        var group = new GroupFlightSummary(
            [Vehicle(1, MissionFailures.AreaNotSeen, 0.9, lanesSkipped: 1),
                Vehicle(2, MissionFailures.AreaNotSeen, 0.9, lanesSkipped: 2)]);
        Assert.Equal(2, group.VehicleFailures.Count);
        Assert.All(
            group.VehicleFailures,
            f => Assert.EndsWith(
                "98 % are required; the operator skipped 3 lanes of the group", f, StringComparison.Ordinal));
    }

    private static GroupVehicleSummary Vehicle(
        byte systemId, MissionFailures failures = MissionFailures.None, double coverage = 0.99, double required = 0.98,
        bool hasLanded = true, bool hasFlown = true, int lanesSkipped = 0)
        => new(systemId, new FlightSummary(new FlightRecord
        {
            Mission = new MissionStatus
            {
                Phase = MissionPhase.Done,
                Plan = MadeUpSite.Plan,
                Coverage = coverage,
                LanesSkipped = lanesSkipped,
                Aborted = (failures & MissionFailures.GivenUp) != 0 ? "return, by system 255" : null,
                Result = new MissionResult
                {
                    Outcome = failures == MissionFailures.None ? MissionOutcome.Accomplished : MissionOutcome.Failed,
                    Failures = failures,
                    HasFlown = hasFlown,
                    HasLanded = hasLanded,
                    RequiredCoverage = required,
                },
            },
        }));
}
