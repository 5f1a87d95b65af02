using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// The runs of the autopilot in a log: each start of it sets its clock back to zero, so that a time since the start
/// alone may be one of several. Fed with the frames of a log in turn.
/// </summary>
internal sealed class LoggedBoots
{
    // Late frames are not that late, and what is written of a run so short is of no use.
    private static readonly TimeSpan Restart = TimeSpan.FromSeconds(5);

    private readonly List<Boot> _boots = [];
    private TimeSpan _latest;

    /// <summary>How many there were up to the last frame; 0 before the first time.</summary>
    public int Count => _boots.Count;

    /// <summary>Takes a frame; those of other components, and those without a time, are left alone.</summary>
    public void Take(in LoggedFrame logged)
    {
        if (!logged.IsOfAutopilot || !TryTime(logged.Frame, out TimeSpan time, out bool isPose))
            return;
        if (_boots.Count == 0 || time < _latest - Restart)
        {
            _boots.Add(new Boot(logged.Stamp));
            _latest = time;
        }

        _latest = time > _latest ? time : _latest;
        if (isPose)
            _boots[_boots.Count - 1].Take(time, logged.Stamp);
    }

    /// <summary>The run, from 1 on, in which a time since the start was; the last one if it was in none.</summary>
    /// <exception cref="FormatException">It was in more than one of them.</exception>
    public int At(TimeSpan time, string file)
    {
        int at = 0;
        for (int i = 0; i < _boots.Count; i++)
        {
            if (time < _boots[i].First || time > _boots[i].Last)
                continue;
            if (at > 0)
            {
                throw new FormatException(
                    FormattableString.Invariant($"In {file} the autopilot started {_boots.Count} times, and {time.TotalSeconds:0.###} s after that it ran more than once. Give the time in seconds since 1970."));
            }

            at = i + 1;
        }

        return at > 0 ? at : _boots.Count;
    }

    /// <summary>The run, from 1 on, that a stamp of the log was in, and its time since the start.</summary>
    /// <remarks>
    /// By the message that was quickest: late by the shortest delay of the link, which is not in a log.
    /// </remarks>
    /// <exception cref="FormatException">There was no run with a pose.</exception>
    public (int Boot, TimeSpan Time) AtStamp(TimeSpan stamp, string file)
    {
        int at = _boots.FindLastIndex(b => b.HasPoses && b.Begin <= stamp);
        if (at < 0)
            at = _boots.FindIndex(b => b.HasPoses);
        if (at < 0)
            throw new FormatException($"{file} has no positions or attitudes of an autopilot.");
        return (at + 1, stamp - _boots[at].StampsLessBoot);
    }

    private static bool TryTime(in MavlinkFrame frame, out TimeSpan time, out bool isPose)
    {
        isPose = true;
        uint? milliseconds = null;
        if (frame.MessageId == GlobalPositionInt.MavlinkId && frame.TryDecode(out GlobalPositionInt position))
            (milliseconds, isPose) = (position.TimeBootMs, position.Lat != 0 || position.Lon != 0);
        else if (frame.MessageId == Attitude.MavlinkId && frame.TryDecode(out Attitude attitude))
            milliseconds = attitude.TimeBootMs;
        else if (frame.MessageId == SystemTime.MavlinkId && frame.TryDecode(out SystemTime system))
            (milliseconds, isPose) = (system.TimeBootMs, false);
        else if (TryTimeOfGimbal(frame, out uint ofGimbal) && ofGimbal != 0)
            (milliseconds, isPose) = (ofGimbal, false);
        time = TimeSpan.FromMilliseconds(milliseconds ?? 0);
        return milliseconds is not null;
    }

    // 0 where the autopilot does not say.
    private static bool TryTimeOfGimbal(in MavlinkFrame frame, out uint milliseconds)
    {
        milliseconds = 0;
        if (frame.MessageId == GimbalDeviceAttitudeStatus.MavlinkId
            && frame.TryDecode(out GimbalDeviceAttitudeStatus status))
            milliseconds = status.TimeBootMs;
        else if (frame.MessageId == MountOrientation.MavlinkId && frame.TryDecode(out MountOrientation mount))
            milliseconds = mount.TimeBootMs;
        else
            return false;
        return true;
    }

    private sealed class Boot(TimeSpan begin)
    {
        public TimeSpan Begin { get; } = begin;

        public bool HasPoses => Last >= First;

        public TimeSpan First { get; private set; } = TimeSpan.MaxValue;

        public TimeSpan Last { get; private set; } = TimeSpan.MinValue;

        public TimeSpan StampsLessBoot { get; private set; } = TimeSpan.MaxValue;

        public void Take(TimeSpan time, TimeSpan stamp)
        {
            First = time < First ? time : First;
            Last = time > Last ? time : Last;
            StampsLessBoot = stamp - time < StampsLessBoot ? stamp - time : StampsLessBoot;
        }
    }
}
