using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Measures how long frames take over one link and back, by PING once a second (MAVLink guide, "Ping Protocol"): of all
/// that answer the first one counts. From when the frame leaves its queue here: that wait is known. One thread.
/// </summary>
internal sealed class RoundTripProbe
{
    private const int MaxOpen = 16;
    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    private readonly TimeSpan?[] _sentAt = new TimeSpan?[MaxOpen];
    private uint _number;
    private TimeSpan _due;

    /// <summary>The next request, where one is due.</summary>
    public bool TryNext(TimeSpan now, out Ping request)
    {
        request = default;
        if (now < _due)
            return false;
        _due = now + Interval;
        _sentAt[++_number % MaxOpen] = null;
        request = new Ping { Seq = _number, TimeUsec = (ulong)(now.Ticks / (TimeSpan.TicksPerMillisecond / 1000)) };
        return true;
    }

    /// <summary>A request goes out.</summary>
    public void NoteSent(in Ping request, TimeSpan now)
    {
        if (request.Seq + MaxOpen > _number)
            _sentAt[request.Seq % MaxOpen] = now;
    }

    /// <summary>Takes an answer.</summary>
    /// <returns>False where it is none to an open request.</returns>
    public bool TryTake(in Ping answer, TimeSpan now, out TimeSpan roundTrip)
    {
        roundTrip = default;
        bool isOpen = answer.Seq <= _number && answer.Seq + MaxOpen > _number;
        if (!isOpen || _sentAt[answer.Seq % MaxOpen] is not { } sent)
            return false;
        _sentAt[answer.Seq % MaxOpen] = null;
        roundTrip = now - sent;
        return true;
    }
}
