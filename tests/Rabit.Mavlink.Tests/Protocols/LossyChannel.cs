using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// One direction of a link in virtual time: loses frames, doubles a tenth of them where it loses any, and delays each
/// by 5 to 300 ms of its own, so that they overtake each other. Without loss a steady 20 ms.
/// </summary>
internal sealed class LossyChannel(double loss, ulong seed)
{
    private readonly ProtocolRandom _random = new(seed);
    private readonly List<(TimeSpan At, long Order, MavlinkFrame Frame)> _inFlight = [];
    private long _order;

    public long Sent { get; private set; }

    public TimeSpan NextAt
    {
        get
        {
            TimeSpan next = TimeSpan.MaxValue;
            foreach ((TimeSpan at, _, _) in _inFlight)
                next = at < next ? at : next;
            return next;
        }
    }

    public void Send(in MavlinkFrame frame, TimeSpan now)
    {
        Sent++;
        int copies = loss > 0 && _random.NextDouble() < 0.1 ? 2 : 1;
        for (int copy = 0; copy < copies; copy++)
        {
            if (_random.NextDouble() < loss)
                continue;
            double seconds = loss == 0 ? 0.02
                : _random.NextDouble() < 0.8 ? 0.005 + (0.045 * _random.NextDouble())
                : 0.3 * _random.NextDouble();
            _inFlight.Add((now + TimeSpan.FromSeconds(seconds), _order++, frame));
        }
    }

    public bool TryReceive(TimeSpan now, out MavlinkFrame frame)
    {
        int first = -1;
        for (int i = 0; i < _inFlight.Count; i++)
        {
            if (_inFlight[i].At <= now && (first < 0
                || (_inFlight[i].At, _inFlight[i].Order).CompareTo((_inFlight[first].At, _inFlight[first].Order)) < 0))
                first = i;
        }

        frame = first < 0 ? default : _inFlight[first].Frame;
        if (first >= 0)
            _inFlight.RemoveAt(first);
        return first >= 0;
    }
}
