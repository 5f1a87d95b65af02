using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Uploads.
public sealed partial class MavlinkMissionServer
{
    // How long the station of an upload that was completed may send its last item again: its acknowledgement was lost.
    private static readonly TimeSpan LastItemTime = TimeSpan.FromSeconds(10);

    private MavlinkAddress? _uploader;
    private MavMissionType _uploadType;
    private int _uploadCount;
    private int _received;
    private byte _countSequence;
    private TimeSpan _requestDue;
    private TimeSpan _giveUpAt;
    private bool _isSignedToTheEnd;

    // While a decision is awaited.
    private static readonly TimeSpan KeepAliveInterval = TimeSpan.FromSeconds(1);

    // The upload that was completed last.
    private MavlinkAddress _lastUploader;
    private MavMissionType _lastType;
    private int _lastCount;
    private TimeSpan _lastUntil = TimeSpan.MinValue;

    private void Receive(in MavlinkFrame frame, in MissionCount count, TimeSpan now)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);

        // A copy of the count, by the link or because the first request was lost, does not begin it again.
        bool isSame = _uploader == source && count.MissionType == _uploadType && count.Count == _uploadCount;
        if (isSame && (_received == 0 || frame.Sequence == _countSequence))
        {
            _requestDue = _received == 0 ? now : _requestDue;
            return;
        }

        MavMissionResult result = CheckUpload(count, source, frame.IsSigned);
        if (result != MavMissionResult.Accepted)
        {
            Acknowledge(result, count.MissionType, source);
            return;
        }

        Aborts += _uploader is null ? 0 : 1;
        _uploader = source;
        (_uploadType, _uploadCount, _received) = (count.MissionType, count.Count, 0);
        _countSequence = frame.Sequence;
        _lastUntil = TimeSpan.MinValue;
        PlanOf(_uploadType).Reserve(_uploadCount);
        GoOn(frame.IsSigned, now);
    }

    private MavMissionResult CheckUpload(in MissionCount count, MavlinkAddress source, bool isSigned)
        => !Has(count.MissionType) ? MavMissionResult.Unsupported
            : _uploader is { } other && other != source ? MavMissionResult.Denied
            : count.Count > _options.MaxItems ? MavMissionResult.NoSpace
            : _rules?.CheckTransfer(count.MissionType, count.Count, source, isSigned) ?? MavMissionResult.Accepted;

    private void Receive(in MavlinkFrame frame, in MissionItemInt item, TimeSpan now)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        if (_uploader != source || item.MissionType != _uploadType || item.Seq != _received)
        {
            ReceiveStray(item, source, now);
            return;
        }

        MavMissionResult result = _rules?.CheckItem(item) ?? MavMissionResult.Accepted;
        if (result != MavMissionResult.Accepted)
        {
            Acknowledge(result, _uploadType, source);
            if (!_options.BehavesAsArduPilot)
                _uploader = null;
            return;
        }

        PlanOf(_uploadType).SetIncoming(_received, item with { TargetSystem = 0, TargetComponent = 0 });
        _received++;
        GoOn(frame.IsSigned, now);
    }

    private void ReceiveStray(in MissionItemInt item, MavlinkAddress source, TimeSpan now)
    {
        StrayItems++;
        if (_uploader is null && source == _lastUploader && item.MissionType == _lastType
            && item.Seq == _lastCount - 1 && now < _lastUntil && !_options.BehavesAsArduPilot)
        {
            Acknowledge(MavMissionResult.Accepted, _lastType, source);
            return;
        }

        if (_options.BehavesAsArduPilot)
            Acknowledge(
                !Has(item.MissionType) ? MavMissionResult.Unsupported
                    : _uploader is null ? MavMissionResult.Error
                    : _uploader != source ? MavMissionResult.Denied
                    : MavMissionResult.InvalidSequence,
                item.MissionType, source);
    }

    private void GoOn(bool isSigned, TimeSpan now)
    {
        _requestDue = now;
        _giveUpAt = now + _options.Timeout;
        if (_received < _uploadCount)
            return;
        StoredMissionItems plan = PlanOf(_uploadType);
        MavMissionResult result =
            _rules?.CheckItems(_uploadType, plan.Incoming(_uploadCount)) ?? MavMissionResult.Accepted;
        _isSignedToTheEnd = isSigned;
        if (result == MavMissionResult.Accepted && _options.DecidesLater && _uploadCount > 0)
            _requestDue = now + KeepAliveInterval;
        else
            Finish(result, now);
    }

    /// <summary>
    /// Decides on the upload that waits for it: it is stored where it is accepted, and acknowledged.
    /// </summary>
    /// <param name="result">The result.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether there was one: the station may have given it up.</returns>
    public bool Decide(MavMissionResult result, TimeSpan now)
    {
        bool isAwaited = IsDecisionAwaited;
        if (isAwaited)
            Finish(result, now);
        return isAwaited;
    }

    private void Finish(MavMissionResult result, TimeSpan now)
    {
        MavlinkAddress source = _uploader!.Value;
        bool isSigned = _isSignedToTheEnd;
        _uploader = null;
        StoredMissionItems plan = PlanOf(_uploadType);
        if (result == MavMissionResult.Accepted)
        {
            plan.Commit(_uploadCount);
            Changed(_uploadType, source, isSigned);
            (_lastUploader, _lastType, _lastCount) = (source, _uploadType, _uploadCount);
            _lastUntil = now + LastItemTime;
        }

        Acknowledge(result, _uploadType, source);
    }

    private void Changed(MavMissionType type, MavlinkAddress source, bool isSigned)
    {
        StoredMissionItems plan = _plans[(int)type];
        plan.Change = new MavlinkMissionChange(type, plan.Count, source, isSigned, plan.Id);
        if (type == MavMissionType.Mission)
        {
            Current = 0;
            _wantedCurrent = null;
        }
    }

    private void StepUpload(TimeSpan now)
    {
        if (_uploader is not { } source || now < _giveUpAt || IsDecisionAwaited)
            return;
        Aborts++;
        _uploader = null;
        Acknowledge(MavMissionResult.OperationCancelled, _uploadType, source);
    }
}
