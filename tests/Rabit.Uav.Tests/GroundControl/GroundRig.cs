using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.MissionControl;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>The manager of ground stations, with Mission Control in a flight; both in virtual time.</summary>
internal sealed class GroundRig : IDisposable
{
    public const byte Station = 255;
    public const byte Us = 191;

    private readonly RabitReactor _reactor;
    private readonly QueueSender<LinkFrame> _in;
    private readonly QueueReceiver<OutgoingFrame> _out;
    private readonly List<MavlinkFrame> _received = [];
    private readonly StringBuilder _text = new();
    private byte _sequence;

    public GroundRig(
        MissionRig flight, GroundCommandOptions? options = null, Func<long, int, byte[]?>? picture = null)
    {
        Flight = flight;
        var manager = new GroundCommandManager(flight.Manager, options ?? new GroundCommandOptions(), picture);
        _reactor = new RabitReactor(new ReactorOptions
        {
            Time = new VirtualTime(1),
            StopsOnSignals = false,
            Log = e => Log.Add(e.ToString()),
        })
        {
            manager,
        };
        MessagePublisher<OwnAddress> address = _reactor.Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
        _in = _reactor.Workspace.Send<LinkFrame>(GroundCommandManager.CreateSubscription().Queue);
        _out = _reactor.Workspace.Receive<OutgoingFrame>(MessageNames.OutgoingFrames);
        Tracks = picture is null ? null : _reactor.Workspace.Publish(MessageNames.Tracks, TrackList.None);
        if (picture is not null)
            _reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        Fence = options is { OffersAutopilotFence: true }
            ? _reactor.Workspace.Publish(MessageNames.AutopilotFence, AutopilotFence.Unknown)
            : null;
        _reactor.Start();
        address.Value = new OwnAddress { SystemId = 1, ComponentId = Us };
        address.Post();
        Run(0.5);
    }

    public MissionRig Flight { get; }

    /// <summary>Only with pictures.</summary>
    public MessagePublisher<TrackList>? Tracks { get; }

    /// <summary>Only where it is offered.</summary>
    public MessagePublisher<AutopilotFence>? Fence { get; }

    public List<string> Log { get; } = [];

    /// <summary>The texts for ground stations, their parts put together.</summary>
    public List<string> Texts { get; } = [];

    public void Send<T>(T message, byte from = Station, byte component = 190)
        where T : struct, IMavlinkMessage
        => Push(MavlinkFrame.Create(message, from, component, _sequence++));

    public void Push(MavlinkFrame frame) => _in.Push(new LinkFrame { Frame = frame, IsChecked = true });

    public void Run(double seconds)
    {
        for (double t = 0; t < seconds; t += 0.1)
        {
            _reactor.RunFor(TimeSpan.FromSeconds(0.1));
            Flight.Run(0.1);
            Collect();
        }
    }

    /// <summary>What was sent of a message since the last call.</summary>
    public List<T> Take<T>()
        where T : struct, IMavlinkMessage
    {
        var taken = new List<T>();
        _received.RemoveAll(f =>
        {
            bool isThis = f.TryDecode(out T message);
            if (isThis)
                taken.Add(message);
            return isThis;
        });
        return taken;
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
        Flight.Dispose();
    }

    private void Collect()
    {
        while (_out.TryPop(out OutgoingFrame frame))
        {
            if (!frame.Frame.TryDecode(out Statustext text))
            {
                _received.Add(frame.Frame);
                continue;
            }

            string part = text.Text.ToString();
            _text.Append(part);
            if (text.Id != 0 && part.Length == 50)
                continue;
            Texts.Add(_text.ToString());
            _text.Clear();
        }
    }
}
