using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>The values of the mission as MAVLink parameters of our component.</summary>
public sealed class GroundParameterTests : IDisposable
{
    private readonly GroundRig _ground = new(MissionRig.In(MissionPhase.Searching));

    [Theory]
    [InlineData(0)]
    [InlineData(GroundRig.Us)]
    public void List_OfUsOrOfAll_HasAllWithTheValuesOfTheMission(byte component)
    {
        _ground.Send(new ParamRequestList { TargetSystem = 1, TargetComponent = component });
        _ground.Run(1);
        List<ParamValue> values = _ground.Take<ParamValue>();
        Assert.Equal(
            [
                "RBT_HEIGHT=40", "RBT_SPEED=8", "RBT_SPACING=30", "RBT_REVISIT=1", "RBT_REVISIT_HGT=0",
                "RBT_REVISIT_RAD=10", "RBT_BAT_START=0.5", "RBT_BAT_RESERVE=0.1", "RBT_COVERAGE=0.98",
            ],
            values.Select(v => FormattableString.Invariant($"{v.ParamId}={v.Value}")));
        Assert.All(values, v => Assert.Equal((MavParamType.Real32, 9), (v.ParamType, v.ParamCount)));
    }

    [Fact]
    public void Read_ByNameAndByIndex_IsAnswered()
    {
        _ground.Send(new ParamRequestRead
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            ParamIndex = -1,
            ParamId = new Text16("RBT_SPEED"),
        });
        _ground.Send(new ParamRequestRead { TargetSystem = 1, TargetComponent = GroundRig.Us, ParamIndex = 1 });
        _ground.Run(0.5);
        Assert.All(_ground.Take<ParamValue>(), v => Assert.Equal("RBT_SPEED", v.ParamId.ToString()));
    }

    [Fact]
    public void Set_SpeedInALane_HoldsFromTheNextLegOn()
    {
        MissionFlight flight = _ground.Flight.Manager.Flight!;
        _ground.Run(3);
        Set("RBT_SPEED", 5.1f);
        _ground.Run(0.5);
        Assert.Equal(5.1f, Assert.Single(_ground.Take<ParamValue>()).Value);
        Assert.Equal(8, flight.Mission.SpeedMetresPerSecond);
        int lanes = flight.Route!.Flown;
        for (int i = 0; i < 600 && flight.Route.Flown == lanes; i++)
        {
            Assert.Equal(8, flight.Mission.SpeedMetresPerSecond);
            _ground.Run(0.1);
        }

        _ground.Run(0.5);
        Assert.Equal(5.1, flight.Mission.SpeedMetresPerSecond);
        Assert.Contains(
            "operator system 255 component 190's set Speed to 5.1 accepted: from the next leg on", _ground.Flight.Story,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Set_HeightAndSpacingInALane_AreFlownAndCoverTheArea()
    {
        _ground.Run(3);
        Set("RBT_HEIGHT", 50);
        Set("RBT_SPACING", 20);
        _ground.Run(0.5);
        Assert.Equal([50, 20], _ground.Take<ParamValue>().Select(v => v.Value));
        int before = _ground.Flight.Manager.Flight!.Route!.Count;
        Assert.Equal(MissionPhase.Done, _ground.Flight.RunToEnd());
        MissionFlight flight = _ground.Flight.Manager.Flight;
        Assert.True(flight.Route!.Count > before, $"{flight.Route.Count} legs");
        Assert.InRange(_ground.Flight.Status.Coverage, 0.985, 1);
        Assert.InRange(_ground.Flight.Vehicle.Path.Max(p => p.Height), 49, 52);
    }

    [Theory]
    [InlineData("RBT_SPEED", 50f, "RBT_SPEED: speedMetresPerSecond is 50; it must be 0.5 to 20", 8f)]
    [InlineData("RBT_HEIGHT", 4f, "RBT_HEIGHT: heightMetres is 4; it must be 5 to 120", 40f)]
    [InlineData("RBT_SPACING", 1f, "RBT_SPACING: laneSpacingMetres is 1; it must be 2 to 200", 30f)]
    [InlineData("RBT_SPACING", 90f, "RBT_SPACING: fenceMarginMetres is 40; it must be at least 55", 30f)]
    [InlineData("RBT_REVISIT", 0.5f, "RBT_REVISIT: revisit.enabled is 0 or 1", 1f)]
    [InlineData("RBT_REVISIT_HGT", 3f, "RBT_REVISIT_HGT: revisit.heightMetres is 3; it must be 5 to 120", 0f)]
    [InlineData("RBT_BAT_START", 0.6f, "RBT_BAT_START: it has taken off", 0.5f)]
    [InlineData("RBT_BAT_RESERVE", 0.9f, "RBT_BAT_RESERVE: limits.energyReserveFraction is 0.9; it must be", 0.1f)]
    [InlineData("RBT_COVERAGE", -1f, "RBT_COVERAGE: requiredCoverage is -1; it must be 0 to 1", 0.98f)]
    [InlineData("RBT_SPEED", float.NaN, "RBT_SPEED: NaN does not fit its type", 8f)]
    [InlineData("RBT_SPEED", float.PositiveInfinity, "RBT_SPEED: ", 8f)]
    public void Set_WrongValue_IsAnsweredByTheOldOneAndTheReason(string name, float value, string reason, float old)
    {
        Set(name, value);
        _ground.Run(1);
        Assert.Equal(old, Assert.Single(_ground.Take<ParamValue>()).Value);
        Assert.StartsWith(reason, Assert.Single(_ground.Texts), StringComparison.Ordinal);
        Assert.Single(_ground.Take<ParamError>());
        Assert.False(_ground.Flight.Manager.Flight!.Changes.AreDue);
    }

    [Fact]
    public void Set_UnknownName_IsAnsweredByAnError()
    {
        Set("RBT_NOTHING", 1);
        _ground.Run(1);
        Assert.Empty(_ground.Take<ParamValue>());
        Assert.Equal(MavParamError.DoesNotExist, Assert.Single(_ground.Take<ParamError>()).Error);
    }

    [Fact]
    public void Set_AnotherType_IsRefused()
    {
        Set("RBT_SPEED", 5, type: MavParamType.Int32);
        _ground.Run(1);
        Assert.Equal(8, Assert.Single(_ground.Take<ParamValue>()).Value);
        Assert.Equal(MavParamError.TypeMismatch, Assert.Single(_ground.Take<ParamError>()).Error);
    }

    [Fact]
    public void Set_ByASenderThatMayNotCommand_IsRefused()
    {
        Set("RBT_SPEED", 5, from: 42);
        _ground.Run(1);
        Assert.Equal(8, Assert.Single(_ground.Take<ParamValue>()).Value);
        Assert.Equal(MavParamError.PermissionDenied, Assert.Single(_ground.Take<ParamError>()).Error);
        Assert.Equal("RBT_SPEED: it may not command", Assert.Single(_ground.Texts));
    }

    [Fact]
    public void Set_ForAllComponents_IsNotOurs()
    {
        Set("RBT_SPEED", 5, component: 0);
        _ground.Run(1);
        Assert.Empty(_ground.Take<ParamValue>());
        Assert.False(_ground.Flight.Manager.Flight!.Changes.AreDue);
    }

    [Fact]
    public void Set_BeforeTakeOff_HoldsAtOnce()
    {
        using var ground = new GroundRig(MissionRig.In(MissionPhase.WaitingForVehicle));
        ground.Send(new ParamSet
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            ParamId = new Text16("RBT_SPACING"),
            ParamType = MavParamType.Real32,
            ParamValue = 20,
        });
        ground.Run(0.5);
        Assert.Equal(20, Assert.Single(ground.Take<ParamValue>()).Value);
        Assert.Equal(MissionPhase.Searching, ground.Flight.RunUntil(MissionPhase.Searching));
        Assert.Equal(20, ground.Flight.Manager.Flight!.Mission.LaneSpacingMetres);
    }

    [Theory]
    [InlineData(MavCmd.RequestMessage, 148)]
    [InlineData(MavCmd.RequestAutopilotCapabilities, 1)]
    public void AutopilotVersion_OnRequest_SaysWhatIsServed(MavCmd command, float parameter)
    {
        _ground.Send(
            new CommandLong { Command = command, Param1 = parameter, TargetSystem = 1, TargetComponent = GroundRig.Us },
            from: 42);
        _ground.Run(1);
        Assert.Equal(MavResult.Accepted, Assert.Single(_ground.Take<CommandAck>()).Result);
        AutopilotVersion version = Assert.Single(_ground.Take<AutopilotVersion>());
        Assert.Equal(
            MavProtocolCapability.ParamEncodeBytewise | MavProtocolCapability.CommandInt
                | MavProtocolCapability.MissionInt | MavProtocolCapability.MissionFence
                | MavProtocolCapability.Mavlink2,
            version.Capabilities & ~MavProtocolCapability.Ftp);
        Assert.Equal(0x00_01_00_00u, version.FlightSwVersion);
    }

    [Fact]
    public void Ping_OfAll_IsAnsweredToTheAsker()
    {
        _ground.Send(new Ping { Seq = 5, TimeUsec = 77 }, from: 42);
        _ground.Run(1);
        Ping answer = Assert.Single(_ground.Take<Ping>());
        Assert.Equal((5u, 77ul, (byte)42), (answer.Seq, answer.TimeUsec, answer.TargetSystem));
    }

    // All values, by reflection: one that is forgotten would be lost with the first change.
    [Fact]
    public void With_AnyValue_KeepsAllOthers()
    {
        MissionPlan plan = MissionRig.Mission(
            ", \"keepOuts\": [[[47.3984,8.5456],[47.3986,8.5458],[47.3986,8.5456]]], \"laneHeadingDegrees\": 12,"
            + "\"targets\": [\"red\"], \"targetMotions\": {\"red\": \"walking\"},"
            + "\"targetClasses\": {\"green\": {\"colour\": \"#20a040\"}},"
            + "\"fenceMarginMetres\": 51, \"requiredCoverage\": 0.7,"
            + "\"obstacleHeightMetres\": 3,"
            + "\"revisit\": {\"heightMetres\": 20, \"radiusMetres\": 7, \"maxWayFraction\": 2, "
            + "\"followSeconds\": 33, \"followSpeedMetresPerSecond\": 9},"
            + "\"camera\": {\"pitchDegrees\": -70, \"yawDegrees\": 5, \"gimbal\": true}, \"allowPartialSearch\": true,"
            + "\"home\": {\"latitudeDegrees\": 47.3977, \"longitudeDegrees\": 8.5456}, \"name\": \"all\","
            + "\"groundStationLost\": {\"action\": \"hold\"}, \"limits\": {\"minBatteryFractionAtStart\": 0.6,"
            + "\"energyReserveFraction\": 0.2, \"allowUnknownBattery\": true, \"maxHeightMetres\": 90,"
            + "\"maxDistanceMetres\": 900}");
        MissionPlan changed = plan.With(MissionParameter.Speed, 3).WithSpeed(plan.SpeedMetresPerSecond);
        foreach (System.Reflection.PropertyInfo property in typeof(MissionPlan).GetProperties())
        {
            Assert.True(Equals(property.GetValue(plan), property.GetValue(changed)), property.Name);
            Assert.False(Equals(property.GetValue(plan), property.GetValue(new MissionPlan())), property.Name);
        }

        RevisitPlan revisit = plan.With(MissionParameter.RevisitHeight, 30).With(MissionParameter.RevisitRadius, 4)
            .With(MissionParameter.Revisits, 0).Revisit;
        Assert.Equal(
            (false, 30.0, 4.0, 2.0),
            (revisit.IsEnabled, revisit.HeightMetres, revisit.RadiusMetres, revisit.MaxWayFraction));
        Assert.Equal(
            (33, 9), ((int)revisit.FollowTime.TotalSeconds, revisit.FollowSpeedMetresPerSecond));
    }

    public void Dispose() => _ground.Dispose();

    private void Set(
        string name, float value, MavParamType type = MavParamType.Real32, byte from = GroundRig.Station,
        byte component = GroundRig.Us)
        => _ground.Send(
            new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = component,
                ParamId = new Text16(name),
                ParamType = type,
                ParamValue = value,
            },
            from);
}
