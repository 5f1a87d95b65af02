using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>OFFBOARD: how it begins, what it flies, how it ends, and that it comes back.</summary>
public class Px4OffboardTests
{
    private readonly Px4Flyer _flyer = new();
    private readonly Px4Path _path;

    public Px4OffboardTests() => _path = new Px4Path(_flyer);

    [Fact]
    public void SetMode_WithoutSetPoints_IsTemporarilyRejected()
    {
        _flyer.TakeOff();
        Assert.Equal(MavResult.TemporarilyRejected, _flyer.SetMode(Px4Mode.Offboard));
        Assert.Equal(Px4Mode.Loiter, _flyer.Mode);
    }

    [Fact]
    public void Mission_ScriptedTakeOffLegsReturn_LandsAtHomeAndDisarms()
    {
        Begin();
        _path.Fly(25, 60, 6);
        double fastest = 0;
        Run(14.6, () => fastest = Math.Max(fastest, _flyer.Pose.VelocityNed.HorizontalLength));
        Assert.InRange(fastest, 5.5, 7);
        Assert.InRange(_flyer.Pose.Position.North, 60 * Math.Cos(25 * Math.PI / 180) - 4, 60);
        _path.Fly(115, 45, 6);
        Run(12.6);
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Rtl));
        _path.Stop();
        _flyer.RunUntil(() => !_flyer.Vehicle.Autopilot.IsArmed, 90, "landed and disarmed");
        Assert.True(Math.Abs(_flyer.Pose.Position.North) < 4 && Math.Abs(_flyer.Pose.Position.East) < 4);
        Assert.Equal(Px4Mode.Offboard, _flyer.Mode);   // as recorded: the mode from before, disarmed
        Assert.True(_flyer.Pose.Position.Down >= 0);
    }

    [Fact]
    public void SetPoint_FarAway_IsAJumpThatOnlyTheSpeedLimitHoldsBack()
    {
        Begin();
        Send(new SetPositionTargetLocalNed
        {
            CoordinateFrame = MavFrame.LocalNed,
            TypeMask = (PositionTargetTypemask)0xDF8,
            X = 300,
            Z = -12,
        }, 6);
        Assert.InRange(_flyer.Pose.VelocityNed.HorizontalLength, 10, 13);
    }

    [Fact]
    public void SetPoint_OfVelocity_IsFlown()
    {
        Begin();
        Send(new SetPositionTargetLocalNed
        {
            CoordinateFrame = MavFrame.LocalNed,
            TypeMask = (PositionTargetTypemask)0xDC7,
            Vx = 3,
            Vz = -1,
        }, 5);
        Assert.InRange(_flyer.Pose.VelocityNed.North, 2.5, 3.5);
        Assert.InRange(_flyer.Pose.VelocityNed.Down, -1.3, -0.7);
    }

    [Fact]
    public void ChangeSpeed_InOffboard_IsAcceptedWithoutEffect()
    {
        Begin();
        _path.Fly(0, 60, 6);
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.DoChangeSpeed, 1, 2));
        Run(8);
        Assert.InRange(_flyer.Pose.VelocityNed.HorizontalLength, 5, 7);
    }

    [Theory]
    [InlineData(0, Px4Mode.Posctl)]
    [InlineData(5, Px4Mode.Loiter)]
    [InlineData(3, Px4Mode.Rtl)]
    public void SetPoints_StopAndComeAgain_FailsafeAndOffboardWithoutACommand(int action, object failsafe)
    {
        Begin();
        _flyer.Set("COM_OBL_RC_ACT", action);
        _path.Stop();
        Run(1.3);
        Assert.Equal((Px4Mode)failsafe, _flyer.Mode);
        Assert.Equal(MavState.Critical, _flyer.AskForHeartbeat().SystemStatus);
        Assert.Contains(Px4Event.FailsafeGeneric, _flyer.Events);

        _path.Start();
        Run(0.3);
        Assert.Equal(Px4Mode.Offboard, _flyer.Mode);
        Assert.Equal(MavState.Active, _flyer.AskForHeartbeat().SystemStatus);
    }

    [Fact]
    public void SetPoints_ComeAgainAfterACommandedMode_AreIgnored()
    {
        Begin();
        _path.Stop();
        Run(1.3);
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Loiter, link: 1));
        _path.Start();
        Run(3);
        Assert.Equal(Px4Mode.Loiter, _flyer.Mode);
    }

    [Theory]
    [InlineData(Px4Mode.Loiter)]
    [InlineData(Px4Mode.Posctl)]
    public void PilotsMode_WhileSetPointsGoOn_StandsAndStops(object mode)
    {
        Begin();
        _path.Fly(0, 100, 6);
        Run(8);
        Assert.Equal(MavResult.Accepted, _flyer.SetMode((Px4Mode)mode, link: 1));
        double north = _flyer.Pose.Position.North;
        Run(5);
        Assert.Equal((Px4Mode)mode, _flyer.Mode);
        Assert.InRange(_flyer.Pose.Position.North - north, 3, 10);   // recorded: 4.6 to 8 m to the stop
        Assert.True(_flyer.Pose.VelocityNed.HorizontalLength < 0.5);
    }

    [Fact]
    public void GlobalTarget_InOffboard_IsSilentAndComesAtOnceAfterLoiter()
    {
        Begin();
        Run(2);
        double before = _flyer.All<PositionTargetGlobalInt>().Last().Time;
        Assert.True(_flyer.Time - before > 1.9);
        _flyer.SetMode(Px4Mode.Loiter, link: 1);
        double commanded = _flyer.Time;
        Run(0.1);
        Assert.InRange(_flyer.All<PositionTargetGlobalInt>().Last().Time - commanded, 0, 0.05);
    }

    private void Begin()
    {
        _flyer.Step();
        _flyer.Set("COM_OF_LOSS_T", 1);
        _flyer.Set("MPC_TKO_SPEED", 3);
        _flyer.TakeOff();
        _path.Start();
        Run(1);
        Assert.Equal(MavResult.Accepted, _flyer.SetMode(Px4Mode.Offboard));
        Run(0.5);
    }

    private void Run(double seconds, Action? each = null) => _flyer.Run(seconds, () =>
    {
        _path.Step();
        each?.Invoke();
    });

    private void Send(SetPositionTargetLocalNed target, double seconds)
    {
        _path.Stop();
        (target.TargetSystem, target.TargetComponent) = (1, 1);
        double next = 0;
        _flyer.Run(seconds, () =>
        {
            if (_flyer.Time < next)
                return;
            next = _flyer.Time + 0.05;
            _flyer.Send(0, target, 1, 191);
        });
    }
}
