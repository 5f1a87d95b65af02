using System;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Winches.Messages;   // generated from dialects/winch.xml

// A winch on board: a component of ours with messages of its own, checked and routed like all others.
const byte WinchComponent = 169;   // MAV_COMP_ID_WINCH
MavlinkDialect dialect = MavlinkDialect.Combine("winch", MavlinkDialect.All, WinchDialect.Instance);
var radio = new MemoryLinkPair("radio");
int[] ids = [WinchReel.MavlinkId];

using UavSystem uav = UavSystem.Open(new UavOptions
{
    SystemId = 1,
    OpenLinks = [radio.A],
    Dialect = dialect,
    Subscriptions = [new MavlinkSubscription("winch orders") { MessageIds = ids, ComponentId = WinchComponent }],
    OtherManagers = [new Winch(WinchComponent), new GroundStation(radio.B, dialect, Console.WriteLine)],
    Time = new VirtualTime(seed: 1),
});
return uav.CreateReactor(new ReactorOptions()).Run().ExitCode;

internal sealed class Winch : RabitManager
{
    private readonly MavlinkMessageReceiver<WinchReel> _orders;
    private readonly MavlinkMessageSender _sender;
    private float _ordered, _length;

    public Winch(byte componentId)
        : base("winch")
    {
        _orders = new(Receive<LinkFrame>("winch orders", 16, QueueFullMode.DropOldest, wakeOnPush: true));
        var outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        _sender = new(outgoing, Subscribe<OwnAddress>(MessageNames.OwnAddress), componentId);
        Period = TimeSpan.FromSeconds(1);
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_orders.TryPop(out WinchReel order, out _))
            _ordered = order.Length;
        if (_length >= _ordered) return;
        _length += 0.5f;   // a slow motor
        _sender.TrySend(new WinchLine { Length = _length });
    }
}

internal sealed class GroundStation : RabitManager
{
    private readonly BlockingReader<LinkFrame> _in;
    private readonly BlockingWriter<MavlinkFrame> _out;
    private readonly Action<string> _print;
    private bool _hasOrdered;

    public GroundStation(IByteLink link, MavlinkDialect dialect, Action<string> print)
        : base("ground station")
    {
        _in = AttachReader("in", new MavlinkLinkSource(link, dialect: dialect), 64, QueueFullMode.DropOldest);
        _out = AttachWriter("out", new MavlinkLinkTarget(link), 64, QueueFullMode.DropOldest);
        _print = print;
    }

    protected override void ExecuteUnitOfWork()
    {
        var order = new WinchReel { TargetSystem = 1, TargetComponent = 169, Length = 2 };
        if (!_hasOrdered)
            _ = _out.Push(MavlinkFrame.Create(order, systemId: 255, componentId: 190, sequence: 0));
        _hasOrdered = true;
        while (_in.TryPop(out LinkFrame frame))
        {
            if (!frame.Frame.TryDecode(out WinchLine line)) continue;
            _print(FormattableString.Invariant($"{line.Length:0.0} m of line are out"));
            if (line.Length >= 2) StopSystem("the line is out");
        }
    }
}
