using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>Posts the messages of a flight again, four times a second, and takes what is sent.</summary>
internal sealed class SampleManager : RabitManager
{
    private readonly IReadOnlyList<ReadMessages> _samples;
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<AutopilotStatistics> _autopilot;
    private readonly MessagePublisher<NavigationStatus> _navigation;
    private readonly MessagePublisher<OwnAddress> _ownAddress;
    private readonly MessagePublisher<MissionStatus> _mission;
    private readonly MessagePublisher<ImagingStatus> _imaging;
    private readonly MessagePublisher<LinkStatus> _link;
    private readonly QueueReceiver<OutgoingFrame> _outgoing;
    private int _next;

    public SampleManager(IReadOnlyList<ReadMessages> samples)
        : base("samples")
    {
        _samples = samples;
        _vehicle = Publish<VehicleState>(MessageNames.VehicleState);
        _autopilot = Publish<AutopilotStatistics>(MessageNames.AutopilotStatistics);
        _navigation = Publish<NavigationStatus>(MessageNames.Navigation);
        _ownAddress = Publish<OwnAddress>(MessageNames.OwnAddress);
        _mission = Publish<MissionStatus>(MessageNames.Mission);
        _imaging = Publish<ImagingStatus>(MessageNames.Imaging);
        _link = Publish<LinkStatus>(MessageNames.LinkStatus(0));
        _outgoing = Receive<OutgoingFrame>(MessageNames.OutgoingFrames, wakeOnPush: false);
        Period = TimeSpan.FromMilliseconds(250);
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_outgoing.TryPop(out _))
        {
        }

        while (_next < _samples.Count - 1 && _samples[_next + 1].Time <= Now)
            _next++;
        ReadMessages sample = _samples[_next];
        _vehicle.Value = sample.Vehicle;
        _vehicle.Post();
        _autopilot.Value = sample.Autopilot;
        _autopilot.Post();
        _navigation.Value = sample.Navigation;
        _navigation.Post();
        _ownAddress.Value = sample.OwnAddress;
        _ownAddress.Post();
        _mission.Value = sample.Mission;
        _mission.Post();
        _imaging.Value = sample.Imaging;
        _imaging.Post();
        _link.Value = sample.Link;
        _link.Post();
    }
}
