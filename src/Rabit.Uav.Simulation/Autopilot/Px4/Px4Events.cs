using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// PX4's events: each goes out over all links with a number of its own; the last 20 can be asked for again. Where a
/// ground station is connected over a link, the same is said there as a status text, with a tab at its end.
/// </summary>
internal sealed class Px4Events(ILinkSink sink, Px4Links links)
{
    private const int MaxKept = 20;   // recorded: with 88 as the last one, 69 was the oldest available
    private static readonly TimeSpan SequenceEvery = TimeSpan.FromSeconds(3);

    private readonly Queue<Event> _kept = new();
    private ushort _next;
    private ushort _reported;
    private TimeSpan _nextReport;

    /// <summary>Of the autopilot's clock.</summary>
    public uint BootMilliseconds { get; set; }

    /// <param name="id">Which.</param>
    /// <param name="levels">Internal and external log level, a half byte each; 6 is information, 2 critical.</param>
    /// <param name="arguments">As the metadata of the event have them.</param>
    /// <param name="text">The status text that goes with it; null where there is none.</param>
    public void Send(Px4Event id, byte levels, in Px4EventArguments arguments = default, string? text = null)
    {
        var message = new Event
        {
            Id = (uint)id,
            EventTimeBootMs = BootMilliseconds,
            Sequence = _next++,
            LogLevels = levels,
            Arguments = arguments.Bytes,
        };
        _kept.Enqueue(message);
        if (_kept.Count > MaxKept)
            _kept.Dequeue();
        SendToAll(message);
        if (text is not null)
            Say((MavSeverity)(levels & 0xF), text);
    }

    /// <summary>A status text alone, over the links that a ground station is connected over.</summary>
    public void Say(MavSeverity severity, string text)
    {
        for (int link = 0; link < links.Count; link++)
        {
            if (links.HasGroundStation(link))
                sink.Send(link, new Statustext { Severity = severity, Text = new Text50(text + "\t") });
        }
    }

    /// <summary>REQUEST_EVENT: each one that is kept, and an error for each that is not.</summary>
    public void Handle(in RequestEvent request, Sender sender, int link)
    {
        int count = (ushort)(request.LastSequence - request.FirstSequence) + 1;
        for (int offset = 0; offset < count && offset < MaxKept; offset++)
        {
            var sequence = (ushort)(request.FirstSequence + offset);
            if (!TrySendAgain(sequence, link))
                Refuse(sequence, sender, link);
        }
    }

    /// <summary>Reports the last number, where there is a new one.</summary>
    public void Step(TimeSpan time)
    {
        if (time < _nextReport)
            return;
        _nextReport = time + SequenceEvery;
        if (_reported == _next)
            return;
        _reported = _next;
        SendToAll(new CurrentEventSequence { Sequence = (ushort)(_next - 1) });
    }

    private void SendToAll<T>(in T message)
        where T : struct, IMavlinkMessage
    {
        for (int link = 0; link < links.Count; link++)
            sink.Send(link, message);
    }

    private bool TrySendAgain(ushort sequence, int link)
    {
        foreach (Event kept in _kept)
        {
            if (kept.Sequence != sequence)
                continue;
            sink.Send(link, kept);
            return true;
        }

        return false;
    }

    private void Refuse(ushort sequence, Sender sender, int link) => sink.Send(link, new ResponseEventError
    {
        TargetSystem = sender.SystemId,
        TargetComponent = sender.ComponentId,
        Sequence = sequence,
        SequenceOldestAvailable = _kept.Count > 0 ? _kept.Peek().Sequence : _next,
        Reason = MavEventErrorReason.Unavailable,
    });
}
