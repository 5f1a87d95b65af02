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
internal sealed class FollowNetwork : LossyNetwork<FollowNetwork.Node>
{
    public FollowNetwork(int vehicles, int seed)
        : base(seed)
    {
        for (int i = 0; i < vehicles; i++)
            Nodes.Add(new Node(this, i));
    }

    /// <summary>Messages that are lost whatever else; by sender and task.</summary>
    public Func<int, FollowTask, bool> Drops { get; set; } = (_, _) => false;

    /// <summary>How long each vehicle says it takes to get there; null where it cannot.</summary>
    public Func<int, double?> SecondsTo { get; set; } = i => 5 + i;

    /// <summary>The vehicles that fly with a target, of each task together.</summary>
    public int[] Following => Alive().Where(i => Nodes[i].Current is not null).ToArray();

    /// <summary>Those of them that see it.</summary>
    public int[] Seeing => Alive().Where(i => Nodes[i].IsInView).ToArray();

    public FollowBook BookOf(int vehicle) => Nodes[vehicle].Book;

    public FollowTask TaskOf(int vehicle) => BookOf(vehicle).Entries.Single(e => !e.IsOver).Task;

    public void Announce(int vehicle = 0, double northDegrees = 0)
        => Nodes[vehicle].Book.Announce(
            new FollowTask
            {
                Class = DefaultTargetClasses.Red,
                Position = GeodeticPosition.FromDegrees(47.4 + northDegrees, 8.5, 0),
                Time = TimeSpan.FromSeconds(Seconds),
            },
            (byte)(vehicle + 1), TimeSpan.FromSeconds(Seconds));

    public FollowEntry FollowedBy(int vehicle) => Nodes[vehicle].Current!;

    protected override void Update(Node node) => node.Update();

    // Who follows does not bid.
    private byte[] PresentFor(int vehicle)
        => ReceivedBy(vehicle).Where(i => Nodes[i].Current is null).Select(i => (byte)(i + 1)).ToArray();

    internal sealed class Node : IFollowSender
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

            Book.Update(Own, isAble: true, _network.PresentFor(_number), SecondsTo, isSearchFirst: false, Now);
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
