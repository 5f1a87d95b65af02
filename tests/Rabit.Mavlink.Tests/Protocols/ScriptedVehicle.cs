using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>A vehicle at the other end: frames in, frames out, in virtual time.</summary>
internal abstract class ScriptedVehicle
{
    private readonly Queue<MavlinkFrame> _out = new();

    protected MavlinkSender Sender { get; } = new(1, 1);

    public static MavlinkAddress Address { get; } = new(1, 1);

    public static MavlinkSender Companion() => new(1, 191);

    /// <summary>When it does something by itself.</summary>
    public virtual TimeSpan NextDue => TimeSpan.MaxValue;

    public abstract void Handle(in MavlinkFrame frame, TimeSpan now);

    public virtual void Tick(TimeSpan now)
    {
    }

    public bool TryTakeFrame(out MavlinkFrame frame)
    {
        frame = _out.Count > 0 ? _out.Dequeue() : default;
        return frame.Version != MavlinkVersion.None;
    }

    protected void Send<T>(in T message)
        where T : struct, IMavlinkMessage => _out.Enqueue(Sender.Create(message));

    protected void Send(in MavlinkFrame frame) => _out.Enqueue(frame);
}
