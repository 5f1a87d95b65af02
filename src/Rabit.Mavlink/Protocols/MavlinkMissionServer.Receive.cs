using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Received frames.
public sealed partial class MavlinkMissionServer
{
    private const int MaxDownloads = 8;

    // Who is downloading what: to notice that it has changed meanwhile.
    private readonly (MavlinkAddress Source, MavMissionType Type, int Version)[] _downloads =
        new (MavlinkAddress, MavMissionType, int)[MaxDownloads];

    private int _nextDownload;

    /// <summary>Handles a received frame; all but mission messages for us are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        switch (frame.MessageId)
        {
            case MissionCount.MavlinkId when frame.TryDecode(out MissionCount message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Receive(frame, message, now);
                break;
            case MissionItemInt.MavlinkId when frame.TryDecode(out MissionItemInt message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Receive(frame, message, now);
                break;
            case MissionRequestList.MavlinkId when frame.TryDecode(out MissionRequestList message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    StartDownload(frame, message.MissionType);
                break;
            case MissionRequestInt.MavlinkId when frame.TryDecode(out MissionRequestInt message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    SendItem(frame, message.MissionType, message.Seq);
                break;
            case MissionRequest.MavlinkId when frame.TryDecode(out MissionRequest message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    SendItem(frame, message.MissionType, message.Seq);
                break;
            default:
                HandleOther(frame);
                break;
        }
    }

    private void HandleOther(in MavlinkFrame frame)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        switch (frame.MessageId)
        {
            case MissionClearAll.MavlinkId when frame.TryDecode(out MissionClearAll message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Clear(message.MissionType, source, frame.IsSigned);
                break;
            case MissionAck.MavlinkId when frame.TryDecode(out MissionAck message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    EndTransfer(message, source);
                break;
            case MissionSetCurrent.MavlinkId when frame.TryDecode(out MissionSetCurrent message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    SetCurrent(message.Seq, source, frame.IsSigned);
                break;
            case MissionRequestPartialList.MavlinkId when frame.TryDecode(out MissionRequestPartialList message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Acknowledge(MavMissionResult.Unsupported, message.MissionType, source);
                break;
            case MissionWritePartialList.MavlinkId when frame.TryDecode(out MissionWritePartialList message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Acknowledge(MavMissionResult.Unsupported, message.MissionType, source);
                break;
            default:
                break;
        }
    }

    private bool IsForUs(byte system, byte component) => _options.HandlesBroadcast
        ? new MavlinkAddress(_sender.SystemId, _sender.ComponentId).IsTargetOf(system, component)
        : system == _sender.SystemId && component == _sender.ComponentId;

    private bool Has(MavMissionType type) => type switch
    {
        MavMissionType.Mission => _options.HasMission,
        MavMissionType.Fence => _options.HasFence,
        MavMissionType.Rally => _options.HasRally,
        _ => false,
    };

    private void StartDownload(in MavlinkFrame frame, MavMissionType type)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        if (!Has(type))
        {
            Acknowledge(MavMissionResult.Unsupported, type, source);
            return;
        }

        int place = FindDownload(source, type);
        if (place < 0)
        {
            place = _nextDownload;
            _nextDownload = (_nextDownload + 1) % MaxDownloads;
        }

        _downloads[place] = (source, type, PlanOf(type).Version);
        Enqueue(new MissionReply { Is = MissionReply.Kind.Count, Type = type, Target = source });
    }

    private void SendItem(in MavlinkFrame frame, MavMissionType type, int sequence)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        if (!Has(type))
        {
            Acknowledge(MavMissionResult.Unsupported, type, source);
            return;
        }

        StoredMissionItems plan = PlanOf(type);
        int place = FindDownload(source, type);
        if (place >= 0 && _downloads[place].Version != plan.Version)
        {
            _downloads[place] = default;
            Acknowledge(MavMissionResult.OperationCancelled, type, source);
            return;
        }

        if (sequence >= plan.Count)
            Acknowledge(MavMissionResult.InvalidSequence, type, source);
        else
            Enqueue(new MissionReply
            {
                Is = MissionReply.Kind.Item,
                Type = type,
                Target = source,
                Sequence = sequence
            });
    }

    private int FindDownload(MavlinkAddress source, MavMissionType type)
    {
        for (int i = 0; i < _downloads.Length; i++)
        {
            if (_downloads[i].Source == source && _downloads[i].Type == type && source.SystemId != 0)
                return i;
        }

        return -1;
    }

    private void Clear(MavMissionType type, MavlinkAddress source, bool isSigned)
    {
        bool isAll = type == MavMissionType.All;
        MavMissionResult result = !isAll && !Has(type) ? MavMissionResult.Unsupported
            : _uploader is { } other && other != source ? MavMissionResult.Denied
            : _rules?.CheckTransfer(type, 0, source, isSigned) ?? MavMissionResult.Accepted;
        if (result == MavMissionResult.Accepted)
        {
            for (int i = 0; i < TypeCount; i++)
            {
                var each = (MavMissionType)i;
                if (!Has(each) || (!isAll && each != type))
                    continue;
                if (_uploader is not null && _uploadType == each)
                {
                    Aborts++;
                    _uploader = null;
                }

                _plans[i].Commit(0);
                Changed(each, source, isSigned);
            }
        }

        Acknowledge(result, type, source);
    }

    // A station that gives up its upload says so; what it says of a download ends that.
    private void EndTransfer(in MissionAck message, MavlinkAddress source)
    {
        if (_uploader == source && message.MissionType == _uploadType && message.Type != MavMissionResult.Accepted)
        {
            Aborts++;
            _uploader = null;
        }

        int place = FindDownload(source, message.MissionType);
        if (place >= 0)
            _downloads[place] = default;
    }

    private void SetCurrent(int sequence, MavlinkAddress source, bool isSigned)
    {
        MavMissionResult result = !_options.HasMission ? MavMissionResult.Unsupported
            : _rules?.CheckTransfer(MavMissionType.Mission, _plans[0].Count, source, isSigned)
                ?? MavMissionResult.Accepted;
        if (result == MavMissionResult.Accepted && !TrySetCurrent(sequence))
            result = MavMissionResult.InvalidSequence;
        if (result == MavMissionResult.Accepted)
            _wantedCurrent = sequence;
        else
            Acknowledge(result, MavMissionType.Mission, source);
    }
}
