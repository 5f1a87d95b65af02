using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
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

    // Finding mission.md 19: 93 % of the area was enough.
    [Theory]
    [InlineData("", 0.98)]
    [InlineData(",\"requiredCoverage\":0.3", 0.3)]
    public void Result_CameraSeesNothing_IsFailedByTheCoverage(string more, double required)
    {
        using var rig = new MissionRig(MissionRig.Mission(more));
        rig.Vehicle.CameraSees = false;
        rig.RunToEnd();

        MissionResult result = rig.Status.Result;
        Assert.Equal((MissionOutcome.Failed, MissionFailures.AreaNotSeen), (result.Outcome, result.Failures));
        Assert.Equal((required, 0.0), (result.RequiredCoverage, rig.Status.Coverage));
    }

    [Fact]
    public void Result_AsMuchSeenAsIsRequired_IsAccomplished()
    {
        using var rig = new MissionRig(MissionRig.Mission(",\"requiredCoverage\":0.3"), o => o.MaxGapPasses = 0);
        rig.RunUntil(MissionPhase.Searching);
        for (int i = 0; i < 2000 && rig.Status.Coverage < 0.3; i++)
            rig.Run(0.1);
        rig.Vehicle.CameraSees = false;
        rig.RunToEnd();

        Assert.InRange(rig.Status.Coverage, 0.3, 0.5);
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
    }

    [Fact]
    public void Result_FlownWithoutACamera_HasNoCriterionOfCoverage()
    {
        using var rig = new MissionRig(MissionRig.Mission(), o => o.RequiresCamera = false);
        (rig.Vehicle.HasCamera, rig.Vehicle.CameraSees) = (false, false);
        rig.RunToEnd();

        MissionResult result = rig.Status.Result;
        Assert.Equal((MissionOutcome.Accomplished, 0.0), (result.Outcome, result.RequiredCoverage));

        // All of the area would be a gap.
        Assert.DoesNotContain(" over gaps", rig.Story, System.StringComparison.Ordinal);
    }

    // Otherwise the search would end short of what is required, without flying over the gaps.
    [Fact]
    public void Search_MoreIsRequiredThanTheGoal_GapsAreFlownOver()
    {
        using var rig = new MissionRig(MissionRig.Mission(",\"requiredCoverage\":0.9"), o => o.CoverageGoal = 0.1);
        for (int i = 0; i < 2000 && rig.Status.Coverage < 0.2; i++)
            rig.Run(0.1);
        rig.Vehicle.CameraSees = false;
        rig.Run(20);
        rig.Vehicle.CameraSees = true;
        rig.RunToEnd();

        Assert.Contains(" over gaps", rig.Story, System.StringComparison.Ordinal);
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
    }

    [Fact]
    public void Result_InTheAir_IsInProgressAndSaysWhatItWouldBeNow()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(1);

        Assert.Equal(
            (MissionOutcome.InProgress, MissionFailures.NotLanded | MissionFailures.AreaNotSeen),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));
        Assert.InRange(rig.Status.Result.DistanceFromHomeMetres, 30, 200);
    }

    [Fact]
    public void Result_Aborted_IsGivenUp()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Manager.ReturnToLaunch("test", "asked to");
        rig.RunToEnd();

        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.GivenUp | MissionFailures.AreaNotSeen),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));
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
            (MissionOutcome.Failed,
                MissionFailures.NotLanded | MissionFailures.TakenOver | MissionFailures.AreaNotSeen),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));

        rig.Vehicle.Height = 0;
        rig.Run(1);
        rig.Vehicle.IsArmed = false;
        rig.Run(2);
        Assert.Equal(
            MissionFailures.AwayFromHome | MissionFailures.TakenOver | MissionFailures.AreaNotSeen,
            rig.Status.Result.Failures);
    }

    [Fact]
    public void Result_TakeoverIsExplainedLater_SaysByWhom()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode STABILIZE");
        rig.Run(2);
        rig.Vehicle.TakeOver("a reboot of the autopilot", TakeoverCause.Reboot);
        rig.Run(2);
        Assert.Equal("the autopilot rebooted: a reboot of the autopilot", rig.Status.TakenOver);
    }

    [Theory]
    [InlineData(MissionPhase.TakingOff)]
    [InlineData(MissionPhase.Landing)]
    public void Result_MotorsStopInTheAir_IsNeitherLandedNorAccomplished(MissionPhase phase)
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(phase);
        for (int i = 0; i < 100 && !(rig.Vehicle.Height is > 6 and < 30); i++)
            rig.Run(0.2);
        rig.Vehicle.IsArmed = false;
        rig.Run(2);
        MissionResult result = rig.Status.Result;
        Assert.Equal((MissionPhase.Failed, MissionOutcome.Failed), (rig.Status.Phase, result.Outcome));
        Assert.False(result.HasLanded);
        Assert.True((result.Failures & MissionFailures.NotLanded) != 0);
    }

    [Fact]
    public void Result_LandedWithoutUsAtHome_IsGivenUp()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.IsConnected = false;
        rig.Run(20);
        (rig.Vehicle.North, rig.Vehicle.East, rig.Vehicle.Height, rig.Vehicle.IsArmed) = (0, 0, 0, false);
        rig.Vehicle.IsConnected = true;
        rig.Run(2);
        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.GivenUp | MissionFailures.AreaNotSeen),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));
    }

    [Theory]
    [InlineData(TakeoverCause.Mode, "the pilot took over: mode RTL")]
    [InlineData(TakeoverCause.Failsafe, "the autopilot's failsafe took over: mode RTL")]
    [InlineData(TakeoverCause.OtherCommander, "another commander took over: mode RTL")]
    public void Result_TakenOverAndLandedAtHome_IsFailedAndSaysByWhom(TakeoverCause cause, string text)
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode RTL", cause);
        rig.Run(2);
        (rig.Vehicle.North, rig.Vehicle.East, rig.Vehicle.Height) = (0, 0, 0);
        rig.Run(1);
        rig.Vehicle.IsArmed = false;
        rig.Run(2);

        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.TakenOver | MissionFailures.AreaNotSeen),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));
        Assert.Equal(text, rig.Status.TakenOver);
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
            (MissionOutcome.Failed,
                MissionFailures.GivenUp | MissionFailures.OutsideFence | MissionFailures.AreaNotSeen),
            (result.Outcome, result.Failures));
        Assert.InRange(result.OutsideFenceMetres, 50, 250);
    }
}
