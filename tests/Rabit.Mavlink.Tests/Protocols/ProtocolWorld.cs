using System;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>A client, a vehicle and the two directions between them. Virtual time jumps from event to event.</summary>
internal sealed class ProtocolWorld(ScriptedVehicle vehicle, int lossPercent, ulong seed)
{
    private readonly LossyChannel _up = new(lossPercent / 100.0, (seed * 2) + 1);
    private readonly LossyChannel _down = new(lossPercent / 100.0, (seed * 2) + 2);

    public delegate void HandleFrame(in MavlinkFrame frame, TimeSpan now);

    public delegate bool TakeFrame(TimeSpan now, out MavlinkFrame frame);

    /// <summary>For the message of a failed test.</summary>
    public string Context => $"loss {lossPercent} %, seed {seed}";

    public TimeSpan Now { get; set; } = TimeSpan.FromSeconds(100);

    public long FramesUp => _up.Sent;

    /// <summary>
    /// Runs until a condition holds. A limit of virtual time and of steps is what "never hangs" means.
    /// </summary>
    /// <returns>Whether it held in time.</returns>
    public bool RunUntil(Func<bool> isOver, HandleFrame handle, TakeFrame take, Func<TimeSpan> nextDue, TimeSpan limit)
    {
        TimeSpan end = Now + limit;
        for (int step = 0; step < 2_000_000; step++)
        {
            Exchange(handle, take);
            if (isOver())
                return true;
            TimeSpan next = Earliest(Earliest(_up.NextAt, _down.NextAt), Earliest(nextDue(), vehicle.NextDue));
            if (next > end)
                return false;
            Now = next > Now ? next : Now + TimeSpan.FromMilliseconds(1);
        }

        return false;
    }

    private void Exchange(HandleFrame handle, TakeFrame take)
    {
        while (take(Now, out MavlinkFrame frame))
            _up.Send(frame, Now);
        while (_up.TryReceive(Now, out MavlinkFrame frame))
            vehicle.Handle(frame, Now);
        vehicle.Tick(Now);
        while (vehicle.TryTakeFrame(out MavlinkFrame frame))
            _down.Send(frame, Now);
        while (_down.TryReceive(Now, out MavlinkFrame frame))
            handle(frame, Now);
        while (take(Now, out MavlinkFrame frame))
            _up.Send(frame, Now);
    }

    private static TimeSpan Earliest(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
