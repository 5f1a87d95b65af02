using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>
/// Several Mission Controls with stand-in vehicles in lock step, and a radio between them that loses what the test
/// says. Homes are in a row to the east, 20 m apart unless it says otherwise; the system ids are 1, 2 and so on.
/// </summary>
internal sealed class GroupRig : IDisposable
{
    private const double Step = 0.1;

    private readonly List<RadioEnd> _ends = [];
    private readonly Random _random;
    private int _switchedOn;

    public GroupRig(
        int vehicles, MissionPlan? mission = null, int seed = 1, Action<int, MissionControlOptions>? change = null,
        MissionPlan? missionOfTheLast = null, double homesApartMetres = 20)
    {
        Seed = seed;
        _random = new Random(seed);
        _switchedOn = vehicles;
        var frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);
        for (int i = 0; i < vehicles; i++)
        {
            int number = i;
            var end = new RadioEnd((byte)(i + 1));
            _ends.Add(end);
            Rigs.Add(new MissionRig(
                (number == vehicles - 1 ? missionOfTheLast : null) ?? mission ?? MissionRig.Mission(),
                options =>
                {
                    options.Group = new GroupOptions { HeightLayer = number };
                    change?.Invoke(number, options);
                },
                seed + i,
                frame.ToGeodetic(new NedPosition(0, homesApartMetres * i, 0)),
                end.Join));
        }
    }

    public int Seed { get; }

    public List<MissionRig> Rigs { get; } = [];

    /// <summary>The fraction of the messages that is lost.</summary>
    public double Loss { get; set; }

    /// <summary>Whether one vehicle receives another, by their numbers from 0.</summary>
    public Func<int, int, bool> Reaches { get; set; } = (_, _) => true;

    /// <summary>How many vehicles are there; the others do not run before they are switched on.</summary>
    public int SwitchedOn
    {
        get => _switchedOn;
        set => _switchedOn = value;
    }

    /// <summary>Vehicles that do not run any more, by their numbers from 0.</summary>
    public HashSet<int> Lost { get; } = [];

    public double Seconds { get; private set; }

    public string Story => $"seed {Seed}" + Environment.NewLine + string.Join(
        Environment.NewLine,
        Rigs.SelectMany((r, i) => r.Decisions.Select(d => $"vehicle {i + 1}: {d}")));

    public LaneShare ShareOf(int number) => _ends[number].Status.OwnShare;

    public GroupStatus StatusOf(int number) => _ends[number].Status;

    /// <summary>A vehicle receives a coverage, as if of another one.</summary>
    public void Inject(int to, byte source, LaneCoverage coverage) => _ends[to].Inject(source, coverage);

    public void Run(double seconds) => RunUntil(() => false, seconds);

    /// <returns>Whether it came so.</returns>
    public bool RunUntil(Func<bool> condition, double maxSeconds)
    {
        for (double end = Seconds + maxSeconds; Seconds < end; Seconds += Step)
        {
            if (condition())
                return true;
            foreach (int i in Running())
                Rigs[i].Run(Step);
            foreach (int from in Running())
            {
                IEnumerable<int> reached = Running().Where(to => to != from && Reaches(from, to));
                _ends[from].Deliver(reached.Select(to => _ends[to]), IsLost);
            }
        }

        return condition();
    }

    public bool RunToEnd(double maxSeconds = 1500)
        => RunUntil(
            () => Running().All(i => Rigs[i].Status.Phase is MissionPhase.Done or MissionPhase.Failed), maxSeconds);

    public void Dispose()
    {
        foreach (MissionRig rig in Rigs)
            rig.Dispose();
    }

    private bool IsLost() => _random.NextDouble() < Loss;

    private IEnumerable<int> Running() => Enumerable.Range(0, _switchedOn).Where(i => !Lost.Contains(i));

    private sealed class RadioEnd(byte systemId)
    {
        private readonly List<IChannel> _channels = [];
        private RabitReactor _reactor = null!;
        private MessageSubscriber<GroupStatus> _status = null!;
        private MessagePublisher<OwnAddress> _address = null!;
        private bool _hasAddress;

        private interface IChannel
        {
            void Deliver(RadioEnd from, int number, RadioEnd[] to, Func<bool> isLost);
        }

        public byte SystemId => systemId;

        public GroupStatus Status
        {
            get
            {
                _status.Fetch();
                return _status.Value;
            }
        }

        public void Join(RabitReactor reactor)
        {
            _reactor = reactor;
            RabitWorkspace workspace = reactor.Workspace;
            _status = workspace.Subscribe<GroupStatus>(MessageNames.Group);
            _address = workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
            Add<GroupReport>(workspace, MessageNames.OutgoingGroupReports, MessageNames.GroupReports);
            Add<LaneDivision>(workspace, MessageNames.OutgoingLaneDivisions, MessageNames.LaneDivisions);
            Add<LaneCoverage>(workspace, MessageNames.OutgoingLaneCoverages, MessageNames.LaneCoverages);
            Add<ValidationTask>(workspace, MessageNames.OutgoingValidationTasks, MessageNames.ValidationTasks);
            Add<ValidationBid>(workspace, MessageNames.OutgoingValidationBids, MessageNames.ValidationBids);
            Add<FollowTask>(workspace, MessageNames.OutgoingFollowTasks, MessageNames.FollowTasks);
            Add<FollowBid>(workspace, MessageNames.OutgoingFollowBids, MessageNames.FollowBids);
        }

        public void Deliver(IEnumerable<RadioEnd> others, Func<bool> isLost)
        {
            if (!_hasAddress)
            {
                _address.Value = new OwnAddress { SystemId = systemId, ComponentId = 191 };
                _address.Post();
                _hasAddress = true;
            }

            RadioEnd[] to = others.ToArray();
            for (int i = 0; i < _channels.Count; i++)
                _channels[i].Deliver(this, i, to, isLost);
        }

        public void Inject<T>(byte source, T content) => _channels.OfType<Channel<T>>().Single().Take(
            new Envelope<T> { SourceSystemId = source, SentTime = _reactor.Now, Content = content }, source);

        private void Add<T>(RabitWorkspace workspace, string outgoing, string incoming)
            => _channels.Add(new Channel<T>(
                workspace.Receive<Envelope<T>>(outgoing), workspace.Send<Envelope<T>>(incoming)));

        private sealed class Channel<T>(QueueReceiver<Envelope<T>> outgoing, QueueSender<Envelope<T>> incoming)
            : IChannel
        {
            public void Deliver(RadioEnd from, int number, RadioEnd[] to, Func<bool> isLost)
            {
                while (outgoing.TryPop(out Envelope<T> message))
                {
                    message.SourceSystemId = from.SystemId;
                    foreach (RadioEnd end in to)
                    {
                        bool isFor = message.Destination == VehicleDestination.All
                            || message.Destination == VehicleDestination.Vehicle(end.SystemId);
                        if (!isFor || isLost())
                            continue;
                        message.SentTime = end._reactor.Now;
                        ((Channel<T>)end._channels[number]).Take(message, from.SystemId);
                    }
                }
            }

            public void Take(Envelope<T> message, byte source)
            {
                // The codec fills in who found it.
                if (message is Envelope<ValidationTask> { Content: var task } tasks)
                {
                    task.Finder = source;
                    tasks.Content = task;
                    message = (Envelope<T>)(object)tasks;
                }

                Xunit.Assert.NotEqual(PushResult.Rejected, incoming.Push(message));
            }
        }
    }
}
