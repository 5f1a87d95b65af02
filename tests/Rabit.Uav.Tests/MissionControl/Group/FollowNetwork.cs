using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>
/// What some vehicles know of who follows what, and a network that loses, delays and doubles what they send. Vehicle 1
/// finds the targets; a vehicle that is to follow flies there and then sees its target.
/// </summary>
internal sealed class FollowNetwork
{
    private const double Step = 0.1;

    private readonly List<Node> _nodes = [];
    private readonly List<(double Due, int To, Action<Node> Deliver)> _onTheWay = [];
    private readonly Random _random;

    public FollowNetwork(int vehicles, int seed)
    {
        (Seed, _random) = (seed, new Random(seed));
        for (int i = 0; i < vehicles; i++)
            _nodes.Add(new Node(this, i));
    }

    public int Seed { get; }

    public double Seconds { get; private set; }

    public double Loss { get; set; }

    public double MaxDelaySeconds { get; set; } = 0.1;

    public double Duplicates { get; set; }

    public Func<int, int, bool> Reaches { get; set; } = (_, _) => true;

    /// <summary>Messages that are lost whatever else; by sender and task.</summary>
    public Func<int, FollowTask, bool> Drops { get; set; } = (_, _) => false;

    /// <summary>How long each vehicle says it takes to get there; null where it cannot.</summary>
    public Func<int, double?> SecondsTo { get; set; } = i => 5 + i;

    public HashSet<int> Lost { get; } = [];

    /// <summary>The vehicles that fly with a target, of each task together.</summary>
    public int[] Following => Alive().Where(i => _nodes[i].Current is not null).ToArray();

    /// <summary>Those of them that see it.</summary>
    public int[] Seeing => Alive().Where(i => _nodes[i].IsInView).ToArray();

    public FollowBook BookOf(int vehicle) => _nodes[vehicle].Book;

    public FollowTask TaskOf(int vehicle) => BookOf(vehicle).Entries.Single(e => !e.IsOver).Task;

    public void Announce(int vehicle = 0, double northDegrees = 0)
        => _nodes[vehicle].Book.Announce(
            new FollowTask
            {
                Class = DefaultTargetClasses.Red,
                Position = GeodeticPosition.FromDegrees(47.4 + northDegrees, 8.5, 0),
                Time = TimeSpan.FromSeconds(Seconds),
            },
            (byte)(vehicle + 1), TimeSpan.FromSeconds(Seconds));

    public FollowEntry FollowedBy(int vehicle) => _nodes[vehicle].Current!;

    public void Run(double seconds) => RunUntil(() => false, seconds);

    public bool RunUntil(Func<bool> condition, double maxSeconds)
    {
        for (double end = Seconds + maxSeconds; Seconds < end;)
        {
            if (condition())
                return true;
            Seconds += Step;
            (double Due, int To, Action<Node> Deliver)[] arrived = _onTheWay.Where(m => m.Due <= Seconds).ToArray();
            foreach ((double Due, int To, Action<Node> Deliver) message in arrived)
            {
                _onTheWay.Remove(message);
                if (!Lost.Contains(message.To))
                    message.Deliver(_nodes[message.To]);
            }

            foreach (int i in Alive())
                _nodes[i].Update();
        }

        return condition();
    }

    private IEnumerable<int> Alive() => Enumerable.Range(0, _nodes.Count).Where(i => !Lost.Contains(i));

    // Who follows does not bid.
    private byte[] PresentFor(int vehicle) => Alive()
        .Where(i => i != vehicle && Reaches(i, vehicle) && _nodes[i].Current is null)
        .Select(i => (byte)(i + 1)).ToArray();

    private void Send(int from, int? to, Action<Node> deliver)
    {
        for (int i = 0; i < _nodes.Count; i++)
        {
            if (i == from || (to is not null && to != i) || !Reaches(from, i))
                continue;
            for (int copies = _random.NextDouble() < Duplicates ? 2 : 1; copies > 0; copies--)
            {
                if (_random.NextDouble() >= Loss)
                    _onTheWay.Add((Seconds + (_random.NextDouble() * MaxDelaySeconds), i, deliver));
            }
        }
    }

    private sealed class Node : IFollowSender
    {
        private readonly FollowNetwork _network;
        private readonly int _number;
        private double _begun;

        public Node(FollowNetwork network, int number)
        {
            (_network, _number) = (network, number);
            Book = new FollowBook(session: 1, this, _ => { });
        }

        public FollowBook Book { get; }

        public FollowEntry? Current { get; private set; }

        public bool IsInView { get; private set; }

        private byte Own => (byte)(_number + 1);

        private TimeSpan Now => TimeSpan.FromSeconds(_network.Seconds);

        public void Send(in FollowTask task)
        {
            FollowTask sent = task;
            TimeSpan time = Now;
            if (!_network.Drops(_number, sent))
                _network.Send(
                    _number, null, node => node.Book.Receive(Own, sent, time, node.Own, node.SecondsTo, node.Now));
        }

        public void Send(in FollowBid bid, byte decider)
        {
            FollowBid sent = bid;
            _network.Send(_number, decider - 1, node => node.Book.Receive(Own, sent, node.Own));
        }

        public void Update()
        {
            if (Current is { } current)
                Follow(current);
            Current ??= Book.Entries.FirstOrDefault(
                e => e.Task.State == FollowState.Awarded && e.Task.Follower == Own);
            if (Current is null)
                (_begun, IsInView) = (_network.Seconds, false);
            foreach (FollowEntry other in Book.Entries)
            {
                bool isOurs = other.Task.State == FollowState.Awarded && other.Task.Follower == Own;
                if (isOurs && other != Current)
                    other.GiveBack(Own, Now);
            }

            Book.Update(Own, isAble: true, _network.PresentFor(_number), SecondsTo, Now);
        }

        private void Follow(FollowEntry entry)
        {
            IsInView = _network.Seconds - _begun >= (_network.SecondsTo(_number) ?? 0);
            ref FollowTask task = ref entry.Task;
            if (task.Follower == Own)
                task.Progress = IsInView ? FollowProgress.InView : FollowProgress.OnTheWay;
            if (IsInView)
                task.Time = Now;
            bool isRelieved = task.State == FollowState.Awarded && task.Follower != Own
                && (task.Progress == FollowProgress.InView || !IsInView);
            if (isRelieved || entry.IsOver)
                (Current, IsInView) = (null, false);
        }

        private double? SecondsTo(FollowEntry entry) => Current is null ? _network.SecondsTo(_number)
            : Current == entry && IsInView && entry.Task.Follower == 0 ? 0
            : null;
    }
}
