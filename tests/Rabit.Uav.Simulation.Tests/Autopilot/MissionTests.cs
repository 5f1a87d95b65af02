using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>Missions and rally points: their upload, and the flight in AUTO.</summary>
public class MissionTests
{
    [Fact]
    public void Auto_TakeOffWayPointsReturn_FlownReportedAndLanded()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.Run(7);
        Assert.Equal(
            MavMissionResult.Accepted,
            Upload(
                ground, Item(ground, MavCmd.NavTakeoff, height: 15), Item(ground, MavCmd.DoChangeSpeed, param2: 5),
                Item(ground, MavCmd.NavWaypoint, 60, 0, 20), Item(ground, MavCmd.NavWaypoint, 60, 30, 20, param1: 3),
                Item(ground, MavCmd.NavReturnToLaunch)));
        Start(ground);
        ground.RunUntil(() => Distance(ground, 60, 0) < 3, 60, "at the first way-point");
        Assert.Equal(3, ground.Last<MissionCurrent>().Seq);
        Assert.Equal((5, MissionState.Active),
            (ground.Last<MissionCurrent>().Total, ground.Last<MissionCurrent>().MissionState));
        ground.RunUntil(() => Distance(ground, 60, 30) < 3, 60, "at the second way-point");
        Assert.InRange(-ground.Truth.Pose.Position.Down, 18, 22);
        ground.RunUntil(() => !ground.IsArmed, 200, "landed and disarmed");

        Assert.True(Distance(ground, 0, 0) < 3);
        Assert.False(ground.Truth.HasCrashed);
        Assert.Equal([1, 3, 4, 5], ground.All<MissionItemReached>().Select(r => (int)r.Message.Seq));
        Assert.Equal(
            ["Mission: 1 Takeoff", "Mission: 3 WP", "Mission: 4 WP", "Mission: 5 RTL"],
            ground.Texts.Where(text => text.StartsWith("Mission: ", StringComparison.Ordinal)));
        Assert.Contains("Reached command #4", ground.Texts);
        Assert.InRange(ground.Truth.MaxSpeedMetresPerSecond, 4, 10.5);
        Assert.Equal(CopterMode.Auto, (CopterMode)ground.Heartbeat.CustomMode);
    }

    [Fact]
    public void Auto_Land_LandsAtItsPlace()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.Run(7);
        Upload(ground, Item(ground, MavCmd.NavTakeoff, height: 10), Item(ground, MavCmd.NavLand, 20, -20));
        Start(ground);
        ground.RunUntil(() => !ground.IsArmed, 120, "landed and disarmed");
        Assert.True(Distance(ground, 20, -20) < 3, $"{Distance(ground, 20, -20)} m");
        Assert.Equal([1, 2], ground.All<MissionItemReached>().Select(r => (int)r.Message.Seq));
    }

    [Fact]
    public void SetCurrent_InFlight_GoesOnFromThere()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(15);
        Upload(
            ground, Item(ground, MavCmd.NavTakeoff, height: 15), Item(ground, MavCmd.NavWaypoint, 200, 0, 15),
            Item(ground, MavCmd.NavWaypoint, 0, 40, 15), Item(ground, MavCmd.NavLoiterUnlim, 0, 40, 15));
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Auto));
        ground.Run(5);
        Assert.Equal(2, ground.Last<MissionCurrent>().Seq);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.DoSetMissionCurrent, 5));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.DoSetMissionCurrent, 3));
        ground.RunUntil(() => Distance(ground, 0, 40) < 2.5, 60, "at the way-point jumped to");
        ground.Run(20);
        Assert.True(Distance(ground, 0, 40) < 3);

        // Taken over, and resumed where it was.
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Loiter));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.MissionStart));
        ground.Run(1);
        Assert.Equal(4, ground.Last<MissionCurrent>().Seq);
    }

    [Fact]
    public void Auto_WithoutAMission_IsRefused()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(10);
        Assert.Equal(MavResult.Failed, ground.SetMode(CopterMode.Auto));
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.MissionStart));
        Upload(ground, Item(ground, MavCmd.NavWaypoint, 20, 0, 10));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.MissionStart));
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Loiter));
        ground.Forget();
        ground.Send(new MissionClearAll { TargetSystem = 1, TargetComponent = 1 });
        ground.Run(0.2);
        Assert.Equal(MavMissionResult.Accepted, ground.Last<MissionAck>().Type);
        Assert.Equal(MavResult.Failed, ground.SetMode(CopterMode.Auto));
    }

    [Fact]
    public void Upload_AMission_ComesBackWithHome()
    {
        using var ground = new Ground();
        ground.Run(7);
        MissionItemInt point = Item(ground, MavCmd.NavWaypoint, 60, 0, 20);
        Upload(ground, point);
        ground.Send(new MissionRequestInt { TargetSystem = 1, TargetComponent = 1, Seq = 0 });
        ground.Run(0.2);
        MissionItemInt home = ground.Last<MissionItemInt>();
        GeodeticPosition origin = ground.Options.Home;
        Assert.InRange((home.X * 1e-7) - origin.Latitude.Degrees, -1e-4, 1e-4);
        Assert.Equal((MavCmd.NavWaypoint, MavFrame.Global), (home.Command, home.Frame));
        ground.Send(new MissionRequestInt { TargetSystem = 1, TargetComponent = 1, Seq = 1 });
        ground.Run(0.2);
        Assert.Equal((point.X, point.Z), (ground.Last<MissionItemInt>().X, ground.Last<MissionItemInt>().Z));
    }

    [Theory]
    [InlineData(MavCmd.DoJump, MavFrame.GlobalRelativeAlt, MavMissionResult.Unsupported)]
    [InlineData(MavCmd.NavWaypoint, MavFrame.LocalNed, MavMissionResult.UnsupportedFrame)]
    [InlineData((MavCmd)60000, MavFrame.Global, MavMissionResult.Unsupported)]
    public void Upload_WhatIsNotFlown_IsRefused(MavCmd command, MavFrame axes, MavMissionResult expected)
    {
        using var ground = new Ground();
        ground.Run(1);
        MissionItemInt item = Item(ground, command, 10, 10, 10);
        item.Frame = axes;
        Assert.Equal(expected, Upload(ground, item));
    }

    [Fact]
    public void Upload_RallyPoints_AreStored()
    {
        using var ground = new Ground();
        ground.Run(1);
        MissionItemInt point = Item(ground, MavCmd.NavRallyPoint, 30, 0, 20) with
        {
            MissionType = MavMissionType.Rally
        };
        Offer(ground, 1, MavMissionType.Rally);
        ground.Send(point with { Seq = 0 });
        ground.Run(0.2);
        Assert.Equal(MavMissionResult.Accepted, ground.Last<MissionAck>().Type);
        ground.Send(
            new MissionRequestList { TargetSystem = 1, TargetComponent = 1, MissionType = MavMissionType.Rally });
        ground.Run(0.2);
        Assert.Equal(1, ground.Last<MissionCount>().Count);
    }

    private static void Start(Ground ground)
    {
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Guided));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ComponentArmDisarm, 1));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.MissionStart));
    }

    private static double Distance(Ground ground, double north, double east)
        => FlightTests.Distance(ground, north, east);

    // Item 0 is home, whatever it says.
    private static MavMissionResult Upload(Ground ground, params MissionItemInt[] items)
    {
        ground.Run(0.1);
        Offer(ground, items.Length + 1, MavMissionType.Mission);
        for (int i = 0; i <= items.Length; i++)
        {
            ground.Send((i == 0 ? Item(ground, MavCmd.NavWaypoint) : items[i - 1]) with { Seq = (ushort)i });
            ground.Run(0.05);
        }

        return ground.Last<MissionAck>().Type;
    }

    private static void Offer(Ground ground, int count, MavMissionType type)
    {
        ground.Send(new MissionCount
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Count = (ushort)count,
            MissionType = type,
        });
        ground.Run(0.1);
    }

    private static MissionItemInt Item(
        Ground ground, MavCmd command, double north = 0, double east = 0, double height = 0, float param1 = 0,
        float param2 = 0)
        => MissionItems.Item(ground.Options.Home, command, north, east, height, param1, param2);
}
