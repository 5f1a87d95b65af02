using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>Reads what is posted in a flight.</summary>
internal sealed class SampleRecorder(RabitWorkspace workspace)
{
    private readonly MessageSubscriber<VehicleState> _vehicle
        = workspace.Subscribe<VehicleState>(MessageNames.VehicleState);
    private readonly MessageSubscriber<AutopilotStatistics> _autopilot
        = workspace.Subscribe<AutopilotStatistics>(MessageNames.AutopilotStatistics);
    private readonly MessageSubscriber<NavigationStatus> _navigation
        = workspace.Subscribe<NavigationStatus>(MessageNames.Navigation);
    private readonly MessageSubscriber<OwnAddress> _ownAddress
        = workspace.Subscribe<OwnAddress>(MessageNames.OwnAddress);
    private readonly MessageSubscriber<MissionStatus> _mission
        = workspace.Subscribe<MissionStatus>(MessageNames.Mission);
    private readonly MessageSubscriber<ImagingStatus> _imaging
        = workspace.Subscribe<ImagingStatus>(MessageNames.Imaging);
    private readonly MessageSubscriber<LinkStatus> _link
        = workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(0));

    public ReadMessages Take(TimeSpan now)
    {
        _vehicle.Fetch();
        _autopilot.Fetch();
        _navigation.Fetch();
        _ownAddress.Fetch();
        _mission.Fetch();
        _imaging.Fetch();
        _link.Fetch();
        return new ReadMessages
        {
            Time = now,
            Vehicle = _vehicle.Value,
            Autopilot = _autopilot.Value,
            Navigation = _navigation.Value,
            OwnAddress = _ownAddress.Value,
            Mission = _mission.Value,
            Imaging = _imaging.Value,
            Link = _link.Value,
        };
    }
}
