using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.AutopilotInterface;

// Parameters, fence, and how well the autopilot knows where it is: for the pre-flight checklist.
public sealed partial class AutopilotManager
{
    private readonly PreflightFacts _setupFacts = new(new PreflightOptions());
    private readonly NavigationTracker _navigationTracker = new();
    private MessagePublisher<AutopilotParameters> _parametersMessage = null!; // made by the constructor
    private MessagePublisher<NavigationStatus> _navigation = null!; // made by the constructor
    private AutopilotSetup? _setup;

    private bool IsSetupBusy => _setup is { IsBusy: true };

    private void PublishSetup()
    {
        _parametersMessage = Publish(MessageNames.AutopilotParameters, AutopilotParameters.None);
        _navigation = Publish<NavigationStatus>(MessageNames.Navigation);
    }

    // Messages that are read of one make alone, or that the other refuses, ArduPilot with a text to the ground station.
    private static readonly int[] OfArdupilot =
        [EkfStatusReport.MavlinkId, Wind.MavlinkId, GpsGlobalOrigin.MavlinkId];
    private static readonly int[] OfPx4 =
    [
        EstimatorStatus.MavlinkId, WindCov.MavlinkId, PositionTargetGlobalInt.MavlinkId, LocalPositionNed.MavlinkId,
    ];

    // The checklist needs home beside the rest.
    private IEnumerable<RequestedRate> RatesFor(in VehicleState vehicle)
    {
        // Plane reports its place by it, to the digit; Copter a wrong one.
        bool isPlane = FixedWings.IsFixedWing(vehicle.VehicleType);
        int[] denied = vehicle.Autopilot switch
        {
            MavAutopilot.Ardupilotmega when isPlane
                => OfPx4.Where(m => m != PositionTargetGlobalInt.MavlinkId).ToArray(),
            MavAutopilot.Ardupilotmega => OfPx4,
            MavAutopilot.Px4 => OfArdupilot,
            _ => [],
        };
        IEnumerable<RequestedRate> rates = _options.RequestedRates.Where(r => Array.IndexOf(denied, r.MessageId) < 0);
        bool needsHome = _options.Setup.ReadsParameters && rates.All(r => r.MessageId != HomePosition.MavlinkId);
        return needsHome ? rates.Append(new RequestedRate(HomePosition.MavlinkId, 0.5)) : rates;
    }

    private void MakeSetup(in VehicleState vehicle, MavlinkSender sender, MavlinkAddress target)
    {
        if (!_options.Setup.ReadsParameters)
            return;
        OriginalsFile? store = _options.Setup.OriginalsFile is { } path ? new OriginalsFile(path) : null;
        _setup = new AutopilotSetup(vehicle, sender, target, _options.Setup, store, Log);
    }

    private void TakeSetupFrame(in LinkFrame frame)
    {
        if (_setup is null || _tracker.State.IsArmed || !_tracker.IsFromAutopilot(frame.Frame))
            return;
        _setup.Handle(frame.Frame, Now);
    }

    private void TakeNavigation(in LinkFrame frame)
    {
        if (!_tracker.IsFromAutopilot(frame.Frame) || !_navigationTracker.Update(frame))
            return;
        _navigation.Value = _navigationTracker.Status;
        _navigation.Post();
    }

    // Before the state of the vehicle is posted: a stop that follows from it must find what is to be written back.
    private void RunSetup()
    {
        if (_setup is null)
            return;
        _setupFacts.Now = Now;
        _setupFacts.Vehicle = _tracker.State;
        _setupFacts.Own = _ownAddress.Value;
        _setup.Run(_setupFacts, IsStopRequested);
        DelaysStop = _setup.MustRestore;
        bool maySend = _tracker.State.IsConnected && !_tracker.State.IsArmed;
        while (maySend && _setup.TryTakeFrame(Now, out MavlinkFrame frame))
            _ = _outgoing.Push(new OutgoingFrame { Frame = frame });
        if (!_setup.TryTakeReport(out AutopilotParameters report))
            return;
        _parametersMessage.Value = report;
        _parametersMessage.Post();
    }
}
