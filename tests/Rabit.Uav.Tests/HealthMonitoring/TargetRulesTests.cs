using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>The rules for the times of pictures, and for targets that are not seen again.</summary>
public class TargetRulesTests
{
    private const HealthReasons Ours = HealthReasons.CameraClockOffset | HealthReasons.TargetsNotConfirmed;

    [Theory]
    [InlineData(0.05, 0.001, false)]
    [InlineData(0.07, 0.010, false)]   // 0.05 s is within three standard deviations
    [InlineData(0.09, 0.010, true)]
    [InlineData(-0.09, 0.010, true)]
    [InlineData(0.4, 0.12, false)]
    public void CameraClock_Off_IsReportedWhereItIsCertain(double offset, double error, bool isReported)
    {
        using FlownVehicle vehicle = Fly(Clock(offset, error, excludesMount: true), seconds: 3);
        Assert.Equal(isReported ? HealthReasons.CameraClockOffset : HealthReasons.None, vehicle.Report.Reasons & Ours);
        Assert.Equal(HealthAdvice.None, vehicle.Report.Advice);
        if (isReported)
            Assert.Equal(
                "times of pictures and poses are 90 ms apart (camera clock or delay of the link)", vehicle.Report.Text);
    }

    [Fact]
    public void CameraClock_MountWouldShowTheSame_TheTextSaysSo()
    {
        using FlownVehicle vehicle = Fly(Clock(0.12, 0.02, excludesMount: false), seconds: 3);
        Assert.Equal(
            "times of pictures and poses are 120 ms apart, or the mount is off in pitch (looks alike)",
            vehicle.Report.Text);
    }

    [Fact]
    public void CameraClock_FarOff_EndsTheSearchAfterItsDwell()
    {
        using FlownVehicle vehicle = Fly(Clock(-0.35, 0.01, excludesMount: true), seconds: 0.5);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (vehicle.Report.Reasons & Ours, vehicle.Report.Advice));
        vehicle.Fly(2);
        Assert.Equal(
            (HealthLevel.Critical, HealthReasons.CameraClockOffset, HealthAdvice.ReturnToLaunch),
            (vehicle.Report.Level, vehicle.Report.Reasons & Ours, vehicle.Report.Advice));
    }

    [Fact]
    public void CameraClock_JustBelowTheLimit_EndsNothing()
    {
        using FlownVehicle vehicle = Fly(Clock(0.32, 0.01, excludesMount: true), seconds: 10);
        Assert.Equal(
            (HealthLevel.Warning, HealthAdvice.None), (vehicle.Report.Level, vehicle.Report.Advice));
    }

    // A warning does not come and go with each pass: it ends where the offset itself is below the limit.
    [Fact]
    public void CameraClock_EstimateGetsBetter_WarningEndsBelowTheLimitOnly()
    {
        using FlownVehicle vehicle = Fly(Clock(0.09, 0.01, excludesMount: true), seconds: 3);
        vehicle.Rig.PostMission(Clock(0.07, 0.01, excludesMount: true));
        vehicle.Fly(2);
        Assert.Equal(HealthReasons.CameraClockOffset, vehicle.Report.Reasons & Ours);
        vehicle.Rig.PostMission(Clock(0.04, 0.005, excludesMount: true));
        vehicle.Fly(2);
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons & Ours);
    }

    [Theory]
    [InlineData(7, 0, 0, 0, false)]
    [InlineData(8, 3, 0, 0, true)]
    [InlineData(8, 4, 0, 0, false)]
    [InlineData(0, 3, 3, 2, false)]
    [InlineData(0, 3, 1, 2, true)]
    [InlineData(0, 3, 0, 1, false)]
    public void Targets_NotSeenAgain_AreReportedAfterFiveSeconds(
        int notConfirmed, int confirmed, int revisits, int failed, bool isReported)
    {
        var status = new MissionStatus
        {
            Phase = MissionPhase.Searching,
            TracksNotConfirmed = notConfirmed,
            TracksConfirmed = confirmed,
            Revisits = revisits,
            RevisitsFailed = failed,
        };
        using FlownVehicle vehicle = Fly(status, seconds: 4);
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons & Ours);
        vehicle.Fly(3);
        Assert.Equal(
            isReported ? HealthReasons.TargetsNotConfirmed : HealthReasons.None, vehicle.Report.Reasons & Ours);
        Assert.Equal(HealthAdvice.None, vehicle.Report.Advice);

        vehicle.Rig.PostMission(new MissionStatus { Phase = MissionPhase.Searching, TracksConfirmed = 9 });
        vehicle.Fly(7);
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons & Ours);
    }

    private static FlownVehicle Fly(in MissionStatus status, double seconds)
    {
        var vehicle = new FlownVehicle();
        vehicle.Rig.PostMission(status);
        vehicle.Fly(seconds);
        return vehicle;
    }

    private static MissionStatus Clock(double offset, double error, bool excludesMount) => new()
    {
        Phase = MissionPhase.Searching,
        CameraClock = new CameraClockEstimate
        {
            OffsetSeconds = offset,
            ErrorSeconds = error,
            ExcludesMount = excludesMount,
            Passes = 20,
            Targets = 3,
        },
    };
}
