using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// Stands in for Autopilot Interface: takes the frames that Communications hands over, as many at a time as the test
/// allows.
/// </summary>
internal sealed class FakeAutopilot : RabitManager
{
    private readonly QueueReceiver<LinkFrame> _frames;
    private readonly Action<LinkFrame>? _onFrame;

    public FakeAutopilot(int capacity, Action<LinkFrame>? onFrame = null)
        : base("autopilot")
    {
        _onFrame = onFrame;
        _frames = Receive<LinkFrame>(MessageNames.AutopilotFrames, capacity, QueueFullMode.Reject);
        WakeUpDelay = TimeSpan.FromMilliseconds(10);
    }

    /// <summary>How many frames it takes in one unit of work.</summary>
    public int AtMost { get; set; } = int.MaxValue;

    /// <summary>Whether it keeps what it took.</summary>
    public bool Keeps { get; set; } = true;

    public List<LinkFrame> Taken { get; } = [];

    public void Stop(string reason) => StopSystem(reason);

    protected override void ExecuteUnitOfWork()
    {
        for (int taken = 0; taken < AtMost && _frames.TryPop(out LinkFrame frame); taken++)
        {
            if (Keeps)
                Taken.Add(frame);
            _onFrame?.Invoke(frame);
        }
    }
}
