using System;
using Rabit.Core;

namespace Rabit.Diagnostics.Tests;

/// <summary>Posts and pushes ten times a second.</summary>
internal sealed class SourceManager : RabitManager
{
    private readonly MessagePublisher<Pose> _pose;
    private readonly QueueSender<int> _numbers;
    private int _count;

    public SourceManager()
        : base("source")
    {
        _pose = Publish<Pose>("pose");
        _numbers = Send<int>("numbers");
        Period = TimeSpan.FromMilliseconds(100);
    }

    protected override void ExecuteUnitOfWork()
    {
        _count++;
        _pose.Value.NorthMetres = _count;
        _pose.Post();
        _numbers.Push(_count);
    }

    internal struct Pose
    {
        public double NorthMetres;

        public readonly double TwiceMetres => 2 * NorthMetres;
    }
}
