using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>Answers, parameters, events and the other protocols of the simulated PX4.</summary>
public class Px4CommandTests
{
    private readonly Px4Flyer _flyer = new();

    public Px4CommandTests() => _flyer.Run(0.2);

    [Fact]
    public void Heartbeat_RequestedOrAtAnInterval_AnsweredAtOnceAndFailed()
    {
        int before = _flyer.All<Heartbeat>().Count();
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.RequestMessage, Heartbeat.MavlinkId));
        Assert.Equal(before + 1, _flyer.All<Heartbeat>().Count());
        Assert.Equal(MavResult.Failed, _flyer.Command(MavCmd.SetMessageInterval, Heartbeat.MavlinkId, 200_000));
        Assert.Equal(MavResult.Denied, _flyer.Command(MavCmd.RequestMessage, 436));   // CURRENT_MODE
        _flyer.Run(10);
        Assert.InRange(_flyer.All<Heartbeat>().Count() - before, 10, 12);
    }

    [Fact]
    public void MessageInterval_Asked_IsKept()
    {
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.SetMessageInterval, Attitude.MavlinkId, 20_000));
        int before = _flyer.All<Attitude>().Count();
        _flyer.Run(2);
        Assert.InRange(_flyer.All<Attitude>().Count() - before, 99, 101);
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.SetMessageInterval, Attitude.MavlinkId, -1));
        before = _flyer.All<Attitude>().Count();
        _flyer.Run(2);
        Assert.Equal(before, _flyer.All<Attitude>().Count());
    }

    // On the ground the estimator knows of no wind, and nothing is sent (WIND_COV.hpp of PX4).
    [Fact]
    public void WindCov_Asked_IsAcceptedAndComesInTheAirOnly()
    {
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.SetMessageInterval, WindCov.MavlinkId, 500_000));
        _flyer.Run(2);
        Assert.Empty(_flyer.All<WindCov>());
        Assert.Equal(MavResult.Failed, _flyer.Command(MavCmd.SetMessageInterval, Wind.MavlinkId, 500_000));
    }

    [Theory]
    [InlineData(MavCmd.NavLoiterUnlim, MavResult.Unsupported)]
    [InlineData(MavCmd.DoSetStandardMode, MavResult.Unsupported)]
    [InlineData((MavCmd)31000, MavResult.Unsupported)]
    [InlineData(MavCmd.DoChangeSpeed, MavResult.Accepted)]
    [InlineData(MavCmd.NavReturnToLaunch, MavResult.Accepted)]
    public void Command_OfOtherKinds_IsAnsweredAsByPx4(MavCmd command, MavResult expected)
        => Assert.Equal(expected, _flyer.Command(command, 1, 4, -1));

    [Fact]
    public void Gimbal_GivenToTheSender_TurnsAtItsRate()
    {
        Assert.Equal(MavResult.Denied, _flyer.Command(MavCmd.DoGimbalManagerPitchyaw, -30, 20));
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoGimbalManagerConfigure, 1, 191));
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoGimbalManagerPitchyaw, -30, 20));
        _flyer.Run(0.5);
        Assert.InRange(_flyer.Pose.CameraPitch.Degrees, -62, -57);   // 60 degrees a second
        _flyer.Run(1);
        Assert.Equal(-30, _flyer.Pose.CameraPitch.Degrees, 3);
        Assert.Equal(20, _flyer.Pose.CameraYaw.Degrees, 3);
    }

    [Fact]
    public void Gimbal_GivenToAnotherAndBack_IsDeniedMeanwhile()
    {
        _flyer.Command(MavCmd.DoGimbalManagerConfigure, 1, 191);
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoGimbalManagerConfigure, 255, 190, link: 1));
        Assert.Equal(MavResult.Denied, _flyer.Command(MavCmd.DoGimbalManagerPitchyaw, -30, 20));
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoGimbalManagerConfigure, -3, -3));   // not its own
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoGimbalManagerPitchyaw, -30, 20, link: 1));
        _flyer.Command(MavCmd.DoGimbalManagerConfigure, -3, -3, link: 1);
        Assert.Equal(MavResult.Denied, _flyer.Command(MavCmd.DoGimbalManagerPitchyaw, -30, 20, link: 1));
    }

    [Fact]
    public void SetMode_Unknown_IsAcceptedWithoutEffect()
    {
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoSetMode, 1, 9, 9));
        Assert.Equal(Px4Mode.Loiter, _flyer.Mode);
    }

    [Fact]
    public void Arm_WhileACheckFails_IsRejectedAfterAnEventAndWithoutAText()
    {
        _flyer.Set("COM_CPU_MAX", 0.1);
        _flyer.Run(0.3);
        Assert.Equal(MavResult.TemporarilyRejected, _flyer.Command(MavCmd.ComponentArmDisarm, 1));
        Assert.Contains(Px4Event.LoadTooHigh, _flyer.Events);
        Assert.Empty(_flyer.All<Statustext>());
        _flyer.Set("COM_CPU_MAX", -1);
        _flyer.Run(0.3);
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.ComponentArmDisarm, 1));
    }

    [Fact]
    public void Arm_WithoutATakeOff_DisarmsAfterTenSeconds()
    {
        _flyer.Command(MavCmd.ComponentArmDisarm, 1);
        _flyer.Run(9);
        Assert.True(_flyer.Vehicle.Autopilot.IsArmed);
        _flyer.Run(2);
        Assert.False(_flyer.Vehicle.Autopilot.IsArmed);
    }

    [Fact]
    public void Disarm_InTheAir_IsRejectedWithAnEvent()
    {
        _flyer.TakeOff();
        Assert.Equal(MavResult.TemporarilyRejected, _flyer.Command(MavCmd.ComponentArmDisarm));
        Assert.Contains(Px4Event.DisarmDeniedInAir, _flyer.Events);
    }

    [Fact]
    public void Reposition_Frame6_HeightIsAboveSeaLevel()
    {
        _flyer.TakeOff();
        float height = (float)_flyer.Home.AltitudeAmslMetres + 20;
        CommandInt command = Reposition(MavFrame.GlobalRelativeAltInt, changesMode: true, height);
        Assert.Equal(MavResult.Accepted, _flyer.Command(command));
        _flyer.Run(20);
        Assert.InRange(-_flyer.Pose.Position.Down, 17, 23);
        Assert.InRange(_flyer.Pose.Position.North, 25, 31);
    }

    [Fact]
    public void Reposition_WithoutTheFlag_IsUnsupportedAndFlownInLoiterOnly()
    {
        _flyer.TakeOff();
        float height = (float)_flyer.Home.AltitudeAmslMetres + 12;
        Assert.Equal(MavResult.Unsupported, _flyer.Command(Reposition(MavFrame.Global, changesMode: false, height)));
        _flyer.Run(15);
        Assert.InRange(_flyer.Pose.Position.North, 25, 31);
        _flyer.SetMode(Px4Mode.Posctl);
        double north = _flyer.Pose.Position.North;
        CommandInt back = Reposition(MavFrame.Global, changesMode: false, height);
        back.X = (int)(_flyer.Home.Latitude.Degrees * 1e7);
        Assert.Equal(MavResult.Unsupported, _flyer.Command(back));
        _flyer.Run(10);
        Assert.InRange(_flyer.Pose.Position.North, north - 1, north + 1);
    }

    [Fact]
    public void PilotsHold_WhileItFliesToAReposition_IsAcceptedWithoutEffect()
    {
        _flyer.TakeOff();
        _flyer.Command(Reposition(MavFrame.Global, changesMode: true, (float)_flyer.Home.AltitudeAmslMetres + 12));
        _flyer.Run(3);
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Loiter, link: 1));
        _flyer.Run(15);
        Assert.InRange(_flyer.Pose.Position.North, 25, 31);
    }

    [Fact]
    public void Parameters_OfBothTypes_AreSentByteWise()
    {
        _flyer.Send(0, new ParamRequestList { TargetSystem = 1, TargetComponent = 1 }, 1, 191);
        _flyer.Run(1);
        List<ParamValue> all = _flyer.All<ParamValue>().Select(p => p.Message).ToList();
        Assert.Equal(all[0].ParamCount, all.Count);
        ParamValue action = all.Single(p => p.ParamId.TextEquals("NAV_RCL_ACT"));
        Assert.Equal(MavParamType.Int32, action.ParamType);
        Assert.Equal(2, System.BitConverter.ToInt32(System.BitConverter.GetBytes(action.Value), 0));
        Assert.Equal(0.15f, all.Single(p => p.ParamId.TextEquals("BAT_LOW_THR")).Value);
    }

    [Fact]
    public void ParamSet_OfTheWrongType_LeavesTheValue()
    {
        _flyer.Send(0, new ParamSet
        {
            TargetSystem = 1,
            TargetComponent = 1,
            ParamId = new Text16("GF_ACTION"),
            ParamType = MavParamType.Real32,
            ParamValue = 3,
        }, 1, 191);
        ParamValue answer = _flyer.All<ParamValue>().Last().Message;
        Assert.Equal(2, System.BitConverter.ToInt32(System.BitConverter.GetBytes(answer.Value), 0));
    }

    [Fact]
    public void Timesync_Answers_EchoTheNonceWhateverTheirTarget()
    {
        for (int request = 1; request <= 20; request++)
            _flyer.Send(0, new Timesync { Ts1 = request, TargetSystem = 1, TargetComponent = 1 }, 1, 191);
        Timesync[] answers = _flyer.All<Timesync>().Select(t => t.Message).Where(t => t.Tc1 != 0).ToArray();
        Assert.Equal(Enumerable.Range(1, 20).Select(n => (long)n), answers.Select(a => a.Ts1));
        Assert.Contains(answers, a => a.TargetSystem != 1 || a.TargetComponent != 191);
    }

    [Fact]
    public void Texts_WhereAGroundStationIsConnected_OnThatLinkOnly()
    {
        _flyer.Send(1, new Heartbeat { Type = MavType.Gcs }, 255, 190);
        _flyer.Command(MavCmd.ComponentArmDisarm, 1);
        Assert.Empty(_flyer.All<Statustext>());
        Assert.Equal("Armed by external command\t", _flyer.All<Statustext>(1).Single().Message.Text.ToString());
        Assert.Contains(Px4Event.ArmedBy, _flyer.Events);
    }

    [Fact]
    public void RequestEvent_OfKeptAndOfOldOnes_SendsThemOrAnError()
    {
        _flyer.Command(MavCmd.ComponentArmDisarm, 1);
        Event armed = _flyer.All<Event>().Last().Message;
        _flyer.Send(0, new RequestEvent
        {
            TargetSystem = 1,
            TargetComponent = 1,
            FirstSequence = armed.Sequence,
            LastSequence = (ushort)(armed.Sequence + 1),
        }, 1, 191);
        Assert.Equal(armed.Id, _flyer.All<Event>().Last().Message.Id);
        ResponseEventError error = _flyer.All<ResponseEventError>().Single().Message;
        Assert.Equal(armed.Sequence + 1, error.Sequence);
        Assert.Equal(MavEventErrorReason.Unavailable, error.Reason);
    }

    private CommandInt Reposition(MavFrame frame, bool changesMode, float height) => new()
    {
        TargetSystem = 1,
        TargetComponent = 1,
        Command = MavCmd.DoReposition,
        Frame = frame,
        Param1 = -1,
        Param2 = changesMode ? 1 : 0,
        Param4 = float.NaN,
        X = (int)((_flyer.Home.Latitude.Degrees * 1e7) + (28 / 0.0111)),
        Y = (int)(_flyer.Home.Longitude.Degrees * 1e7),
        Z = height,
    };
}
