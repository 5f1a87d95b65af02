using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Communications.Sending;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>
/// Vehicles, each with Communications and a radio of so many bytes a second to all others; each frame is late by the
/// same time, and lost for each receiver by the seed. In virtual time, in steps of 5 ms.
/// </summary>
internal sealed class Fleet : IDisposable
{
    private const int Rate = 3600;
    private const int StepMs = 5;

    private readonly Random _random;
    private readonly List<Vehicle> _vehicles = [];
    private readonly Queue<(TimeSpan Due, int To, byte[] Bytes)> _onTheWay = new();
    private readonly byte[] _buffer = new byte[64 * 1024];

    public Fleet(
        int vehicles, int seed, Func<int, IReadOnlyList<VehicleMessageRoute>> routes,
        Action<int, CommunicationsOptions>? configure = null)
    {
        _random = new Random(seed);
        for (int i = 0; i < vehicles; i++)
            _vehicles.Add(new Vehicle(i, seed, routes(i), configure));
        Run(1);
    }

    public double Loss { get; set; } = 0.1;

    public double DelayMs { get; set; } = 200;

    public Func<int, int, bool> Reaches { get; set; } = (_, _) => true;

    public TimeSpan Now => _vehicles[0].Reactor.Now;

    public Transmitter Radio(int vehicle) => _vehicles[vehicle].Radio;

    public IReadOnlyList<Envelope<Note>> Received(int vehicle) => _vehicles[vehicle].Sink.Notes;

    public IReadOnlyList<DeliveryReport> Reports(int vehicle) => _vehicles[vehicle].Sink.Reports;

    public VehicleMessageCounters Counts(int vehicle) => _vehicles[vehicle].Manager.CountVehicleMessages()[0];

    public VehicleMessageStatus Status(int vehicle)
    {
        _vehicles[vehicle].Status.Fetch();
        return _vehicles[vehicle].Status.Value;
    }

    public void Push(
        int from, VehicleDestination to, int number, int length = 50, string queue = "notes out",
        TimeSpan validUntil = default)
        => _vehicles[from].Outgoing(queue).Push(new Envelope<Note>
        {
            Content = new Note { Number = number, Length = length },
            Destination = to,
            Reference = number,
            ValidUntil = validUntil,
        });

    public void SendOwn<T>(int from, T message)
        where T : struct, IMavlinkMessage
        => _vehicles[from].Frames.Push(new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(message, (byte)(from + 1), 191, sequence: 0),
        });

    /// <summary>Says what GPS time the autopilot of a vehicle has now.</summary>
    public void SetGpsTime(int vehicle, long utcMicroseconds)
        => _vehicles[vehicle].PostTime(utcMicroseconds);

    public void Run(double seconds)
    {
        int steps = (int)Math.Round(seconds * 1000 / StepMs);
        for (int step = 0; step < steps; step++)
        {
            foreach (Vehicle vehicle in _vehicles)
            {
                vehicle.Reactor.RunFor(TimeSpan.FromMilliseconds(StepMs));
                Transmit(vehicle);
            }

            while (_onTheWay.Count > 0 && _onTheWay.Peek().Due <= Now)
            {
                (_, int to, byte[] bytes) = _onTheWay.Dequeue();
                _vehicles[to].Far.Write(bytes, 0, bytes.Length);
            }
        }
    }

    public void Finish()
    {
        foreach (Vehicle vehicle in _vehicles)
            vehicle.Finish();
    }

    public void Dispose() => Finish();

    // The queue is in the order of time but for the time that frames wait in the transmitters, which differs little.
    private void Transmit(Vehicle from)
    {
        int count = from.Far.Read(_buffer).Count;
        if (count == 0)
            return;
        int before = from.Radio.Sent.Count;
        from.Radio.Take(_buffer.Take(count).ToArray(), Now);
        for (int n = before; n < from.Radio.Sent.Count; n++)
        {
            (MavlinkFrame frame, TimeSpan sentAt) = from.Radio.Sent[n];
            byte[] bytes = Frames.Bytes(frame);
            foreach (Vehicle to in _vehicles)
            {
                if (to != from && Reaches(from.Index, to.Index) && _random.NextDouble() >= Loss)
                    _onTheWay.Enqueue(
                        (sentAt + TimeSpan.FromTicks((long)(DelayMs * TimeSpan.TicksPerMillisecond)), to.Index, bytes));
            }
        }
    }

    /// <summary>Takes what the routes deliver.</summary>
    private sealed class Sink : RabitManager
    {
        private readonly QueueReceiver<Envelope<Note>> _notes;
        private readonly QueueReceiver<DeliveryReport> _reports;

        public Sink()
            : base("sink")
        {
            _notes = Receive<Envelope<Note>>("notes in", 1000);
            _reports = Receive<DeliveryReport>("reports", 1000);
        }

        public List<Envelope<Note>> Notes { get; } = [];

        public List<DeliveryReport> Reports { get; } = [];

        protected override void ExecuteUnitOfWork() => Take();

        protected override void Shutdown() => Take();

        private void Take()
        {
            while (_notes.TryPop(out Envelope<Note> note))
                Notes.Add(note);
            while (_reports.TryPop(out DeliveryReport report))
                Reports.Add(report);
        }
    }

    private sealed class Vehicle
    {
        private readonly Dictionary<string, QueueSender<Envelope<Note>>> _outgoing = [];
        private readonly MessagePublisher<VehicleState> _state;
        private bool _isFinished;

        public Vehicle(
            int index, int seed, IReadOnlyList<VehicleMessageRoute> routes,
            Action<int, CommunicationsOptions>? configure)
        {
            Index = index;
            var pair = new MemoryLinkPair("radio" + index, 64 * 1024);
            Far = pair.B;
            var options = new CommunicationsOptions
            {
                Links = [pair.A],
                VehicleMessageRoutes = routes,
                PositionRateHz = 0,
                SendBudgets = new Dictionary<int, SendBudget> { [0] = new SendBudget { BytesPerSecond = Rate } },
                VehicleMessageBytesPerSecond = Rate,
            };
            configure?.Invoke(index, options);
            Manager = new CommunicationsManager(options);
            Reactor = new RabitReactor(
                new ReactorOptions { Time = new VirtualTime((seed * 100) + index), StopsOnSignals = false })
            {
                Manager, Sink, new FakeAutopilot(1024) { Keeps = false },
            };
            MessagePublisher<OwnAddress> address = Reactor.Workspace.Publish(
                MessageNames.OwnAddress, new OwnAddress { SystemId = (byte)(index + 1), ComponentId = 191 });
            _state = Reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
            Frames = Reactor.Workspace.Send<OutgoingFrame>(MessageNames.OutgoingFrames);
            foreach (VehicleMessageRoute route in routes)
                _outgoing[route.OutgoingQueue] =
                    Reactor.Workspace.Send<Envelope<Note>>(route.OutgoingQueue);
            Status = Reactor.Workspace.Subscribe<VehicleMessageStatus>(MessageNames.VehicleMessages);
            if (routes.All(r => r.ReportQueue is null))
                Reactor.Workspace.Send<DeliveryReport>("reports");
            Reactor.Start();
            address.Post();
        }

        public int Index { get; }

        public IByteLink Far { get; }

        public RabitReactor Reactor { get; }

        public CommunicationsManager Manager { get; }

        public Sink Sink { get; } = new();

        public Transmitter Radio { get; } = new(Rate);

        public QueueSender<OutgoingFrame> Frames { get; }

        public MessageSubscriber<VehicleMessageStatus> Status { get; }

        public QueueSender<Envelope<Note>> Outgoing(string queue) => _outgoing[queue];

        public void PostTime(long utcMicroseconds)
        {
            _state.Value = new VehicleState { UtcTime = Reactor.Now, GpsUtcMicroseconds = utcMicroseconds };
            _state.Post();
        }

        public void Finish()
        {
            if (_isFinished)
                return;
            _isFinished = true;
            Reactor.Stop("the test is over");
            Reactor.Finish();
        }
    }
}
