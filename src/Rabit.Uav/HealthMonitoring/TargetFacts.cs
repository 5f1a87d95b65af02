using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the times of pictures and poses, and what follows from wrong ones.</summary>
internal readonly struct TargetFacts
{
    public TargetFacts(in MissionStatus mission, in AutopilotStatistics autopilot)
    {
        CameraClock = mission.CameraClock;
        (PoseTimeErrorSeconds, RoundTripSeconds) = (autopilot.PoseTimeErrorSeconds, autopilot.RoundTripSeconds);
        (Revisits, RevisitsFailed) = (mission.Revisits, mission.RevisitsFailed);
        (Confirmed, NotConfirmed) = (mission.TracksConfirmed, mission.TracksNotConfirmed);
    }

    public CameraClockEstimate CameraClock { get; }

    /// <summary>One standard deviation of the times of poses.</summary>
    public double PoseTimeErrorSeconds { get; }

    public double RoundTripSeconds { get; }

    public int Confirmed { get; }

    /// <summary>Tracks that are tentative, or were confirmed once and are lost.</summary>
    public int NotConfirmed { get; }

    /// <summary>Targets that were seen again.</summary>
    public int Revisits { get; }

    /// <summary>Targets that were not.</summary>
    public int RevisitsFailed { get; }
}
