using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

// Clearing, by what the vehicle knows: all at once, one type after the other, a transfer of no items.
public sealed partial class MavlinkMissionClient
{
    private static readonly MavMissionType[] Types =
        [MavMissionType.Mission, MavMissionType.Fence, MavMissionType.Rally];

    // Which of the types, where they are cleared one by one; -1 where not.
    private int _typeIndex;
    private bool _wasAnswered;
    private MavlinkMissionStatus? _failure;
    private MavMissionResult? _failureResult;

    private void BeginClearing() => (_typeIndex, _wasAnswered, _failure, _failureResult) = (-1, false, null, null);

    // Whether there is more to do after a step has ended so; else how clearing has ended.
    private bool GoesOnClearing(ref MavlinkMissionStatus status, TimeSpan now)
    {
        _wasAnswered |= _result is not null;
        if (status == MavlinkMissionStatus.Cancelled)
            return false;
        if (status == MavlinkMissionStatus.Refused && _result == MavMissionResult.Unsupported
            && _step == Step.Clear && _type != MavMissionType.All)
        {
            // A late copy of the refusal must not be taken for the answer.
            Ask(Step.Count, _type, _lastSentAt + _options.LateAnswerTime);
            return true;
        }

        bool isOneByOne = _typeIndex >= 0 || (_type == MavMissionType.All && status != MavlinkMissionStatus.Done);
        if (!isOneByOne)
            return false;
        if (_typeIndex >= 0)
            Note(status);

        // One that answers nothing at all is not asked for the rest.
        bool isSilent = _typeIndex == 0 && !_wasAnswered;
        if (++_typeIndex < Types.Length && !isSilent)
        {
            Ask(Step.Clear, Types[_typeIndex], now);
            return true;
        }

        status = _failure ?? MavlinkMissionStatus.Done;
        _result = _failure is null ? MavMissionResult.Accepted : _failureResult;
        return false;
    }

    // A vehicle that has no fences or no rally points has none left.
    private void Note(MavlinkMissionStatus status)
    {
        bool hasNone = status == MavlinkMissionStatus.Refused && _result == MavMissionResult.Unsupported
            && _type != MavMissionType.Mission;
        if (status != MavlinkMissionStatus.Done && !hasNone && _failure is null)
            (_failure, _failureResult) = (status, _result);
    }

    private void Ask(Step step, MavMissionType type, TimeSpan due)
        => (_step, _type, _due, _tries, _result) = (step, type, due, 0, null);
}
