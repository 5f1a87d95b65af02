using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Links;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// Communications in virtual time, with links in memory whose far ends the test holds, and a stand-in for Autopilot
/// Interface.
/// </summary>
internal sealed class CommunicationsRig : IDisposable
{
    private readonly List<MemoryLinkPair> _pairs = [];
    private readonly MessagePublisher<OwnAddress> _ownAddress;
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly List<MessageSubscriber<LinkStatus>> _statuses;
    private readonly byte[] _buffer = new byte[64 * 1024];
    private ReactorResult? _result;

    /// <param name="links">How many links in memory.</param>
    /// <param name="configure">More options; a link that it adds comes behind those in memory.</param>
    /// <param name="autopilot">The stand-in; one that takes everything if left out.</param>
    /// <param name="seed">Of the virtual time.</param>
    /// <param name="linkCapacity">Bytes that may be on the way on each link.</param>
    /// <param name="beforeStart">What else is to be in the reactor.</param>
    /// <param name="startUtc">What the wall clock shows at first; the usual of virtual time if left out.</param>
    public CommunicationsRig(
        int links,
        Action<CommunicationsOptions>? configure = null,
        FakeAutopilot? autopilot = null,
        long seed = 0,
        int linkCapacity = 64 * 1024,
        Action<RabitReactor>? beforeStart = null,
        DateTimeOffset? startUtc = null)
    {
        for (int number = 0; number < links; number++)
            _pairs.Add(new MemoryLinkPair("link" + number, linkCapacity));
        var options = new CommunicationsOptions { Links = _pairs.Select(p => p.A).ToList() };
        configure?.Invoke(options);

        Time = startUtc is { } start ? new VirtualTime(seed, start) : new VirtualTime(seed);
        Manager = new CommunicationsManager(options);
        Autopilot = autopilot ?? new FakeAutopilot(1024);
        Reactor = new RabitReactor(
            new ReactorOptions
            {
                Time = Time,
                Log = Log.Add,
                StopsOnSignals = false
            })
        {
            Manager, Autopilot
        };
        _ownAddress = Reactor.Workspace.Publish(MessageNames.OwnAddress, new OwnAddress { ComponentId = 191 });
        _vehicle = Reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        _outgoing = Reactor.Workspace.Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        _statuses = Enumerable.Range(0, options.Links.Count + options.RecordedFiles.Count)
            .Select(n => Reactor.Workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(n))).ToList();
        beforeStart?.Invoke(Reactor);
        Reactor.Start();
        Run();
    }

    public CommunicationsManager Manager { get; }

    public FakeAutopilot Autopilot { get; }

    public RabitReactor Reactor { get; }

    public VirtualTime Time { get; }

    public List<RabitLogEntry> Log { get; } = [];

    /// <summary>The end of a link that the test holds.</summary>
    public IByteLink Far(int link) => _pairs[link].B;

    /// <summary>Says who we are, as Autopilot Interface does.</summary>
    public CommunicationsRig As(byte systemId, byte componentId = 191)
    {
        _ownAddress.Value = new OwnAddress { SystemId = systemId, ComponentId = componentId };
        _ownAddress.Post();
        Run();
        return this;
    }

    /// <summary>Says how the vehicle is, as Autopilot Interface does.</summary>
    public void Post(in VehicleState vehicle)
    {
        _vehicle.Value = vehicle;
        _vehicle.Post();
    }

    /// <summary>Lets bytes come in over a link, and all that follows from it happen.</summary>
    public void Send(int link, params byte[][] frames)
    {
        Put(link, frames);
        Run();
    }

    /// <summary>Lets bytes come in over a link, all in one piece.</summary>
    public void Put(int link, params byte[][] frames)
    {
        byte[] bytes = Frames.Join(frames);
        Far(link).Write(bytes, 0, bytes.Length);
    }

    /// <summary>Gives Communications a frame of our own.</summary>
    public void SendOwn<T>(T message, byte system = 1, byte component = 191)
        where T : struct, IMavlinkMessage
        => SendOwn(MavlinkFrame.Create(message, system, component, sequence: 99));

    public void SendOwn(in MavlinkFrame frame, TimeSpan validUntil = default)
    {
        _outgoing.Push(new OutgoingFrame { Frame = frame, ValidUntil = validUntil });
        Run(TimeSpan.FromMilliseconds(200));
    }

    /// <summary>Gives Communications a frame of our own; time stands still.</summary>
    public void SendNow<T>(T message, byte system = 1, byte component = 191)
        where T : struct, IMavlinkMessage
        => SendNow(MavlinkFrame.Create(message, system, component, sequence: 99));

    public void SendNow(in MavlinkFrame frame) => _outgoing.Push(new OutgoingFrame { Frame = frame });

    /// <summary>Goes on; without a time only as far as what is due now leads.</summary>
    public void Run(TimeSpan time = default) => Reactor.RunFor(time);

    /// <summary>Takes what came out at the far end of a link.</summary>
    public byte[] Received(int link)
    {
        LinkRead read = Far(link).Read(_buffer);
        return _buffer.Take(read.Count).ToArray();
    }

    public List<MavlinkFrame> ReceivedFrames(int link) => Frames.Read(Received(link));

    /// <summary>How a link is, as reported within the next second.</summary>
    public LinkStatus Status(int link)
    {
        Run(TimeSpan.FromMilliseconds(700));
        return LastStatus(link);
    }

    public LinkStatus LastStatus(int link)
    {
        _statuses[link].Fetch();
        return _statuses[link].Value;
    }

    public ReactorResult Finish()
    {
        Reactor.Stop("the test is over");
        return _result = Reactor.Finish();
    }

    /// <summary>As <see cref="Finish"/>, where Communications is to stop the system.</summary>
    public ReactorResult FinishByItself() => _result = Reactor.Finish();

    public void Dispose()
    {
        if (_result is null)
            Finish();
    }
}
