using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Whether a mission was accomplished, and why not, as Mission Control posts it.</summary>
public class MissionResultTests
{
    [Fact]
    public void Result_NoMission_IsNone()
    {
        using var rig = new MissionRig(null);
        rig.Run(2);

        Assert.Equal(MissionOutcome.None, rig.Status.Result.Outcome);
    }

    [Fact]
    public void Result_FlownToItsEnd_IsAccomplished()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunToEnd();

        MissionResult result = rig.Status.Result;
        Assert.Equal((MissionOutcome.Accomplished, MissionFailures.None), (result.Outcome, result.Failures));
        Assert.True(result is { HasFlown: true, HasLanded: true, OutsideFenceMetres: 0 });
        Assert.InRange(result.DistanceFromHomeMetres, 0, 2);
    }

    [Fact]
    public void Result_InTheAir_IsInProgressAndSaysWhatItWouldBeNow()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(1);

        Assert.Equal(
            (MissionOutcome.InProgress, MissionFailures.NotLanded),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));
        Assert.InRange(rig.Status.Result.DistanceFromHomeMetres, 30, 200);
    }

    [Fact]
    public void Result_Aborted_IsGivenUp()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Manager.Abort("asked to");
        rig.RunToEnd();

        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.GivenUp), (rig.Status.Result.Outcome, rig.Status.Result.Failures));
    }

    [Fact]
    public void Result_NeverArmed_IsNotFlown()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Arm ? VehicleCommandOutcome.Refused : null;
        rig.RunToEnd(100);

        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.NotFlown), (rig.Status.Result.Outcome, rig.Status.Result.Failures));
    }

    [Fact]
    public void Result_PilotTakesOver_IsNotLandedUntilTheMotorsAreOff()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(2);
        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.NotLanded),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));

        rig.Vehicle.IsArmed = false;
        rig.Run(2);
        Assert.Equal(MissionFailures.AwayFromHome, rig.Status.Result.Failures);
    }

    [Fact]
    public void Result_BlownOutOfTheFence_SaysHowFar()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.North += 200;
        rig.RunToEnd();

        MissionResult result = rig.Status.Result;
        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.GivenUp | MissionFailures.OutsideFence),
            (result.Outcome, result.Failures));
        Assert.InRange(result.OutsideFenceMetres, 50, 250);
    }
}
