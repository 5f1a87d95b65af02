using System;
using Rabit.Core;

namespace Rabit.Diagnostics.Tests;

/// <summary>Leaves what it gets in its queue, which holds three.</summary>
internal sealed class SinkManager : RabitManager
{
    public SinkManager()
        : base("sink")
    {
        Receive<int>("numbers", capacity: 3, QueueFullMode.DropOldest);
        Subscribe<SourceManager.Pose>("pose", wakeOnPost: true);
        WakeUpDelay = TimeSpan.FromHours(1);
    }

    protected override void ExecuteUnitOfWork()
    {
    }
}
