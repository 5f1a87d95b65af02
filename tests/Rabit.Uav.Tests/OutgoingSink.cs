using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests;

/// <summary>Takes the frames that are to be sent, in the place of Communications.</summary>
internal sealed class OutgoingSink : RabitManager
{
    private readonly QueueReceiver<OutgoingFrame> _frames;

    public OutgoingSink()
        : base("sink") => _frames = Receive<OutgoingFrame>(MessageNames.OutgoingFrames);

    /// <summary>What came, and when.</summary>
    public List<(TimeSpan Time, MavlinkFrame Frame)> Frames { get; } = [];

    public IReadOnlyList<T> MessagesOf<T>()
        where T : struct, IMavlinkMessage
        => Frames.Where(f => f.Frame.TryDecode(out T _)).Select(f => Decode<T>(f.Frame)).ToList();

    public static T Decode<T>(in MavlinkFrame frame)
        where T : struct, IMavlinkMessage
    {
        frame.TryDecode(out T message);
        return message;
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_frames.TryPop(out OutgoingFrame frame))
            Frames.Add((Now, frame.Frame));
    }
}
