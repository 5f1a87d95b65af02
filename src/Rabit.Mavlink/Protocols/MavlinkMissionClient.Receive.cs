using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

// Received frames.
public sealed partial class MavlinkMissionClient
{
    private const int MaxFinalAckRepeats = 5;

    /// <summary>Handles a received frame; all but the mission messages of the vehicle for us are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (!_target.IsSourceOf(frame))
            return;
        switch (frame.MessageId)
        {
            case MissionRequestInt.MavlinkId when frame.TryDecode(out MissionRequestInt request):
                if (IsOurs(frame, request.TargetSystem, request.TargetComponent, request.MissionType))
                    TakeRequest(request.Seq, now);
                break;
            case MissionRequest.MavlinkId when frame.TryDecode(out MissionRequest request):
                if (IsOurs(frame, request.TargetSystem, request.TargetComponent, request.MissionType))
                    TakeRequest(request.Seq, now);
                break;
            case MissionCount.MavlinkId when frame.TryDecode(out MissionCount count):
                if (IsOurs(frame, count.TargetSystem, count.TargetComponent, count.MissionType))
                    TakeCount(count, now);
                break;
            case MissionItemInt.MavlinkId when frame.TryDecode(out MissionItemInt item):
                TakeItem(frame, item, now);
                break;
            case MissionAck.MavlinkId when frame.TryDecode(out MissionAck answer):
                if (IsOurs(frame, answer.TargetSystem, answer.TargetComponent, answer.MissionType))
                    TakeAck(answer, now);
                break;
            default:
                break;
        }
    }

    // MAVLink 1 has no place for the type of a mission.
    private bool IsOurs(in MavlinkFrame frame, byte system, byte component, MavMissionType type) =>
        _sent > 0 && _own.IsTargetOf(system, component) && (type == _type || frame.Version == MavlinkVersion.V1);

    private void TakeRequest(int seq, TimeSpan now)
    {
        if (_operation != Operation.Upload || seq >= _count)
            return;
        _seq = seq;
        _step = Step.Item;
        _due = now;
        _tries = 0;
        if (seq <= _highest)
            return;   // requested again: answered, but no progress

        _highest = seq;
        _result = null;
        _giveUpAt = now + new TimeSpan(_options.AnswerTimeout.Ticks * (_options.Retries + 1));
    }

    private void TakeCount(in MissionCount count, TimeSpan now)
    {
        if (_operation != Operation.Download || _step != Step.List)
            return;
        Reserve(count.Count);
        if (count.Count == 0)
        {
            Complete(now);
            return;
        }

        _step = Step.Request;
        _tries = 0;
        _due = now;
    }

    private void TakeItem(in MavlinkFrame frame, in MissionItemInt item, TimeSpan now)
    {
        if (!_own.IsTargetOf(item.TargetSystem, item.TargetComponent))
            return;
        if (_operation == Operation.None && _isDownloadOver && item.Seq == _count - 1 && item.MissionType == _type
            && _seq == _count)
        {
            // The vehicle did not receive the final acknowledgement.
            if (_finalAckRepeats++ < MaxFinalAckRepeats)
                QueueFinalAck(MavMissionResult.Accepted);
            return;
        }

        // PX4 1.14 sends the items of fences and rally points without their type: accepted, unless they may be left
        // from a mission.
        bool hasNoType = item.MissionType == MavMissionType.Mission
            && (frame.Version == MavlinkVersion.V1 || _lastPlainAt == TimeSpan.MinValue
                || now > _lastPlainAt + _options.LateAnswerTime);
        if (_operation != Operation.Download || _step != Step.Request || item.Seq != _seq
            || (item.MissionType != _type && !hasNoType))
            return;
        _items[_seq] = item;
        _seq++;
        _tries = 0;
        _due = now;
        if (_seq == _count)
            Complete(now);
    }

    private void TakeAck(in MissionAck answer, TimeSpan now)
    {
        if (_operation == Operation.None)
            return;
        bool isAccepted = answer.Type == MavMissionResult.Accepted;
        switch (_operation)
        {
            // One that arrives before this was asked is an answer to what was asked before.
            case Operation.Clear when _tries == 0:
                return;

            // One that arrives before everything was requested is left from another transfer.
            case Operation.Upload when isAccepted && _highest < _count - 1:
            case Operation.Download when isAccepted:
                return;

            // ArduPilot answers a second copy of an item so, and continues.
            case Operation.Upload or Operation.Download when answer.Type == MavMissionResult.InvalidSequence:
                _result = answer.Type;
                return;

            // To a second copy of the last item, perhaps: then the transfer is over, and its answer lost or still in
            // flight.
            case Operation.Upload when answer.Type == MavMissionResult.Error && IsAllSent:
                _result = answer.Type;
                _tries = _options.Retries + 1;
                _due = now + _options.LateAnswerTime;
                return;
            default:
                _result = answer.Type;
                End(StatusOf(answer.Type), answer.OpaqueId, now);
                return;
        }
    }

    private bool IsAllSent => _count > 0 && _highest == _count - 1;

    private static MavlinkMissionStatus StatusOf(MavMissionResult result) => result switch
    {
        MavMissionResult.Accepted => MavlinkMissionStatus.Done,
        MavMissionResult.OperationCancelled => MavlinkMissionStatus.Cancelled,
        _ => MavlinkMissionStatus.Refused,
    };

    private void Complete(TimeSpan now)
    {
        QueueFinalAck(MavMissionResult.Accepted);
        End(MavlinkMissionStatus.Done, 0, now);
    }
}
