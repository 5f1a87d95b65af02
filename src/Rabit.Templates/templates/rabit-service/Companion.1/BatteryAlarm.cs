using System;
using Microsoft.Extensions.Options;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav;
using Rabit.Uav.Messages;

namespace Companion._1;

/// <summary>
/// A manager beside the six of Rabit.Uav: it warns the ground station when the battery falls below a level. It
/// subscribes to the state of the vehicle, and pushes a STATUSTEXT into the queue of frames that Communications sends
/// to all links.
/// </summary>
public sealed class BatteryAlarm : RabitManager
{
    private readonly double _levelFraction;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private bool _hasWarned;

    // The constructor only says what the manager publishes, subscribes to, sends and receives.
    public BatteryAlarm(IOptions<BatteryAlarmOptions> options)
        : base("battery alarm")
    {
        _levelFraction = options.Value.LevelFraction;
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState, wakeOnPost: true);
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
    }

    protected override void ExecuteUnitOfWork()
    {
        _ownAddress.Fetch();
        if (!_vehicle.Fetch() || _hasWarned || !_ownAddress.Value.IsKnown)
            return;
        double remaining = _vehicle.Value.BatteryRemaining;
        if (!(remaining < _levelFraction))   // also where it is not known: NaN
            return;

        string text = FormattableString.Invariant($"battery at {100 * remaining:0} percent");
        Log(text);   // ILogger, category "Rabit.battery alarm"
        var message = new Statustext { Severity = MavSeverity.Warning, Text = new Text50(text) };
        OwnAddress own = _ownAddress.Value;
        var frame = new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0),
        };
        _hasWarned = _outgoing.Push(frame) != PushResult.Rejected;   // where there is no room, it is sent again
    }
}
