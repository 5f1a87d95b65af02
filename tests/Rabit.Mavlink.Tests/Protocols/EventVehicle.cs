using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Sends an event now and then, as PX4 does: keeps the last 20, and says each 3 s which was the last.
/// </summary>
internal sealed class EventVehicle(ulong seed, int count, ushort first) : ScriptedVehicle
{
    private const int Kept = 20;

    private readonly ProtocolRandom _random = new(seed);
    private readonly List<Event> _kept = [];
    private TimeSpan _nextEvent = TimeSpan.FromSeconds(100);
    private TimeSpan _nextReport = TimeSpan.FromSeconds(103);
    private ushort _next = first;
    private int _left = count;

    public int Requests { get; private set; }

    public TimeSpan LastAt { get; private set; }

    public bool IsOver => _left == 0;

    public override TimeSpan NextDue => _left > 0 && _nextEvent < _nextReport ? _nextEvent : _nextReport;

    public override void Tick(TimeSpan now)
    {
        while (_left > 0 && now >= _nextEvent)
        {
            var happened = new Event
            {
                Id = 0x0100_0000u + _next,
                EventTimeBootMs = (uint)now.TotalMilliseconds,
                Sequence = _next++,
                LogLevels = 0x66,
            };
            _kept.Add(happened);
            if (_kept.Count > Kept)
                _kept.RemoveAt(0);
            Send(happened);
            _left--;
            LastAt = now;

            // Several in a moment, then none for some seconds.
            _nextEvent = now + TimeSpan.FromMilliseconds(_random.Below(4) == 0 ? 1000 + _random.Below(2000) : 20);
        }

        if (now >= _nextReport)
        {
            _nextReport += TimeSpan.FromSeconds(3);
            Send(new CurrentEventSequence { Sequence = (ushort)(_next - 1) });
        }
    }

    public override void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (!frame.TryDecode(out RequestEvent request))
            return;
        Requests++;
        for (int sequence = request.FirstSequence; sequence != (ushort)(request.LastSequence + 1);
            sequence = (ushort)(sequence + 1))
        {
            int at = _kept.FindIndex(e => e.Sequence == sequence);
            if (at >= 0)
                Send(_kept[at]);
            else
                Send(new ResponseEventError
                {
                    TargetSystem = frame.SystemId,
                    TargetComponent = frame.ComponentId,
                    Sequence = (ushort)sequence,
                    SequenceOldestAvailable = _kept.Count > 0 ? _kept[0].Sequence : _next,
                });
        }
    }
}
