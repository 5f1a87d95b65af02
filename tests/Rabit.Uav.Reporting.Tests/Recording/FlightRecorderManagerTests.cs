using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>The recorder in virtual time, with the test in the place of the managers.</summary>
public sealed class FlightRecorderManagerTests : IDisposable
{
    private readonly RabitReactor _reactor = new(new VirtualTime(1));
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<HealthReport> _health;
    private readonly MessagePublisher<MissionStatus> _mission;
    private readonly QueueSender<LinkFrame> _frames;
    private readonly FlightRecorderManager _recorder = new(new FlightRecorderOptions
    {
        ManagerNames = [FlightRecorderManager.ManagerName],
        StopsWhenMissionEnds = true,
        MaxMissionTime = TimeSpan.FromMinutes(1),
    });

    public FlightRecorderManagerTests()
    {
        _reactor.Add(_recorder);
        _vehicle = _reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        _health = _reactor.Workspace.Publish<HealthReport>(MessageNames.Health);
        _mission = _reactor.Workspace.Publish<MissionStatus>(MessageNames.Mission);
        _frames = _reactor.Workspace.Send<LinkFrame>(FlightRecorderManager.FramesQueue);
        _reactor.Start();
    }

    [Fact]
    public void Record_AFlight_HasItsPathItsLengthAndItsChanges()
    {
        Post(MissionPhase.WaitingForVehicle, isArmed: false, speed: 0);
        Run(2);
        Fly(seconds: 10, speed: 5);
        Post(MissionPhase.Done, isArmed: false, speed: 0);
        Run(1);
        FlightRecord record = _recorder.Record;

        Assert.InRange(record.Samples.Count, 64, 66);
        Assert.Equal(50, record.FlownMetres, 3);
        Assert.Equal(10, record.ArmedTime.TotalSeconds, 3);
        Assert.Equal(40, record.MaxHeightAboveHomeMetres);
        Assert.Equal(
            [MissionPhase.WaitingForVehicle, MissionPhase.Searching, MissionPhase.Done],
            record.Phases.Select(p => p.Phase));
        Assert.Equal([HealthLevel.Good], record.HealthChanges.Select(h => h.Report.Level));
        Assert.InRange(record.Managers.Single().Samples.Count, 6, 8);
    }

    [Fact]
    public void Record_NothingIsReceivedForAMinute_ItsLengthDoesNotGoOn()
    {
        Post(MissionPhase.WaitingForVehicle, isArmed: false, speed: 0);
        Run(1);
        Fly(seconds: 4, speed: 5);
        Run(30);
        Assert.InRange(_recorder.Record.FlownMetres, 20, 31);
    }

    [Fact]
    public void Telemetry_FramesOfTheVehicleAndOthers_AreTakenWithoutAWakeUp()
    {
        Post(MissionPhase.WaitingForVehicle, isArmed: false, speed: 0);
        Run(1);
        long runs = RunsOfTheManager();
        for (int i = 0; i < 100; i++)
            Assert.NotEqual(PushResult.Rejected, _frames.Push(FrameOf(i)));
        Run(1);
        TelemetryRecord telemetry = _recorder.Record.Telemetry;

        Assert.Equal((100L, 0L), (telemetry.Frames, telemetry.FramesDropped));
        Assert.Equal(((byte)1, (byte)1), (telemetry.SystemId, telemetry.ComponentId));
        Assert.Equal(100, telemetry.StatusTexts.Count);
        Assert.InRange(RunsOfTheManager() - runs, 0, 10);
    }

    [Fact]
    public void Telemetry_MoreFramesThanTheQueueHolds_CountsTheDroppedOnes()
    {
        int pushed = 0;
        while (_frames.Push(FrameOf(pushed)) != PushResult.Rejected)
            pushed++;
        Run(1);

        TelemetryRecord telemetry = _recorder.Record.Telemetry;
        Assert.Equal(((long)pushed, 1L), (telemetry.Frames, telemetry.FramesDropped));
    }

    [Fact]
    public void Telemetry_FramesOfTheLastMoment_AreTakenAtTheEnd()
    {
        Run(1);
        _frames.Push(FrameOf(0));
        _reactor.Stop();
        _reactor.Finish();

        Assert.Equal(1, _recorder.Record.Telemetry.Frames);
    }

    [Fact]
    public void Mission_Done_EndsTheRunThreeSecondsLater()
    {
        Post(MissionPhase.Done, isArmed: false, speed: 0);

        Assert.True(_reactor.RunFor(TimeSpan.FromSeconds(2)));
        Assert.False(_reactor.RunFor(TimeSpan.FromSeconds(2)));
        Assert.Equal("recorder: the mission is over", _reactor.Finish().StopReason);
    }

    [Fact]
    public void Mission_HandedOver_EndsTheRunOnceThePilotHasDisarmed()
    {
        Post(MissionPhase.HandedOver, isArmed: true, speed: 3);
        Assert.True(_reactor.RunFor(TimeSpan.FromSeconds(30)));

        Post(MissionPhase.HandedOver, isArmed: false, speed: 0);
        Assert.False(_reactor.RunFor(TimeSpan.FromSeconds(5)));
        _reactor.Finish();
    }

    [Fact]
    public void Mission_NeverOver_EndsTheRun()
    {
        Post(MissionPhase.Searching, isArmed: true, speed: 3);

        Assert.False(_reactor.RunFor(TimeSpan.FromSeconds(61)));
        Assert.Equal("recorder: the mission is not over after 1 minutes", _reactor.Finish().StopReason);
    }

    [Fact]
    public void Pictures_NoLongerInTheBuffer_AreKept()
    {
        List<ImageChip> chips = [PictureOf(7), PictureOf(8)];
        var pictures = new TrackPictures(() => chips);
        pictures.Take(TracksOf((1, 7)));
        chips = [PictureOf(9)];
        pictures.Take(TracksOf((1, 7), (2, 9), (3, 8), (4, -1)));

        Assert.Equal([7, 9], pictures.ToArray().Select(c => c.PictureNumber).OrderBy(n => n));

        chips = [PictureOf(10)];
        pictures.Take(TracksOf((1, 10)));
        Assert.Equal([9, 10], pictures.ToArray().Select(c => c.PictureNumber).OrderBy(n => n));
    }

    [Fact]
    public void Pictures_ThreeBestAndTheWholeOne_AreKeptOfEachTrack()
    {
        List<ImageChip> chips = [PictureOf(1), PictureOf(2), PictureOf(3)];
        var asked = new List<long>();
        var pictures = new TrackPictures(() => chips, number =>
        {
            asked.Add(number);
            return number == 4 ? null : new PictureOverview(number, 1, 1, new byte[3], []);
        });
        pictures.Take(new TrackList(TimeSpan.Zero, [TrackWith(1)]));
        pictures.Take(new TrackList(TimeSpan.Zero, [TrackWith(2, 1)]));
        pictures.Take(new TrackList(TimeSpan.Zero, [TrackWith(2, 1, 3)]));
        chips = [PictureOf(4)];
        pictures.Take(new TrackList(TimeSpan.Zero, [TrackWith(2, 4, 1)]));
        pictures.Take(new TrackList(TimeSpan.Zero, [TrackWith(2, 4, 1)]));

        Assert.Equal([2L, 4, 1], pictures.ToArray().Select(c => c.PictureNumber));
        Assert.Equal(2, Assert.Single(pictures.OverviewsToArray()).PictureNumber);
        Assert.Equal([1L, 2], asked);
    }

    [Fact]
    public void DecimatedSeries_LongerThanItsCapacity_KeepsEvenlySpacedItems()
    {
        var list = new DecimatedSeries<int>(100);
        for (int i = 0; i < 1_000_000; i++)
            list.Add(i);
        int[] kept = list.ToArray();

        Assert.InRange(kept.Length, 50, 100);
        Assert.Equal(0, kept[0]);
        Assert.Single(kept.Zip(kept.Skip(1), (a, b) => b - a).Distinct());
        Assert.InRange(kept[kept.Length - 1], 950_000, 999_999);
    }

    public void Dispose() => _reactor.Stop();

    private void Fly(int seconds, double speed)
    {
        TimeSpan since = _reactor.Now;
        for (int i = 0; i < seconds; i++)
        {
            Post(MissionPhase.Searching, isArmed: true, speed, since);
            Run(1);
        }
    }

    private void Post(MissionPhase phase, bool isArmed, double speed, TimeSpan? since = null)
    {
        _mission.Value = new MissionStatus { Phase = phase, Since = since ?? _reactor.Now };
        _mission.Post();
        _health.Value = new HealthReport { Level = HealthLevel.Good };
        _health.Post();
        _vehicle.Value = new VehicleState
        {
            SystemId = 1,
            ComponentId = 1,
            IsConnected = true,
            IsArmed = isArmed,
            PositionTime = _reactor.Now,
            Position = MadeUpSite.Home,
            HeightAboveHomeMetres = 40,
            VelocityNed = new NedVector(speed, 0, 0),
            BatteryTime = _reactor.Now,
            BatteryRemaining = 0.9,
        };
        _vehicle.Post();
    }

    private static ImageChip PictureOf(long picture) => new(picture, 0, 1, 1, new byte[3]);

    private static TargetTrack TrackWith(long best, params long[] others) => new()
    {
        Id = 1,
        BestPictureNumber = best,
        OtherPictures = [.. others.Select(o => new TrackPicture(o, 0))],
    };

    private static TrackList TracksOf(params (int Id, long Picture)[] tracks)
        => new(TimeSpan.Zero, tracks.Select(t => new TargetTrack
        {
            Id = t.Id,
            State = TrackState.Confirmed,
            BestPictureNumber = t.Picture,
        }));

    private static LinkFrame FrameOf(int index) => new()
    {
        Frame = MavlinkFrame.Create(new Statustext { Text = new Text50("a") }, 1, 1, (byte)index),
        Index = index,
        UtcMicroseconds = 1_700_000_000_000_000 + index,
    };

    private void Run(double seconds) => _reactor.RunFor(TimeSpan.FromSeconds(seconds));

    private long RunsOfTheManager()
    {
        ManagerTimeLine manager = _recorder.Record.Managers.Single();
        return manager.Samples[manager.Samples.Count - 1].Runs;
    }
}
