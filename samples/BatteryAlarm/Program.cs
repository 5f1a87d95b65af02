using System;
using System.Globalization;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav;
using Rabit.Uav.Messages;

// A manager of your own beside the six: it warns the ground station when the battery falls below a level. It subscribes
// to the state of the vehicle, and pushes a STATUSTEXT into the queue of frames that Communications sends to all links.
// BatteryAlarm LINK PERCENT for example 'tlog:flight.tlog?speed=max' 96
if (args.Length != 2 || !LinkUrl.TryParse(args[0], out LinkUrl? link, out _)
    || !int.TryParse(args[1], NumberStyles.None, CultureInfo.InvariantCulture, out int percent))
{
    Console.Error.WriteLine("BatteryAlarm LINK PERCENT");
    return 2;
}

using UavSystem uav = UavSystem.Open(new UavOptions
{
    Links = [link],
    OtherManagers = [new BatteryAlarm(percent / 100.0, Console.WriteLine)],
});
return (await uav.CreateReactor(new ReactorOptions()).RunAsync()).ExitCode;

internal sealed class BatteryAlarm : RabitManager
{
    private readonly double _level;
    private readonly Action<string> _print;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private bool _hasWarned;

    public BatteryAlarm(double level, Action<string> print)
        : base("battery alarm")
    {
        _level = level;
        _print = print;
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
        if (!(remaining < _level))   // also where it is not known: NaN
            return;
        string text = FormattableString.Invariant($"battery at {100 * remaining:0} percent");
        _print($"{Now.TotalSeconds:0.0} s: {text}");
        var message = new Statustext { Severity = MavSeverity.Warning, Text = new Text50(text) };
        OwnAddress own = _ownAddress.Value;
        var frame = new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0),
        };
        _hasWarned = _outgoing.Push(frame) != PushResult.Rejected;   // where there is no room, it is sent again
    }
}
