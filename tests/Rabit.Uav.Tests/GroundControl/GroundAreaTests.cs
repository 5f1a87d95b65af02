using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>A fence that is uploaded to our component: another area, with keep-outs, in flight.</summary>
public sealed class GroundAreaTests : IDisposable
{
    private const MavCmd Inside = MavCmd.NavFencePolygonVertexInclusion;
    private const MavCmd Outside = MavCmd.NavFencePolygonVertexExclusion;

    // North and east of home; the area of the mission is 60 to 150 m north, -60 to 60 m east.
    private static readonly PlanePoint[] Wider = [new(60, -60), new(60, 120), new(150, 120), new(150, -60)];
    private static readonly PlanePoint[] Shed = [new(120, 70), new(120, 90), new(140, 90), new(140, 70)];

    private readonly GroundRig _ground = new(MissionRig.In(MissionPhase.Searching));

    private MissionFlight Flight => _ground.Flight.Manager.Flight!;

    [Fact]
    public void Upload_InMidSearch_IsTakenOverByTheNextContinueAndFlownAroundTheKeepOut()
    {
        _ground.Run(20);
        double seen = Flight.Route!.Coverage.SeenCells;
        FlightPlan? before = Flight.Plan;
        Assert.Equal(MavMissionResult.Accepted, Upload((Inside, Wider), (Outside, Shed)));
        _ground.Run(2);
        Assert.Same(before, Flight.Plan);
        Assert.Equal("Rabit: area offered: the next continue takes it over", Assert.Single(_ground.Texts));

        Continue();
        Assert.Equal(MavResult.Accepted, Assert.Single(_ground.Take<CommandAck>()).Result);
        Assert.NotSame(before, Flight.Plan);
        Assert.InRange(Flight.Route!.Coverage.SeenCells, seen, seen + 2000);
        int from = _ground.Flight.Vehicle.Path.Count;
        Assert.Equal(MissionPhase.Done, _ground.Flight.RunToEnd());
        var polygon = new PlanePolygon(Shed);
        Assert.InRange(
            _ground.Flight.Vehicle.Path.Skip(from)
                .Min(p => -polygon.SignedDistance(new PlanePoint(p.North, p.East))), 0, 200);
        Assert.InRange(_ground.Flight.Vehicle.Path.Max(p => p.East), 95, 125);
        Assert.InRange(_ground.Flight.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void Upload_WhileItHolds_IsTakenOverByTheContinue()
    {
        Command(MavCmd.DoPauseContinue, 0);
        Assert.Equal(MissionPhase.Holding, _ground.Flight.Status.Phase);
        Assert.Equal(MavMissionResult.Accepted, Upload((Inside, Wider)));
        Continue();
        Assert.Equal(MissionPhase.InTransit, _ground.Flight.Status.Phase);
        Assert.Equal(Wider.Length, Flight.Mission.Area.Length);
        Assert.InRange(Flight.Plan!.Area.Area, 16_000, 16_400);
    }

    [Fact]
    public void Upload_BeforeTheTakeOff_IsFlownFromTheStart()
    {
        using var ground = new GroundRig(MissionRig.In(MissionPhase.Arming));
        Assert.Equal(MavMissionResult.Accepted, Upload(ground, GroundRig.Station, Items((Inside, Wider))));
        Command(ground, MavCmd.MissionStart, 0);
        ground.Flight.Vehicle.Refuses = _ => null;
        Assert.Equal(MissionPhase.Searching, ground.Flight.RunUntil(MissionPhase.Searching));
        Assert.InRange(ground.Flight.Manager.Flight!.Plan!.Area.Area, 16_000, 16_400);
    }

    [Fact]
    public void Upload_ThenASecondOne_TheLastIsTakenOver()
    {
        Upload((Inside, Wider));
        PlanePoint[] other = [new(60, -60), new(60, 80), new(150, 80), new(150, -60)];
        Upload((Inside, other));
        Continue();
        Assert.InRange(Flight.Plan!.Area.Area, 12_500, 12_700);
    }

    [Fact]
    public void Clear_AfterAnUpload_WithdrawsTheArea()
    {
        Upload((Inside, Wider));
        _ground.Send(new MissionClearAll
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            MissionType = MavMissionType.Fence,
        });
        _ground.Run(0.5);
        Assert.Equal(MavMissionResult.Accepted, Assert.Single(_ground.Take<MissionAck>()).Type);
        Continue();
        Assert.Equal(MavResult.Failed, Assert.Single(_ground.Take<CommandAck>()).Result);
        Assert.InRange(Flight.Plan!.Area.Area, 10_700, 10_900);
    }

    [Fact]
    public void Replan_AfterALaneWasSkipped_DoesNotBringItBack()
    {
        _ground.Run(5);
        Command(MavCmd.User1, 1);
        _ground.Run(0.5);
        Assert.Equal(1, _ground.Flight.Status.LanesSkipped);
        Upload((Inside, Wider));
        Continue();
        Assert.Equal(MissionPhase.Done, _ground.Flight.RunToEnd());
        Assert.Equal(1, _ground.Flight.Status.LanesSkipped);

        // What remained of it, 50 m by 30 m, of 16 200 m2.
        Assert.InRange(_ground.Flight.Status.Coverage, 0.87, 0.94);
    }

    public static TheoryData<string, string> WrongAreas() => new()
    {
        { "crossing", "area refused: area crosses itself: the edges after area[0] and area[2] intersect" },
        { "flat", "area refused: area has 0 m2; it must have 100 to 4000000" },
        { "far", "area refused: the area extends" },
        { "huge", "area refused: area[1] is 8999 m from area[0]; corners must be within 5000 m of it" },
        { "home", "area refused: keepOuts[0] contains home, or is within 10.0 m of it" },
        { "cut", "area refused: the keepOuts cut the area in two, or leave nothing of it" },
        { "crossing keep-out", "area refused: keepOuts[0] crosses itself" },
        { "two areas", "area refused: there are 2 inclusion polygons; one is searched" },
        { "no area", "area refused: there are 0 inclusion polygons; one is searched" },
        { "too few", "area refused: a polygon has fewer corners than it says" },
    };

    [Theory]
    [MemberData(nameof(WrongAreas))]
    public void Upload_WrongArea_IsRefusedWithTheReasonAndChangesNothing(string what, string reason)
    {
        PlanePoint[] home = [new(-5, -5), new(-5, 5), new(5, 5), new(5, -5)];
        PlanePoint[] across = [new(0, -15), new(0, 15), new(300, 15), new(300, -15)];
        MissionItemInt[] items = what switch
        {
            "crossing" => Items((Inside, [new(60, -60), new(150, 60), new(150, -60), new(60, 60)])),
            "flat" => Items((Inside, [new(60, -60), new(60, 0), new(60, 60)])),
            "far" => Items((Inside, [.. Wider.Select(p => p + new PlanePoint(6000, 0))])),
            "huge" => Items((Inside, [new(0, 0), new(9000, 0), new(9000, 50), new(0, 50)])),
            "home" => Items((Inside, Wider), (Outside, home)),
            "cut" => Items((Inside, Wider), (Outside, [.. across.Select(p => p + new PlanePoint(40, 0))])),
            "crossing keep-out" => Items((Inside, Wider), (Outside, [Shed[0], Shed[2], Shed[1], Shed[3]])),
            "two areas" => Items((Inside, Wider), (Inside, Shed)),
            "no area" => Items((Outside, Shed)),
            _ => Items((Inside, Wider)).Take(3).ToArray(),
        };
        FlightPlan? before = Flight.Plan;
        Assert.Equal(MavMissionResult.Invalid, Upload(_ground, GroundRig.Station, items));
        Assert.StartsWith("Rabit: " + reason, Assert.Single(_ground.Texts), StringComparison.Ordinal);
        Assert.False(Flight.Changes.IsAreaOffered);
        Assert.Same(before, Flight.Plan);
    }

    [Fact]
    public void Upload_TenThousandCorners_HasNoSpace()
    {
        _ground.Send(Count(10_000));
        _ground.Run(0.5);
        Assert.Equal(MavMissionResult.NoSpace, Assert.Single(_ground.Take<MissionAck>()).Type);
        Assert.Equal("Rabit: area refused: 10000 corners; the limit is 100", Assert.Single(_ground.Texts));
    }

    [Fact]
    public void Upload_Circle_IsUnsupported()
    {
        MissionItemInt[] items = Items((Inside, Wider));
        items[0].Command = MavCmd.NavFenceCircleInclusion;
        Assert.Equal(MavMissionResult.Unsupported, Upload(_ground, GroundRig.Station, items));
        Assert.Equal("Rabit: area refused: item 0: Unsupported", Assert.Single(_ground.Texts));
    }

    [Fact]
    public void Upload_PlaceOutOfRange_IsRefused()
    {
        MissionItemInt[] items = Items((Inside, Wider));
        items[2].X = 910_000_000;
        Assert.Equal(MavMissionResult.InvalidParam5X, Upload(_ground, GroundRig.Station, items));
    }

    [Fact]
    public void Upload_GivenUp_IsCancelledAndChangesNothing()
    {
        _ground.Send(Count(4));
        _ground.Run(0.2);
        _ground.Send(Items((Inside, Wider))[0]);
        _ground.Run(7);
        Assert.Equal(MavMissionResult.OperationCancelled, Assert.Single(_ground.Take<MissionAck>()).Type);
        Assert.False(Flight.Changes.IsAreaOffered);

        // And the next one is taken.
        _ground.Take<MissionRequestInt>();
        Assert.Equal(MavMissionResult.Accepted, Upload((Inside, Wider)));
    }

    // What was planned meanwhile is not offered.
    [Fact]
    public void Upload_GivenUpBeforeItIsAnswered_IsWithdrawn()
    {
        MissionItemInt[] items = Items((Inside, Wider));
        _ground.Send(Count(4));
        _ground.Run(0.2);
        foreach (MissionItemInt item in items)
            _ground.Send(item);
        _ground.Send(new MissionAck
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            MissionType = MavMissionType.Fence,
            Type = MavMissionResult.OperationCancelled,
        });
        _ground.Run(2);
        Assert.Empty(_ground.Take<MissionAck>());
        Assert.False(Flight.Changes.IsAreaOffered);
        Assert.Contains("offer an area of 4 corners with 0 keep-outs", _ground.Flight.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Upload_OfTwoStationsAtOnce_TheSecondIsDenied()
    {
        using var ground = new GroundRig(
            MissionRig.In(MissionPhase.Searching),
            new Uav.GroundControl.GroundCommandOptions { SystemIds = [255, 254] });
        ground.Send(Count(4));
        ground.Run(0.3);
        ground.Send(Count(4), from: 254);
        ground.Run(0.3);
        MissionAck denied = Assert.Single(ground.Take<MissionAck>());
        Assert.Equal((MavMissionResult.Denied, (byte)254), (denied.Type, denied.TargetSystem));
        Assert.Equal(
            MavMissionResult.Accepted, Upload(ground, GroundRig.Station, Items((Inside, Wider)), isBegun: true));
    }

    [Fact]
    public void Upload_ByASenderThatMayNotCommand_IsDenied()
    {
        Assert.Equal(MavMissionResult.Denied, Upload(_ground, 42, Items((Inside, Wider))));
        Assert.Equal(
            "Rabit: area of system 42 component 190 denied: it may not command", Assert.Single(_ground.Texts));
    }

    [Fact]
    public void Continue_VehicleInTheKeepOut_IsRefusedAndTheAreaBeforeIsKept()
    {
        _ground.Run(8);
        Command(MavCmd.DoPauseContinue, 0);
        _ground.Run(5);
        _ground.Take<CommandAck>();
        PlanePoint at = Flight.Position;
        PlanePoint[] here = [at + new PlanePoint(-8, -8), at + new PlanePoint(-8, 8), at + new PlanePoint(8, 0)];
        Assert.Equal(MavMissionResult.Accepted, Upload((Inside, Wider), (Outside, here)));
        FlightPlan? before = Flight.Plan;
        Continue();
        Assert.Equal(MavResult.Failed, Assert.Single(_ground.Take<CommandAck>()).Result);
        Assert.Contains(
            "Rabit: continue refused: new area: the vehicle is inside a keep-out; the one before is kept",
            _ground.Texts);
        Assert.Same(before, Flight.Plan);
        Assert.Equal(MissionPhase.Holding, _ground.Flight.Status.Phase);
        _ground.Run(15);
        Continue();
        Assert.Equal(MissionPhase.InTransit, _ground.Flight.Status.Phase);
    }

    // An autopilot that answers our own request of its fence.
    [Fact]
    public void Count_OfTheAutopilot_IsNoUpload()
    {
        _ground.Send(Count(4), from: 1, component: 1);
        _ground.Run(1);
        Assert.Empty(_ground.Take<MissionAck>());
        Assert.Empty(_ground.Take<MissionRequestInt>());
    }

    [Theory]
    [InlineData(MavMissionType.Mission)]
    [InlineData(MavMissionType.Rally)]
    public void Upload_MissionOrRally_IsUnsupported(MavMissionType type)
    {
        _ground.Send(Count(4) with { MissionType = type });
        _ground.Run(0.5);
        Assert.Equal(MavMissionResult.Unsupported, Assert.Single(_ground.Take<MissionAck>()).Type);
    }

    [Fact]
    public void Download_OfWhatWasOffered_GivesItBack()
    {
        Upload((Inside, Wider), (Outside, Shed));
        _ground.Send(new MissionRequestList
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            MissionType = MavMissionType.Fence,
        });
        _ground.Run(0.5);
        Assert.Equal(8, Assert.Single(_ground.Take<MissionCount>()).Count);
    }

    public void Dispose() => _ground.Dispose();

    private static MissionCount Count(int items) => new()
    {
        TargetSystem = 1,
        TargetComponent = GroundRig.Us,
        MissionType = MavMissionType.Fence,
        Count = (ushort)items,
    };

    private static MissionItemInt[] Items(params (MavCmd Command, PlanePoint[] Corners)[] polygons)
    {
        LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);
        return polygons.SelectMany(p => p.Corners.Select(c =>
        {
            GeodeticPosition at = frame.ToGeodetic(new NedPosition(c.North, c.East, 0));
            return new MissionItemInt
            {
                Command = p.Command,
                Param1 = p.Corners.Length,
                X = (int)Math.Round(at.Latitude.Degrees * 1e7),
                Y = (int)Math.Round(at.Longitude.Degrees * 1e7),
            };
        })).Select((item, i) => item with
        {
            Seq = (ushort)i,
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            MissionType = MavMissionType.Fence,
        }).ToArray();
    }

    private static MavMissionResult Upload(
        GroundRig ground, byte from, MissionItemInt[] items, bool isBegun = false)
    {
        if (!isBegun)
            ground.Send(Count(items.Length), from);
        for (int i = 0; i < 300; i++)
        {
            ground.Run(0.1);
            List<MissionAck> acks = ground.Take<MissionAck>();
            if (acks.Count > 0)
            {
                ground.Run(0.5);
                return acks[0].Type;
            }

            foreach (MissionRequestInt request in ground.Take<MissionRequestInt>())
                ground.Send(items[request.Seq], from);
        }

        throw new TimeoutException("The upload got no answer.");
    }

    private static void Command(GroundRig ground, MavCmd command, float p1)
    {
        ground.Send(
            new CommandLong { Command = command, Param1 = p1, TargetSystem = 1, TargetComponent = GroundRig.Us });
        ground.Run(0.8);
    }

    private MavMissionResult Upload(params (MavCmd Command, PlanePoint[] Corners)[] polygons)
        => Upload(_ground, GroundRig.Station, Items(polygons));

    private void Command(MavCmd command, float p1) => Command(_ground, command, p1);

    private void Continue() => Command(MavCmd.DoPauseContinue, 1);
}
