using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>The fence: its upload over the mission protocol, targets outside, breaches.</summary>
public class FenceTests
{
    private static readonly (double North, double East)[] Square = [(50, -50), (50, 50), (-50, 50), (-50, -50)];

    [Fact]
    public void Upload_Polygon_IsAskedForStoredAndRead()
    {
        using var ground = new Ground();
        ground.Run(1);
        Assert.Equal(MavMissionResult.Accepted, Upload(ground, Square));
        Assert.Equal([0, 1, 2, 3], ground.All<MissionRequest>().Select(r => (int)r.Message.Seq));
        Assert.Contains("Fence Indexed OK", ground.Texts);
        Assert.Equal(
            4, ground.All<ParamValue>().Single(p => p.Message.ParamId.ToString() == "FENCE_TOTAL").Message.Value);

        Assert.Equal(4, Count(ground));
        ground.Send(new MissionRequestInt
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Seq = 3,
            MissionType = MavMissionType.Fence,
        });
        ground.Run(0.2);
        MissionItemInt item = ground.Last<MissionItemInt>();
        Assert.Equal((3, MavCmd.NavFencePolygonVertexInclusion, 4f), (item.Seq, item.Command, item.Param1));
        Assert.Equal(Item(ground, Square, 3).X, item.X);
    }

    [Fact]
    public void Clear_AFence_LeavesNone()
    {
        using var ground = new Ground();
        ground.Run(1);
        Upload(ground, Square);
        Assert.Equal(MavMissionResult.Accepted, Clear(ground, MavMissionType.Fence));
        Assert.Equal(0, Count(ground));
        Assert.Equal(MavMissionResult.Unsupported, Clear(ground, MavMissionType.All));
    }

    [Fact]
    public void Upload_OfMoreThanFits_IsRefused()
    {
        using var ground = new Ground();
        Assert.Equal(MavMissionResult.NoSpace, Offer(ground, 85, MavMissionType.Fence));
    }

    [Fact]
    public void Upload_ItemsThatAreWrong_AreRejectedAndDoNotEndIt()
    {
        using var ground = new Ground();
        ground.Run(1);
        Offer(ground, 4, MavMissionType.Fence);
        Assert.Equal(MavMissionResult.InvalidSequence, Send(ground, Item(ground, Square, 2)));
        MissionItemInt wrong = Item(ground, Square, 0);
        wrong.Command = MavCmd.NavWaypoint;
        Assert.Equal(MavMissionResult.Unsupported, Send(ground, wrong));
        wrong = Item(ground, Square, 0);
        wrong.X = 910_000_000;
        Assert.Equal(MavMissionResult.InvalidParam5X, Send(ground, wrong));
        wrong = Item(ground, Square, 0);
        wrong.Frame = MavFrame.LocalNed;
        Assert.Equal(MavMissionResult.UnsupportedFrame, Send(ground, wrong));
        wrong = Item(ground, Square, 0);
        wrong.Param1 = 2;
        Assert.Equal(MavMissionResult.InvalidParam1, Send(ground, wrong));
        for (int index = 0; index < 4; index++)
            Send(ground, Item(ground, Square, index));
        Assert.Equal(MavMissionResult.Accepted, ground.Last<MissionAck>().Type);
    }

    [Fact]
    public void Upload_ThatIsNotComplete_LeavesTheOldFence()
    {
        using var ground = new Ground();
        ground.Run(1);
        Upload(ground, Square);
        ground.Forget();
        Offer(ground, 5, MavMissionType.Fence);
        ground.Run(10);
        Assert.Equal(MavMissionResult.OperationCancelled, ground.Last<MissionAck>().Type);
        Assert.InRange(ground.Count<MissionRequest>(), 7, 9);

        // Four vertices that say they are five.
        Offer(ground, 4, MavMissionType.Fence);
        for (int index = 0; index < 4; index++)
        {
            MissionItemInt item = Item(ground, Square, index);
            item.Param1 = 5;
            Send(ground, item);
        }

        Assert.Equal(MavMissionResult.Error, ground.Last<MissionAck>().Type);
        Assert.Equal(4, Count(ground));
    }

    [Fact]
    public void Upload_WhileAnotherUploads_IsDenied()
    {
        using var ground = new Ground();
        ground.Run(1);
        Offer(ground, 4, MavMissionType.Fence);
        ground.Send(
            new MissionCount { TargetSystem = 1, TargetComponent = 1, Count = 3, MissionType = MavMissionType.Fence },
            system: 1, component: 191);
        ground.Run(0.2);
        MissionAck ack = ground.Last<MissionAck>();
        Assert.Equal((MavMissionResult.Denied, 191), (ack.Type, ack.TargetComponent));
    }

    [Fact]
    public void Target_OutsideTheFence_IsNotFlownTo()
    {
        using Ground ground = Fly(("FENCE_ENABLE", 1));
        CommandInt outside = FlightTests.Reposition(ground, 1);
        Assert.Equal(MavResult.Failed, ground.Command(outside));
        ground.SetMode(CopterMode.Loiter);
        Assert.Equal(MavResult.Failed, ground.Command(outside));
        Assert.Equal(CopterMode.Loiter, (CopterMode)ground.Truth.CustomMode);
        ground.SetMode(CopterMode.Guided);
        ground.GoTo(80, 0, 20);
        ground.Run(5);
        Assert.True(FlightTests.Distance(ground, 0, 0) < 3);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.DoFenceEnable, 0));
        Assert.Equal(MavResult.Accepted, ground.Command(outside));
    }

    [Theory]
    [InlineData(0, CopterMode.Guided)]
    [InlineData(1, CopterMode.Rtl)]
    [InlineData(2, CopterMode.Land)]
    [InlineData(4, CopterMode.Brake)]
    public void Breach_OfThePolygon_IsReportedAndActedUpon(int action, CopterMode mode)
    {
        using Ground ground = Fly(("FENCE_ENABLE", 1), ("FENCE_ACTION", action));
        ground.Stream(SysStatus.MavlinkId, 10);
        FlyNorth(ground, 12);

        Assert.Equal(mode, (CopterMode)ground.Truth.CustomMode);
        Assert.Contains("Polygon fence breached", ground.Texts);
        FenceStatus status = ground.Last<FenceStatus>();
        Assert.Equal((1, 1, FenceBreach.Boundary), (status.BreachStatus, status.BreachCount, status.BreachType));
        Assert.Equal(MavState.Active, ground.Heartbeat.SystemStatus);
        SysStatus health = ground.All<SysStatus>().Last().Message;
        Assert.Equal(
            MavSysStatusSensor.Geofence, health.OnboardControlSensorsEnabled & ~health.OnboardControlSensorsHealth);
    }

    [Fact]
    public void Breach_GuidedOutside_IsAcceptedAndClearedWhenBackInside()
    {
        using Ground ground = Fly(("FENCE_ENABLE", 1), ("FENCE_ACTION", 4));
        ground.Stream(FenceStatus.MavlinkId, 10);
        FlyNorth(ground, 12);
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Guided));
        ground.GoTo(0, 0, 20);
        ground.RunUntil(() => ground.Texts.Contains("Fence breach cleared"), 20, "inside");
        Assert.Equal(2, ground.Texts.Count(t => t == "Manual recovery started"));
        ground.Run(0.2);
        Assert.Equal((0, 1), (ground.Last<FenceStatus>().BreachStatus, ground.Last<FenceStatus>().BreachCount));
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
    }

    [Theory]
    [InlineData("FENCE_RADIUS", 30, 2, "Circle fence breached")]
    [InlineData("FENCE_ALT_MAX", 25, 1, "Max Alt fence breached")]
    public void Breach_OfCircleOrHeight_Returns(string parameter, double value, int type, string text)
    {
        using Ground ground = Fly(("FENCE_ENABLE", 1), ("FENCE_TYPE", type), (parameter, value));
        for (int step = 0; step < 40; step++)
        {
            ground.Fly(type == 2 ? 6 : 0, 0, type == 1 ? -2 : 0);
            ground.Run(0.2);
        }

        Assert.Contains(text, ground.Texts);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void Arm_OutsideTheFence_Fails()
    {
        using var ground = new Ground(new SimulationOptions
        {
            Parameters = FailsafeTests.Parameters([("FENCE_ENABLE", 1)]),
        });
        ground.Run(7);
        Upload(ground, [(150, -50), (150, 50), (60, 50), (60, -50)]);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(0.2);
        Assert.Contains("Arm: Vehicle breaching Polygon fence", ground.Texts);
    }

    private static Ground Fly(params (string Name, double Value)[] parameters)
    {
        var ground = new Ground(new SimulationOptions
        {
            WindMetresPerSecond = 0,
            Parameters = FailsafeTests.Parameters(parameters),
        });
        ground.Run(1);
        Upload(ground, Square);
        ground.TakeOff();
        return ground;
    }

    private static void FlyNorth(Ground ground, double seconds)
    {
        for (int step = 0; step < seconds * 5; step++)
        {
            ground.Fly(6, 0, 0);
            ground.Run(0.2);
        }
    }

    private static MavMissionResult Upload(Ground ground, (double North, double East)[] corners)
    {
        Offer(ground, corners.Length, MavMissionType.Fence);
        for (int index = 0; index < corners.Length; index++)
            Send(ground, Item(ground, corners, index));
        return ground.Last<MissionAck>().Type;
    }

    private static int Count(Ground ground)
    {
        ground.Send(new MissionRequestList
        {
            TargetSystem = 1,
            TargetComponent = 1,
            MissionType = MavMissionType.Fence,
        });
        ground.Run(0.2);
        return ground.Last<MissionCount>().Count;
    }

    private static MavMissionResult? Offer(Ground ground, int count, MavMissionType type)
    {
        ground.Send(new MissionCount
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Count = (ushort)count,
            MissionType = type,
        });
        ground.Run(0.1);
        return ground.Count<MissionAck>() == 0 ? null : ground.Last<MissionAck>().Type;
    }

    private static MavMissionResult? Send(Ground ground, in MissionItemInt item)
    {
        ground.Send(item);
        ground.Run(0.1);
        return ground.Count<MissionAck>() == 0 ? null : ground.Last<MissionAck>().Type;
    }

    private static MavMissionResult Clear(Ground ground, MavMissionType type)
    {
        ground.Send(new MissionClearAll { TargetSystem = 1, TargetComponent = 1, MissionType = type });
        ground.Run(0.2);
        return ground.Last<MissionAck>().Type;
    }

    private static MissionItemInt Item(Ground ground, (double North, double East)[] corners, int index)
    {
        GeodeticPosition place = LocalNedFrame.IgnoringGeoid(ground.Options.Home)
            .ToGeodetic(new NedPosition(corners[index].North, corners[index].East, 0));
        return new MissionItemInt
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Seq = (ushort)index,
            Command = MavCmd.NavFencePolygonVertexInclusion,
            Frame = MavFrame.Global,
            Param1 = corners.Length,
            X = (int)Math.Round(place.Latitude.Degrees * 1e7),
            Y = (int)Math.Round(place.Longitude.Degrees * 1e7),
            MissionType = MavMissionType.Fence,
        };
    }
}
