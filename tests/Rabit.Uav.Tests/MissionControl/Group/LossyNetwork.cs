using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>
/// Some vehicles, and a network between them that loses, delays and doubles what they send. What a vehicle knows and
/// does is for the derived classes.
/// </summary>
/// <typeparam name="TNode">What stands for a vehicle.</typeparam>
internal abstract class LossyNetwork<TNode>(int seed)
{
    private const double Step = 0.1;

    private readonly List<(double Due, int To, Action<TNode> Deliver)> _onTheWay = [];
    private readonly Random _random = new(seed);

    public int Seed => seed;

    public double Seconds { get; private set; }

    public double Loss { get; set; }

    public double MaxDelaySeconds { get; set; } = 0.1;

    public double Duplicates { get; set; }

    public Func<int, int, bool> Reaches { get; set; } = (_, _) => true;

    public HashSet<int> Lost { get; } = [];

    /// <summary>How many messages were sent.</summary>
    public int Sent { get; private set; }

    protected List<TNode> Nodes { get; } = [];

    public void Run(double seconds) => RunUntil(() => false, seconds);

    public bool RunUntil(Func<bool> condition, double maxSeconds)
    {
        for (double end = Seconds + maxSeconds; Seconds < end;)
        {
            if (condition())
                return true;
            Seconds += Step;
            Deliver();
            foreach (int i in Alive())
                Update(Nodes[i]);
        }

        return condition();
    }

    protected abstract void Update(TNode node);

    protected IEnumerable<int> Alive() => Enumerable.Range(0, Nodes.Count).Where(i => !Lost.Contains(i));

    /// <summary>The vehicles that one receives.</summary>
    protected IEnumerable<int> ReceivedBy(int vehicle) => Alive().Where(i => i != vehicle && Reaches(i, vehicle));

    /// <param name="from">Who sends.</param>
    /// <param name="to">Whom it is for; null for all.</param>
    /// <param name="deliver">What happens where it arrives.</param>
    protected void Send(int from, int? to, Action<TNode> deliver)
    {
        Sent++;
        for (int i = 0; i < Nodes.Count; i++)
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

    private void Deliver()
    {
        (double Due, int To, Action<TNode> Deliver)[] arrived = _onTheWay.Where(m => m.Due <= Seconds).ToArray();
        foreach ((double Due, int To, Action<TNode> Deliver) message in arrived)
        {
            _onTheWay.Remove(message);
            if (!Lost.Contains(message.To))
                message.Deliver(Nodes[message.To]);
        }
    }
}
