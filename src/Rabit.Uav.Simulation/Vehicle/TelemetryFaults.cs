using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>Makes wrong what the vehicle sends, where the script says so: times, and how long frames take.</summary>
internal sealed class TelemetryFaults(IEnumerable<ScriptedFault> faults)
{
    private const double MillisecondsPerSecond = 1e3;
    private const double NanosecondsPerSecond = 1e9;

    private readonly ScriptedFault[] _delays = faults.Where(f => f.Kind == ScriptedFaultKind.LinkDelayed).ToArray();
    private readonly Queue<ScriptedFault> _stale =
        new(faults.Where(f => f.Kind == ScriptedFaultKind.TelemetryStale).OrderBy(f => f.At));

    private readonly Queue<ScriptedFault> _wrong =
        new(faults.Where(f => f.Kind == ScriptedFaultKind.TimesyncWrong).OrderBy(f => f.At));

    private MavlinkFrame? _position;
    private MavlinkFrame? _attitude;
    private bool _hasSentPosition;

    /// <summary>How much longer a frame takes that is sent at a time.</summary>
    public TimeSpan DelayAt(TimeSpan time)
    {
        double seconds = 0;
        foreach (ScriptedFault fault in _delays)
        {
            if (fault.IsOn(time))
                seconds = fault.Value;
        }

        return TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond));
    }

    /// <summary>A frame as it is sent: an answer to TIMESYNC may be wrong.</summary>
    public MavlinkFrame Pass(in MavlinkFrame frame, TimeSpan time)
    {
        if (frame.MessageId == GlobalPositionInt.MavlinkId)
            _position = frame;
        else if (frame.MessageId == Attitude.MavlinkId)
            _attitude = frame;
        if (_wrong.Count == 0 || _wrong.Peek().At > time || !frame.TryDecode(out Timesync answer) || answer.Tc1 == 0)
            return frame;
        answer.Tc1 += (long)(_wrong.Dequeue().Value * NanosecondsPerSecond);
        return Again(frame, answer);
    }

    /// <summary>The frames that are sent once more with another time. Call it until there is none.</summary>
    public bool TryTakeStale(TimeSpan time, out MavlinkFrame frame)
    {
        frame = default;
        if (_stale.Count == 0 || _stale.Peek().At > time || _position is not { } position
            || _attitude is not { } attitude)
            return false;
        if (!_hasSentPosition)
        {
            position.TryDecode(out GlobalPositionInt where);
            where.TimeBootMs = Shifted(where.TimeBootMs);
            frame = Again(position, where);
            return _hasSentPosition = true;
        }

        attitude.TryDecode(out Attitude how);
        how.TimeBootMs = Shifted(how.TimeBootMs);
        frame = Again(attitude, how);
        _stale.Dequeue();
        _hasSentPosition = false;
        return true;
    }

    private uint Shifted(uint bootMs)
        => (uint)Math.Max(1, bootMs + (long)(_stale.Peek().Value * MillisecondsPerSecond));

    private static MavlinkFrame Again<T>(in MavlinkFrame frame, in T message)
        where T : struct, IMavlinkMessage
        => MavlinkFrame.Create(message, frame.SystemId, frame.ComponentId, frame.Sequence);
}
