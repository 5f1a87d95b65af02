using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Simulation.Tests.Autopilot;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>Missions and rally points of the simulated PX4: their upload, and the flight in AUTO.MISSION.</summary>
public class Px4MissionTests
{
    private readonly Px4Flyer _flyer = new();

    public Px4MissionTests() => _flyer.Run(0.2);

    [Fact]
    public void Mission_TakeOffWayPointsLand_IsFlownReportedAndDisarmed()
    {
        Assert.Equal(
            MavMissionResult.Accepted,
            Upload(
                Item(MavCmd.NavTakeoff, height: 15), Item(MavCmd.DoChangeSpeed, param2: 4),
                Item(MavCmd.NavWaypoint, 60, 0, 20), Item(MavCmd.NavWaypoint, 60, 30, 20, param1: 3),
                Item(MavCmd.NavLand, 20, 30)));
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.MissionStart));
        Assert.True(_flyer.Vehicle.Autopilot.IsArmed);
        Assert.Equal(Px4Mode.Mission, _flyer.Mode);
        _flyer.RunUntil(() => Distance(60, 0) < 3, 60, "at the first way-point");
        MissionCurrent current = _flyer.All<MissionCurrent>().Last().Message;
        Assert.Equal((2, 5, MissionState.Active), (current.Seq, current.Total, current.MissionState));
        Assert.Equal(2, _flyer.All<MissionCurrent>(1).Last().Message.Seq);
        double fastest = 0;
        _flyer.RunUntil(
            () => Distance(60, 30) < 2, 60, "at the second way-point",
            () => fastest = Math.Max(fastest, _flyer.Pose.VelocityNed.HorizontalLength()));
        Assert.InRange(fastest, 3, 4.5);
        Assert.InRange(-_flyer.Pose.Position.Down, 18, 22);
        _flyer.RunUntil(() => !_flyer.Vehicle.Autopilot.IsArmed, 120, "landed and disarmed");

        Assert.True(Distance(20, 30) < 3, $"{Distance(20, 30)} m");
        Assert.Equal([0, 2, 3, 4], _flyer.All<MissionItemReached>().Select(r => (int)r.Message.Seq));
        Assert.Equal(MissionState.Complete, _flyer.All<MissionCurrent>().Last().Message.MissionState);
        Assert.Equal(Px4Mode.Mission, _flyer.Mode);
    }

    [Fact]
    public void Mission_Return_IsAutoRtl()
    {
        Upload(
            Item(MavCmd.NavTakeoff, height: 15), Item(MavCmd.NavWaypoint, 40, 0, 15), Item(MavCmd.NavReturnToLaunch));
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Mission));
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.ComponentArmDisarm, 1));
        _flyer.RunUntil(() => _flyer.Mode == Px4Mode.Rtl, 60, "in AUTO.RTL");
        Assert.True(Distance(40, 0) < 4);
        _flyer.RunUntil(() => !_flyer.Vehicle.Autopilot.IsArmed, 200, "landed and disarmed");
        Assert.True(Distance(0, 0) < 3);
        Assert.Equal([0, 1, 2], _flyer.All<MissionItemReached>().Select(r => (int)r.Message.Seq));
    }

    [Fact]
    public void MissionStart_WithoutAMissionOrItem_IsDenied()
    {
        Assert.Equal(MavResult.Denied, _flyer.Command(MavCmd.MissionStart));
        _flyer.TakeOff();
        Assert.Equal(MavResult.TemporarilyRejected, _flyer.SetMode(Px4Mode.Mission));
        Upload(Item(MavCmd.NavWaypoint, 30, 0, 15));
        Assert.Equal(MavResult.Denied, _flyer.Command(MavCmd.MissionStart, 1));
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.MissionStart, 0));
        _flyer.RunUntil(() => Distance(30, 0) < 2, 40, "there");
        _flyer.Run(10);
        Assert.Equal(MissionState.Complete, _flyer.All<MissionCurrent>().Last().Message.MissionState);
        Assert.True(Distance(30, 0) < 3, "it stays at the end");
    }

    [Fact]
    public void SetCurrent_InFlight_GoesOnFromThere()
    {
        _flyer.TakeOff();
        Upload(
            Item(MavCmd.NavWaypoint, 300, 0, 15), Item(MavCmd.NavWaypoint, 0, 40, 15),
            Item(MavCmd.NavLoiterUnlim, 0, 40, 15));
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Mission));
        _flyer.Run(5);
        Assert.Equal(0, _flyer.All<MissionCurrent>().Last().Message.Seq);
        _flyer.Send(0, new MissionSetCurrent { TargetSystem = 1, TargetComponent = 1, Seq = 1 }, 1, 191);
        _flyer.RunUntil(() => Distance(0, 40) < 3, 60, "at the way-point jumped to");

        // Taken over, and resumed where it was.
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Loiter));
        _flyer.Run(1);
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Mission));
        _flyer.Run(3);
        Assert.Equal(2, _flyer.All<MissionCurrent>().Last().Message.Seq);
    }

    [Theory]
    [InlineData(MavMissionType.Mission, MavCmd.NavWaypoint)]
    [InlineData(MavMissionType.Rally, MavCmd.NavRallyPoint)]
    [InlineData(MavMissionType.Fence, MavCmd.NavFenceCircleInclusion)]
    public void Upload_OfEachType_ComesBackIsKeptInARebootAndCleared(MavMissionType type, MavCmd command)
    {
        Assert.Equal(MavMissionResult.Accepted, Upload(type, Item(command, 60, 20, 20, param1: 50)));
        _flyer.Vehicle.Reboot(staysArmed: false);
        _flyer.Run(10);
        Request(type);
        Assert.Equal(1, _flyer.All<MissionCount>(1).Last().Message.Count);
        _flyer.Send(
            1, new MissionRequestInt { TargetSystem = 1, TargetComponent = 1, MissionType = type }, 255, 190);
        MissionItemInt item = _flyer.All<MissionItemInt>(1).Last().Message;
        Assert.Equal((command, 20f, type), (item.Command, item.Z, item.MissionType));
        _flyer.Send(1, new MissionClearAll { TargetSystem = 1, TargetComponent = 1, MissionType = type }, 255, 190);
        Assert.Equal(MavMissionResult.Accepted, _flyer.All<MissionAck>(1).Last().Message.Type);
        Request(type);
        Assert.Equal(0, _flyer.All<MissionCount>(1).Last().Message.Count);
    }

    [Fact]
    public void Upload_WithAnItemThatIsNotFlown_IsRefusedAndEnds()
    {
        Assert.Equal(
            MavMissionResult.Unsupported, Upload(Item(MavCmd.NavWaypoint, 10, 0, 10), Item(MavCmd.DoJump)));
        Request(MavMissionType.Mission);
        Assert.Equal(0, _flyer.All<MissionCount>(1).Last().Message.Count);
    }

    [Fact]
    public void Clear_InFlight_StaysWhereItIs()
    {
        _flyer.TakeOff();
        Upload(Item(MavCmd.NavWaypoint, 300, 0, 15));
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Mission));
        _flyer.Run(10);
        _flyer.Send(0, new MissionClearAll { TargetSystem = 1, TargetComponent = 1 }, 1, 191);
        _flyer.Run(8);
        double before = Distance(0, 0);
        _flyer.Run(5);
        Assert.InRange(Distance(0, 0) - before, -1, 1);
        Assert.Equal(MissionState.NoMission, _flyer.All<MissionCurrent>().Last().Message.MissionState);
    }

    private void Request(MavMissionType type) => _flyer.Send(
        1, new MissionRequestList { TargetSystem = 1, TargetComponent = 1, MissionType = type }, 255, 190);

    private double Distance(double north, double east)
    {
        NedPosition here = _flyer.Pose.Position;
        return Math.Sqrt(Math.Pow(here.North - north, 2) + Math.Pow(here.East - east, 2));
    }

    private MavMissionResult Upload(params MissionItemInt[] items) => Upload(MavMissionType.Mission, items);

    private MavMissionResult Upload(MavMissionType type, params MissionItemInt[] items)
    {
        _flyer.Send(0, new MissionCount
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Count = (ushort)items.Length,
            MissionType = type,
        }, 1, 191);
        for (int i = 0; i < items.Length; i++)
        {
            Assert.Equal(i, _flyer.All<MissionRequestInt>().Last().Message.Seq);
            _flyer.Send(0, items[i] with { Seq = (ushort)i, MissionType = type }, 1, 191);
        }

        return _flyer.All<MissionAck>().Last().Message.Type;
    }

    private MissionItemInt Item(
        MavCmd command, double north = 0, double east = 0, double height = 0, float param1 = 0, float param2 = 0)
        => MissionItems.Item(_flyer.Home, command, north, east, height, param1, param2);
}
