using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Communications;
using Rabit.Links;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Stands in for Sensor Fusion.</summary>
internal sealed class ReportSink : RabitManager
{
    private readonly QueueReceiver<Envelope<TargetReport>> _reports;

    public ReportSink()
        : base("fusion") => _reports = Receive<Envelope<TargetReport>>(MessageNames.TargetReports);

    public List<TargetReport> Reports { get; } = [];

    public List<Envelope<TargetReport>> Envelopes { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_reports.TryPop(out Envelope<TargetReport> envelope))
        {
            Envelopes.Add(envelope);
            Reports.Add(envelope.Content);
        }
    }
}

/// <summary>Communications with vehicle messages, in virtual time.</summary>
internal sealed class VehicleMessageRig : IDisposable
{
    private readonly ReportSink _sink = new();
    private readonly QueueSender<Envelope<TargetReport>> _outgoing;
    private readonly MessageSubscriber<VehicleMessageStatus> _status;

    public VehicleMessageRig(int links, bool knowsAddress = true, LinkSettings? settings = null)
    {
        QueueSender<Envelope<TargetReport>>? outgoing = null;
        MessageSubscriber<VehicleMessageStatus>? status = null;
        Rig = new CommunicationsRig(
            links,
            o =>
            {
                (o.VehicleMessageRoutes, o.PositionRateHz) = ([VehicleMessageRig.Route()], 0);
                if (settings is not null)
                    o.LinkSettings = new Dictionary<int, LinkSettings> { [0] = settings };
            },
            beforeStart: reactor =>
            {
                reactor.Add(_sink);
                outgoing = reactor.Workspace.Send<Envelope<TargetReport>>(MessageNames.OutgoingTargetReports);
                status = reactor.Workspace.Subscribe<VehicleMessageStatus>(MessageNames.VehicleMessages);
            });
        (_outgoing, _status) = (outgoing!, status!);
        if (knowsAddress)
            Rig.As(1);
    }

    public static VehicleMessageRoute<TargetReport> Route()
        => new(new TargetReportCodec(), MessageNames.OutgoingTargetReports, MessageNames.TargetReports);

    public CommunicationsRig Rig { get; }

    public List<TargetReport> Reports => _sink.Reports;

    public VehicleMessageCounters Counts => Rig.Manager.CountVehicleMessages()[0];

    /// <summary>What the exchange counted, as reported within the next second.</summary>
    public VehicleExchangeCounters Exchange
    {
        get
        {
            Rig.Run(TimeSpan.FromMilliseconds(700));
            _status.Fetch();
            return _status.Value.Counters;
        }
    }

    public void Send(in TargetReport report)
    {
        _outgoing.Push(new Envelope<TargetReport> { Content = report });
        Rig.Run(TimeSpan.FromMilliseconds(300));
    }

    public void Dispose() => Rig.Dispose();
}

/// <summary>
/// Two vehicles with a link in memory between them, each in a reactor of its own; time goes on for both in turns.
/// </summary>
internal sealed class TwoVehicles : IDisposable
{
    private readonly RabitReactor[] _reactors = new RabitReactor[2];
    private readonly CommunicationsManager[] _managers = new CommunicationsManager[2];
    private readonly ReportSink[] _sinks = [new(), new()];
    private readonly QueueSender<Envelope<TargetReport>>[] _outgoing = new QueueSender<Envelope<TargetReport>>[2];
    private readonly MessageSubscriber<LinkStatus>[] _links = new MessageSubscriber<LinkStatus>[2];

    public TwoVehicles()
    {
        var pair = new MemoryLinkPair("air", 64 * 1024);
        for (int i = 0; i < 2; i++)
        {
            _managers[i] = new CommunicationsManager(
                new CommunicationsOptions
                {
                    Links = [i == 0 ? pair.A : pair.B],
                    VehicleMessageRoutes = [VehicleMessageRig.Route()]
                });
            _reactors[i] = new RabitReactor(new VirtualTime(i)) { _managers[i], _sinks[i], new FakeAutopilot(1024) };
            MessagePublisher<OwnAddress> address = _reactors[i].Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
            _reactors[i].Workspace.Publish<VehicleState>(MessageNames.VehicleState);
            _outgoing[i] = _reactors[i].Workspace.Send<Envelope<TargetReport>>(MessageNames.OutgoingTargetReports);
            _links[i] = _reactors[i].Workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(0));
            _reactors[i].Start();
            address.Value = new OwnAddress { SystemId = (byte)(i + 1), ComponentId = 191 };
            address.Post();
        }

        Run(0.5);
    }

    public TimeSpan Now => _reactors[0].Now;

    public List<TargetReport> Received(int vehicle) => _sinks[vehicle].Reports;

    public VehicleMessageCounters Counts(int vehicle) => _managers[vehicle].CountVehicleMessages()[0];

    public long Lost(int vehicle)
    {
        _links[vehicle].Fetch();
        return _links[vehicle].Value.FramesMissing;
    }

    public void Push(int vehicle, in TargetReport report, byte to = 0)
        => _outgoing[vehicle].Push(new Envelope<TargetReport>
        {
            Content = report,
            Destination = to == 0 ? VehicleDestination.All : VehicleDestination.Vehicle(to),
        });

    public void Send(int from, in TargetReport report, byte to = 0)
    {
        Push(from, report, to);
        Run(0.5);
    }

    public void Run(double seconds)
    {
        for (int i = 0; i < seconds * 1000; i++)
        {
            foreach (RabitReactor reactor in _reactors)
                reactor.RunFor(TimeSpan.FromMilliseconds(1));
        }
    }

    public void Dispose()
    {
        foreach (RabitReactor reactor in _reactors)
        {
            reactor.Stop();
            reactor.Finish();
        }
    }
}
