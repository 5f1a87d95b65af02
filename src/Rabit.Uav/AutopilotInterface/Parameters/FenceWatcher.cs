using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Reads the fence that the autopilot has, again when that may have changed: where its MISSION_CURRENT names the fence,
/// when the name changes (PX4 from 1.15 on); with others every 10 s, and when ArduPilot reports FENCE_TOTAL. A state
/// machine: frames and time come in, frames go out. One thread.
/// </summary>
internal sealed class FenceWatcher
{
    public const string CountParameter = "FENCE_TOTAL";

    /// <summary>How often it is read where nothing reports a change, and after a failure.</summary>
    public static readonly TimeSpan Period = TimeSpan.FromSeconds(10);

    private readonly MavlinkMissionClient _client;
    private readonly Action<string> _log;
    private readonly List<FenceItem> _known = [];
    private TimeSpan _due;
    private uint? _id;
    private bool _isKnown;
    private bool _isFaultLogged;
    private AutopilotFence? _report;
    private int _changes;

    /// <param name="sender">Gives the frames their source.</param>
    /// <param name="target">The autopilot.</param>
    /// <param name="log">Takes what people should know.</param>
    public FenceWatcher(MavlinkSender sender, MavlinkAddress target, Action<string> log)
        => (_client, _log) = (new MavlinkMissionClient(sender, target), log);

    /// <summary>Whether something is under way, so that answers are due soon.</summary>
    public bool IsBusy => _client.IsBusy;

    /// <summary>It was written from this side: what is read next is no change by others.</summary>
    public void Forget(TimeSpan now)
    {
        _isKnown = false;
        _due = now;
        _client.Cancel(now);
        _client.TryTakeOutcome(out _);
    }

    /// <summary>Takes a frame of the autopilot.</summary>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        _client.Handle(frame, now);
        if (frame.MessageId == MissionCurrent.MavlinkId && frame.TryDecode(out MissionCurrent current))
            TakeId(current.FenceId, now);
        else if (frame.MessageId == ParamValue.MavlinkId && frame.TryDecode(out ParamValue value)
            && value.ParamId.TextEquals(CountParameter))
            _due = now;
    }

    /// <summary>Goes on.</summary>
    /// <param name="now">The time.</param>
    /// <param name="mayStart">Whether a transfer may begin: no other one of fences is under way.</param>
    public void Run(TimeSpan now, bool mayStart)
    {
        if (_client.TryTakeOutcome(out MavlinkMissionOutcome outcome))
            Take(outcome, now);
        if (mayStart && now >= _due && _client.TryStartDownload(MavMissionType.Fence, now))
            _due = _id is null ? now + Period : TimeSpan.MaxValue;
    }

    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame) => _client.TryTakeFrame(now, out frame);

    /// <summary>Takes what is new; once.</summary>
    public bool TryTakeReport(out AutopilotFence report)
    {
        report = _report ?? AutopilotFence.Unknown;
        bool isNew = _report is not null;
        _report = null;
        return isNew;
    }

    // 0 is no fence, or an autopilot that names none.
    private void TakeId(uint id, TimeSpan now)
    {
        if ((_id is null && id == 0) || id == _id)
            return;
        _id = id;
        _due = now;
    }

    private void Take(in MavlinkMissionOutcome outcome, TimeSpan now)
    {
        if (outcome.Status != MavlinkMissionStatus.Done)
        {
            _due = now + Period;
            if (!_isFaultLogged)
                _log($"the autopilot's fence cannot be read: {FenceWriteStep.Text(outcome)}");
            _isFaultLogged = true;
            return;
        }

        _isFaultLogged = false;
        ReadOnlySpan<MissionItemInt> items = _client.Items;
        if (_isKnown && IsKnown(items))
            return;
        _changes += _isKnown ? 1 : 0;
        _isKnown = true;
        _known.Clear();
        foreach (MissionItemInt item in items)
            _known.Add(FenceItem.From(item));
        _report = new AutopilotFence { IsKnown = true, Changes = _changes, Items = [.. items.ToArray()] };
    }

    private bool IsKnown(ReadOnlySpan<MissionItemInt> items)
    {
        if (items.Length != _known.Count)
            return false;
        for (int i = 0; i < items.Length; i++)
        {
            if (FenceItem.From(items[i]) != _known[i])
                return false;
        }

        return true;
    }
}
