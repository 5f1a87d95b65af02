using System;
using Rabit.Uav.Messages;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>What Health Monitoring and Mission Control read at one time of a flight.</summary>
internal struct ReadMessages
{
    public TimeSpan Time { get; set; }

    public VehicleState Vehicle { get; set; }

    public AutopilotStatistics Autopilot { get; set; }

    public NavigationStatus Navigation { get; set; }

    public OwnAddress OwnAddress { get; set; }

    public MissionStatus Mission { get; set; }

    public ImagingStatus Imaging { get; set; }

    public LinkStatus Link { get; set; }
}
