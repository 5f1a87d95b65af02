using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>
/// Finders and bidders of some vehicles, and a network that loses, delays and doubles what they send. Vehicle 1 finds
/// the targets.
/// </summary>
internal sealed class ValidationNetwork : LossyNetwork<ValidationNetwork.Node>
{
    public ValidationNetwork(int vehicles, int seed)
        : base(seed)
    {
        for (int i = 0; i < vehicles; i++)
            Nodes.Add(new Node(this, i, session: 1));
    }

    /// <summary>How long a target is flown over.</summary>
    public double JobSeconds { get; set; } = 20;

    /// <summary>How long each vehicle says it takes to get there; null where it declines.</summary>
    public Func<int, double?> SecondsTo { get; set; } = i => 10 + i;

    /// <summary>What a vehicle's pictures show.</summary>
    public ValidationResult Shown { get; set; } = ValidationResult.Confirmed;

    /// <summary>Who has finished, in order.</summary>
    public List<int> Finished { get; } = [];

    public ValidationTask Task => Nodes[0].Finder.Find(1)!.Value;

    public ValidationFinder Finder => Nodes[0].Finder;

    public ValidationBidder BidderOf(int vehicle) => Nodes[vehicle].Bidder;

    /// <summary>The vehicles that are underway to the first target.</summary>
    public int[] Underway => Alive()
        .Where(i => Nodes[i].Bidder.Tasks.Any(t => t.Number == 1 && Nodes[i].Bidder.IsOurs(t)))
        .ToArray();

    public void Announce(int targets = 1)
    {
        for (int i = 1; i <= targets; i++)
        {
            Nodes[0].Finder.Announce(i, new ValidationTask
            {
                Class = DefaultTargetClasses.Red,
                Position = GeodeticPosition.FromDegrees(47.4 + (i * 0.001), 8.5, 0),
                RadiusMetres = 4,
            });
        }
    }

    /// <summary>A vehicle starts again, and has forgotten all.</summary>
    public void Restart(int vehicle) => Nodes[vehicle] = new Node(this, vehicle, session: 2);

    protected override void Update(Node node) => node.Update();

    private byte[] PresentFor(int vehicle) => ReceivedBy(vehicle).Select(i => (byte)(i + 1)).ToArray();

    internal sealed class Node : IValidationSender
    {
        private readonly ValidationNetwork _network;
        private readonly int _number;
        private double? _since;
        private ValidationTask? _job;

        public Node(ValidationNetwork network, int number, ushort session)
        {
            (_network, _number) = (network, number);
            Finder = new ValidationFinder(session, this, _ => { });
            Bidder = new ValidationBidder(this);
        }

        public ValidationFinder Finder { get; }

        public ValidationBidder Bidder { get; }

        private TimeSpan Now => TimeSpan.FromSeconds(_network.Seconds);

        public void Send(in ValidationTask task)
        {
            ValidationTask sent = task with { Finder = (byte)(_number + 1) };
            _network.Send(
                _number, null,
                node => node.Bidder.Receive(
                    sent, (byte)(node._number + 1), _ => _network.SecondsTo(node._number), node.Now));
        }

        public void Send(in ValidationBid bid, byte finder)
        {
            ValidationBid sent = bid;
            _network.Send(
                _number, finder - 1, node => node.Finder.Receive((byte)(_number + 1), sent, node.Now));
        }

        public void Update()
        {
            Finder.Update(_network.PresentFor(_number), Now);
            Bidder.Update(Now);
            if (_job is { } job && !Bidder.IsOurs(job))
                (_job, _since) = (null, null);
            if (_job is null && Bidder.Jobs.Any())
                (_job, _since) = (Bidder.Jobs.First(), _network.Seconds);
            if (_job is not { } done || _network.Seconds - _since < _network.JobSeconds)
                return;
            Bidder.Finish(done, _network.Shown, Now);
            _network.Finished.Add(_number);
            (_job, _since) = (null, null);
        }
    }
}
