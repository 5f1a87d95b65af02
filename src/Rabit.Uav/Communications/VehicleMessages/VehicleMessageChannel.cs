using System;
using System.Threading;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// One route of vehicle messages at work. Communications' thread uses it; any thread may ask for the counts.
/// </summary>
internal abstract class VehicleMessageChannel(VehicleMessageRoute route)
{
    private long _sent;
    private long _delivered;
    private long _rateLimited;
    private long _unsendable;
    private long _echoes;
    private long _duplicates;
    private long _malformed;
    private long _noRoom;

    private protected enum DeliveryResult
    {
        Delivered,
        Echo,
        Duplicate,
        Malformed,
        NoRoom,
    }

    public int PayloadType => route.PayloadType;

    public VehicleMessageCounters Counts => new(
        PayloadType,
        Interlocked.Read(ref _sent),
        Interlocked.Read(ref _rateLimited),
        Interlocked.Read(ref _unsendable),
        Interlocked.Read(ref _delivered),
        Interlocked.Read(ref _echoes),
        Interlocked.Read(ref _duplicates),
        Interlocked.Read(ref _malformed),
        Interlocked.Read(ref _noRoom));

    /// <summary>Takes the next message that is to be sent; false when there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="tunnel">What is to be sent; null where the message cannot be, which is counted.</param>
    public abstract bool TryTake(TimeSpan now, out Tunnel? tunnel);

    /// <summary>One copy went to a link.</summary>
    public void CountSent() => Interlocked.Increment(ref _sent);

    /// <summary>One copy did not, since the link has reached its rate limit.</summary>
    public void CountRateLimited() => Interlocked.Increment(ref _rateLimited);

    /// <summary>A message could not be sent at all.</summary>
    public void CountUnsendable() => Interlocked.Increment(ref _unsendable);

    /// <summary>Takes what another vehicle sent.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="tunnel">Its content.</param>
    /// <param name="ownSystemId">Our own system id: what comes from there is an echo.</param>
    /// <param name="time">When it came in.</param>
    public void Take(in MavlinkFrame frame, Tunnel tunnel, byte ownSystemId, TimeSpan time)
    {
        DeliveryResult result = frame.SystemId == ownSystemId ? DeliveryResult.Echo
            : tunnel.PayloadLength > VehicleMessageRoute.MaxLength ? DeliveryResult.Malformed
            : Deliver(frame.SystemId, tunnel, time);
        switch (result)
        {
            case DeliveryResult.Delivered:
                Interlocked.Increment(ref _delivered);
                break;
            case DeliveryResult.Echo:
                Interlocked.Increment(ref _echoes);
                break;
            case DeliveryResult.Duplicate:
                Interlocked.Increment(ref _duplicates);
                break;
            case DeliveryResult.Malformed:
                Interlocked.Increment(ref _malformed);
                break;
            default:
                Interlocked.Increment(ref _noRoom);
                break;
        }
    }

    private protected abstract DeliveryResult Deliver(byte sourceSystemId, Tunnel tunnel, TimeSpan time);
}
