using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Has a mission, a fence and rally points. As a receiver it asks again every 250 ms (PX4), or every second with
/// MISSION_REQUEST, and says INVALID_SEQUENCE to copies (ArduPilot).
/// </summary>
internal sealed class MissionVehicle(bool isArduPilot) : ScriptedVehicle
{
    private static readonly TimeSpan GiveUpAfter = TimeSpan.FromSeconds(8);
    private readonly Dictionary<MavMissionType, List<MissionItemInt>> _stored = [];
    private readonly TimeSpan _again = TimeSpan.FromSeconds(isArduPilot ? 1 : 0.25);
    private List<MissionItemInt>? _incoming;
    private MavMissionType _type;
    private int _count;
    private TimeSpan _askAgainAt;
    private TimeSpan _giveUpAt;

    public MavMissionResult? Refuses { get; set; }

    public List<MissionItemInt> this[MavMissionType type]
    {
        get => _stored.TryGetValue(type, out List<MissionItemInt>? items) ? items : [];
        set => _stored[type] = value;
    }

    public override TimeSpan NextDue => _incoming is null ? TimeSpan.MaxValue : _askAgainAt;

    public override void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.TryDecode(out MissionCount count))
        {
            TakeCount(count, now);
        }
        else if (frame.TryDecode(out MissionItemInt item))
        {
            TakeItem(item, now);
        }
        else if (frame.TryDecode(out MissionRequestList list))
        {
            Send(
                new MissionCount
                {
                    TargetSystem = 1,
                    TargetComponent = 191,
                    Count = (ushort)this[list.MissionType].Count,
                    MissionType = list.MissionType
                });
        }
        else if (frame.TryDecode(out MissionRequestInt request))
        {
            if (request.Seq < this[request.MissionType].Count)
                Send(this[request.MissionType][request.Seq] with { TargetSystem = 1, TargetComponent = 191 });
            else
                Answer(MavMissionResult.InvalidSequence, request.MissionType);
        }
        else if (frame.TryDecode(out MissionClearAll clear))
        {
            if (Refuses is null)
                _stored.Remove(clear.MissionType);
            Answer(Refuses ?? MavMissionResult.Accepted, clear.MissionType);
        }
        else if (frame.TryDecode(out MissionAck answer) && answer.Type == MavMissionResult.OperationCancelled)
        {
            _incoming = null;
        }
    }

    public override void Tick(TimeSpan now)
    {
        if (_incoming is null || now < _askAgainAt)
            return;
        if (now >= _giveUpAt)
            _incoming = null;
        else
            Ask(now);
    }

    private void TakeCount(in MissionCount count, TimeSpan now)
    {
        if (Refuses is { } result)
        {
            Answer(result, count.MissionType);
            return;
        }

        // A copy of the count must not restart what has begun.
        if (_incoming is { Count: > 0 } && count.MissionType == _type && count.Count == _count)
            return;
        _type = count.MissionType;
        _count = count.Count;
        _incoming = [];
        _giveUpAt = now + GiveUpAfter;
        if (_count == 0)
            Complete();
        else
            Ask(now);
    }

    private void TakeItem(in MissionItemInt item, TimeSpan now)
    {
        if (_incoming is null)
        {
            // PX4 takes a copy of the last item for a sign that its answer was lost.
            bool isLastAgain = !isArduPilot && item.MissionType == _type && item.Seq == _count - 1
                && this[_type].Count == _count;
            Answer(isLastAgain ? MavMissionResult.Accepted : MavMissionResult.Error, item.MissionType);
            return;
        }

        if (item.Seq != _incoming.Count || item.MissionType != _type)
        {
            if (isArduPilot)
                Answer(MavMissionResult.InvalidSequence, item.MissionType);
            return;
        }

        _incoming.Add(item with { TargetSystem = 0, TargetComponent = 0 });
        _giveUpAt = now + GiveUpAfter;
        if (_incoming.Count == _count)
            Complete();
        else
            Ask(now);
    }

    private void Ask(TimeSpan now)
    {
        _askAgainAt = now + _again;
        if (isArduPilot)
            Send(
                new MissionRequest
                {
                    TargetSystem = 1,
                    TargetComponent = 191,
                    Seq = (ushort)_incoming!.Count,
                    MissionType = _type
                });
        else
            Send(
                new MissionRequestInt
                {
                    TargetSystem = 1,
                    TargetComponent = 191,
                    Seq = (ushort)_incoming!.Count,
                    MissionType = _type
                });
    }

    private void Complete()
    {
        _stored[_type] = _incoming!;
        _incoming = null;
        Answer(MavMissionResult.Accepted, _type);
    }

    private void Answer(MavMissionResult result, MavMissionType type) =>
        Send(new MissionAck { TargetSystem = 1, TargetComponent = 191, Type = result, MissionType = type });
}
