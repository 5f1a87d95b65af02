using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>The one page of a whole group.</summary>
public sealed class GroupHtmlReportTests
{
    private static readonly XNamespace Html = "http://www.w3.org/1999/xhtml";

    [Fact]
    public void Write_TwoVehicles_ShowsPathsRolesValidationsAndRadio()
    {
        XDocument page = Page(Group());
        string words = Words(page);

        Assert.Contains("Mission accomplished", words);
        Assert.Equal(2, page.Descendants(Html + "polyline").Count(p => ClassOf(p).StartsWith("path v", Ordinal)));
        Assert.Equal(5, page.Descendants(Html + "article").Count());
        Assert.Single(page.Descendants(Html + "dd"), d => d.Value == "vehicle 1");
        Assert.Single(page.Descendants(Html + "dd"), d => d.Value == "vehicle 2: confirmed");
        Assert.Contains(
            page.Descendants(Html + "title"), t => t.Value.StartsWith("validates red of 1, 0:30 to ", Ordinal));
        Assert.Contains(page.Descendants(Html + "title"), t => t.Value.StartsWith("lanes 1 to 2, ", Ordinal));
        Assert.Single(page.Descendants(Html + "rect"), r => ClassOf(r) == "divides");
        Assert.Equal(2, Lines(page, "radio"));
        Assert.Contains("1.50", words);   // 18750 bytes in 100 s
    }

    // The best of each vehicle; of the finder two more, and the whole picture with a box around the target.
    [Fact]
    public void Write_Targets_HaveTheBestPicturesAndTheWholeOneWithItsBox()
    {
        XElement card = Page(Group()).Descendants(Html + "article").First();

        Assert.Equal(
            [
                "What the camera of vehicle 1 saw of track 1, picture 101",
                "What the camera of vehicle 2 saw of track 1, picture 101",
                "What the camera of vehicle 1 saw of track 1, picture 201",
                "What the camera of vehicle 1 saw of track 1, picture 301",
                "Picture 101 of the camera of vehicle 1 with track 1",
            ],
            card.Descendants(Html + "img").Select(i => i.Attribute("alt")!.Value));
        Assert.Equal(
            ["box", "box other"],
            card.Descendants(Html + "i").Select(ClassOf).Where(c => c.StartsWith("box", Ordinal)));
    }

    [Fact]
    public void Write_FoundByOneOnly_SaysThatItWasNotValidated()
    {
        XDocument page = Page(Group(state: ValidationState.Open));

        Assert.Single(page.Descendants(Html + "b"), b => ClassOf(b) == "state" && b.Value == "not validated");
        Assert.Single(page.Descendants(Html + "dd"), d => d.Value == "none: no vehicle could");
    }

    [Fact]
    public void Write_Failures_NamesEachAndSaysFailed()
    {
        string words = Words(Page(Group(failures: ["vehicles 1 and 2 met", "target T1 was not found"])));

        Assert.Contains("Mission failed", words);
        Assert.Contains("vehicles 1 and 2 met", words);
        Assert.Contains("target T1 was not found", words);
    }

    // Each once, however many vehicles say the same.
    [Fact]
    public void Write_Run_NamesOperatorAndMissionFiles()
    {
        static GroupVehicleSummary With(byte systemId, string operatorName, string file) => new(
            systemId,
            new FlightSummary(MadeUpFlight.Record())
            {
                OperatorName = operatorName,
                MissionFile = file,
                MissionFileSha256 = new string('a', 64),
            });
        string[] facts = Page(new GroupFlightSummary(
                [With(1, "J. <Miller>", "a.json"), With(2, "J. <Miller>", "a.json"), With(3, "", "b.json")]))
            .Descendants(Html + "dd").Select(d => d.Value).ToArray();

        Assert.Contains("J. <Miller>", facts);
        Assert.Contains("a.json, SHA-256 aaaaaaaaaaaaaaaa…; b.json, SHA-256 aaaaaaaaaaaaaaaa…", facts);
        Assert.Contains("not named", Page(new GroupFlightSummary([With(1, "", "a.json")]))
            .Descendants(Html + "dd").Select(d => d.Value));
    }

    [Fact]
    public void Write_VehicleThatNeverWasSwitchedOn_IsARowWithoutFigures()
    {
        var group = new GroupFlightSummary(
            [new GroupVehicleSummary(1, new FlightSummary(FlightRecord.Empty)), Vehicle(2, default, [])]);

        Assert.Contains("no mission", Words(Page(group)));
    }

    [Fact]
    public void Write_NothingWasFlown_IsAPageAllTheSame()
        => Assert.Contains(
            "Mission of a group",
            Words(Page(new GroupFlightSummary([new GroupVehicleSummary(1, new FlightSummary(FlightRecord.Empty))]))));

    [Fact]
    public void Write_HostileNames_AreTextsAndNoAddresses()
    {
        var group = new GroupFlightSummary([Vehicle(1, default, [], "javascript:alert(1)/\"><script>")])
        {
            Name = "<script>alert(1)</script>",
        };
        XDocument page = Page(group);

        Assert.Equal(2, page.Descendants(Html + "script").Count());
        Assert.Equal(
            "javascript%3Aalert%281%29/%22%3E%3Cscript%3E",
            page.Descendants(Html + "a").Single().Attribute("href")!.Value.Replace("(", "%28").Replace(")", "%29"));
    }

    [Theory]
    [InlineData(true, "followed")]
    [InlineData(false, "lost")]
    public void Write_TargetThatMovedAndIsGone_IsMarkedByWhatBecameOfIt(bool wasFollowed, string state)
    {
        var track = new TargetTrack
        {
            Id = 1,
            State = TrackState.Lost,
            Class = DefaultTargetClasses.Red,
            Motion = TargetMotion.Vehicle,
            Position = GeodeticPosition.FromDegrees(47, 8, 0),
        };
        var task = new FollowTask
        {
            Finder = 1,
            Class = track.Class,
            Follower = 2,
            State = FollowState.Closed,
            Result = FollowResult.Followed,
        };
        var record = new FlightRecord
        {
            Tracks = new TrackList(TimeSpan.Zero, [track]),
            Group = new GroupStatus
            {
                Followings = [task],
                FollowedTracks = wasFollowed ? [new FollowedTrack(1, 0, 0, track.Id)] : [],
            },
        };

        XDocument page = Page(new GroupFlightSummary([new GroupVehicleSummary(1, new FlightSummary(record))]));

        Assert.Equal(state, Assert.Single(page.Descendants(Html + "b"), b => ClassOf(b) == "state").Value);
        Assert.Equal(
            !wasFollowed, page.Descendants(Html + "li").Any(
                l => l.Value == "red found by vehicle 1, none of these tracks; followed: by vehicle 2, 0 s in view"));
    }

    // Two of one class: each card has its own task.
    [Fact]
    public void Write_TwoTargetsOfOneClassThatMove_EachIsSaidToBeFollowedAsItWas()
    {
        TargetTrack[] tracks =
        [
            .. new[] { 1, 2 }.Select(id => new TargetTrack
            {
                Id = id,
                State = TrackState.Lost,
                Class = DefaultTargetClasses.Red,
                Motion = TargetMotion.Walking,
                Position = GeodeticPosition.FromDegrees(47, 8 + (id / 1000.0), 0),
            }),
        ];
        var followed = new FollowTask
        {
            Finder = 1,
            Number = 1,
            Class = tracks[0].Class,
            Follower = 2,
            State = FollowState.Closed,
            Result = FollowResult.Followed,
            InView = TimeSpan.FromSeconds(60),
        };
        FollowTask lost = followed with { Number = 2, Result = FollowResult.Lost, InView = TimeSpan.Zero };
        var record = new FlightRecord
        {
            Tracks = new TrackList(TimeSpan.Zero, tracks),
            Group = new GroupStatus
            {
                Followings = [followed, lost],
                FollowedTracks = [new FollowedTrack(1, 0, 1, 1), new FollowedTrack(1, 0, 2, 2)],
            },
        };

        XDocument page = Page(new GroupFlightSummary([new GroupVehicleSummary(1, new FlightSummary(record))]));

        Assert.Equal(
            ["by vehicle 2, 60 s in view", "no: by vehicle 2, which did not find it"],
            page.Descendants(Html + "dt").Where(t => t.Value == "followed")
                .Select(t => ((XElement)t.NextNode!).Value));
        Assert.Equal(
            ["followed", "lost"], page.Descendants(Html + "b").Where(b => ClassOf(b) == "state").Select(b => b.Value));
    }

    [Fact]
    public void Write_TargetThatMovesCameIntoViewAgain_HasOneCardOfItsNewestTrack()
    {
        TargetTrack[] tracks =
        [
            .. new[] { 4, 6 }.Select(id => new TargetTrack
            {
                Id = id,
                State = id == 6 ? TrackState.Confirmed : TrackState.Lost,
                Class = DefaultTargetClasses.Red,
                Motion = TargetMotion.Walking,
                Position = GeodeticPosition.FromDegrees(47, 8 + (id / 1000.0), 0),
                FirstSeen = TimeSpan.FromSeconds(10 * id),
                LastSeen = TimeSpan.FromSeconds((10 * id) + 5),
            }),
        ];
        var task = new FollowTask
        {
            Finder = 1,
            Number = 1,
            Class = tracks[0].Class,
            Follower = 2,
            State = FollowState.Closed,
            Result = FollowResult.Followed,
            InView = TimeSpan.FromSeconds(20),
        };
        var record = new FlightRecord
        {
            Tracks = new TrackList(TimeSpan.Zero, tracks),
            Group = new GroupStatus
            {
                Followings = [task],
                FollowedTracks = [new FollowedTrack(1, 0, 1, 4), new FollowedTrack(1, 0, 1, 6)],
            },
        };
        var group = new GroupFlightSummary([new GroupVehicleSummary(1, new FlightSummary(record))]);

        XDocument page = Page(group);

        Assert.Equal(
            ["followed"], page.Descendants(Html + "b").Where(b => ClassOf(b) == "state").Select(b => b.Value));
        XElement earlier = Assert.Single(page.Descendants(Html + "dt"), t => t.Value == "as track 4");
        Assert.Equal("0:40 to 0:45", ((XElement)earlier.NextNode!).Value);
        Assert.Empty(group.NotFollowed);
    }

    [Fact]
    public void DescribeFollowing_Lost_SaysWhoFollowedBeforeThat()
    {
        var lost = new FollowTask
        {
            Finder = 1,
            Number = 3,
            State = FollowState.Closed,
            Result = FollowResult.Lost,
            InView = TimeSpan.FromSeconds(20),
        };
        GroupRole follows = new() { Time = TimeSpan.FromSeconds(9), FollowedFinder = 1, FollowedNumber = 3 };
        var group = new GroupFlightSummary(
            [Vehicle(1, default, [follows]), Vehicle(3, default, [follows with { Time = TimeSpan.Zero }])]);

        Assert.Equal("by vehicles 3, 1, 20 s in view, then lost", group.DescribeFollowing(lost));
        Assert.Equal("no: no vehicle could", group.DescribeFollowing(lost with { Number = 4, InView = TimeSpan.Zero }));
    }

    [Fact]
    public void Write_NothingFound_HasNoFigureThatIsNone()
    {
        var group = new GroupFlightSummary([Vehicle(1, default, [])]) { Score = new MissionScore() };

        Assert.DoesNotContain("NaN", Words(Page(group)));
        Assert.Single(Page(group).Descendants(Html + "b"), b => b.Value == "none");
    }

    // Where two vehicles announced it, one has no validator.
    [Fact]
    public void Write_AnnouncedByTwoAndConfirmed_IsValidated()
    {
        ValidationTask open = TaskOf(ValidationState.Open);
        var far = LocalNedFrame.IgnoringGeoid(open.Position).ToGeodetic(new NedPosition(2, 0, 0));
        ValidationTask confirmed = TaskOf(ValidationState.Closed) with { Number = 2, Position = far };

        GroupFlightSummary group = Group(ValidationState.Open, more: confirmed);
        XDocument page = Page(group);

        Assert.Equal(2, Assert.Single(group.Validations).Number);
        Assert.Single(page.Descendants(Html + "dd"), d => d.Value == "vehicle 2: confirmed");
        Assert.DoesNotContain(page.Descendants(Html + "dd"), d => d.Value.StartsWith("none: ", Ordinal));
    }

    [Fact]
    public void GroupFlightSummary_FinderThatWasLost_HasItsTasksFromTheOthers()
    {
        ValidationTask task = TaskOf(ValidationState.Closed);
        var group = new GroupFlightSummary(
            [Vehicle(2, new GroupStatus { Validations = [task with { State = ValidationState.Awarded }] }, []),
                Vehicle(3, new GroupStatus { Validations = [task] }, [])]);

        Assert.Equal(ValidationState.Closed, Assert.Single(group.Validations).State);
    }

    [Fact]
    public void GroupFlightSummary_TaskLeftToAnotherFinder_DoesNotCount()
    {
        ValidationTask left = TaskOf(ValidationState.Closed) with { Number = 2, Validator = 0 };
        GroupFlightSummary group = Group(more: left);

        Assert.Equal(1, Assert.Single(group.Validations).Number);
        Assert.Equal(1, group.Confirmed);
    }

    [Fact]
    public void GroupFlightSummary_FollowingKnownByTwo_IsThatOfTheOneThatKnowsTheMost()
    {
        var task = new FollowTask { Finder = 1, Number = 1, Follower = 2, Decision = 2, State = FollowState.Awarded };
        FollowTask over = task with { Decision = 3, State = FollowState.Closed, Result = FollowResult.Followed };
        var group = new GroupFlightSummary(
            [Vehicle(1, new GroupStatus { Followings = [task] }, []),
                Vehicle(2, new GroupStatus { Followings = [over] }, [])]);

        Assert.Equal(FollowResult.Followed, Assert.Single(group.Followings).Result);
        Assert.Equal("by vehicle 2, 0 s in view", FollowText.Of(over, [2]));
    }

    [Fact]
    public void GroupFlightSummary_NoVehicle_IsRefused()
        => Assert.Throws<ArgumentException>(() => new GroupFlightSummary([]));

    private const StringComparison Ordinal = StringComparison.Ordinal;

    private static GroupFlightSummary Group(
        ValidationState state = ValidationState.Closed, string[]? failures = null, ValidationTask? more = null)
    {
        ValidationTask task = TaskOf(state);
        ValidationTask[] tasks = more is { } second ? [task, second] : [task];
        GroupRole search = new() { Time = TimeSpan.FromSeconds(5), Share = new LaneShare(2, 0, 2) };
        GroupRole divides = search with { Share = new LaneShare(1, 2, 2), DividesLanes = true };
        GroupRole validates = search with
        {
            Time = TimeSpan.FromSeconds(30),
            ValidatedFinder = 1,
            ValidatedNumber = 1,
            ValidatedClass = task.Class,
        };
        GroupVehicleSummary[] vehicles =
        [
            Vehicle(2, default, [search, validates, search with { Time = TimeSpan.FromSeconds(50) }]),
            Vehicle(1, new GroupStatus { Validations = [.. tasks] }, [divides]),
        ];
        return new GroupFlightSummary(vehicles)
        {
            Name = "meadow",
            Score = vehicles[1].Flight.Mission!.Score,
            Failures = failures ?? [],
        };
    }

    private static ValidationTask TaskOf(ValidationState state)
    {
        TargetTrack track = MadeUpTargets.Tracks(5, hasFalseTrack: false)
            .First(t => t.Class == DefaultTargetClasses.Red);
        return new ValidationTask
        {
            Finder = 1,
            Number = 1,
            State = state,
            Class = track.Class,
            Position = track.Position,
            Validator = state == ValidationState.Closed ? (byte)2 : (byte)0,
            Result = state == ValidationState.Closed ? ValidationResult.Confirmed : ValidationResult.Unknown,
        };
    }

    private static GroupVehicleSummary Vehicle(
        byte systemId, GroupStatus group, GroupRole[] roles, string reportFile = "")
        => new(systemId, MadeUpFlight.Summary(MadeUpFlight.Record(group: group, roles: roles)))
        {
            ReportFile = reportFile,
            Radio = new RadioUse
            {
                Samples = [.. Enumerable.Range(0, 100).Select(i => new RadioSample(TimeSpan.FromSeconds(i), 187 * i))],
                BytesSent = 18_750,
                Duration = TimeSpan.FromSeconds(100),
                Delivered = 9,
                Lost = 1,
            },
        };

    // The lines of a chart: those that follow its label, up to the next one.
    private static int Lines(XDocument page, string chart)
    {
        IEnumerable<XElement> after = page.Descendants(Html + "text").Single(t => t.Value == chart).ElementsAfterSelf();
        return after.TakeWhile((e, i) => i < 2 || e.Name != Html + "text")
            .Count(e => e.Name == Html + "polyline" && ClassOf(e).StartsWith("line v", Ordinal));
    }

    private static string ClassOf(XElement element) => element.Attribute("class")?.Value ?? string.Empty;

    private static string Words(XDocument page) => page.Root!.Element(Html + "body")!.Value;

    private static XDocument Page(GroupFlightSummary group)
    {
        using var page = new StringWriter();
        GroupHtmlReport.Write(page, group);
        return XDocument.Parse(page.ToString().Replace("<!DOCTYPE html>", string.Empty));
    }
}
