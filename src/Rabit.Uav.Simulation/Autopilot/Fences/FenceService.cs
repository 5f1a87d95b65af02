using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The mission protocol's server for MAV_MISSION_TYPE_FENCE, as ArduPilot has it: it asks for one item after the other
/// by MISSION_REQUEST, an item that it rejects does not end the transfer, and the old fence stays until the new one is
/// complete. For missions and rally points it is empty and takes nothing.
/// </summary>
internal sealed class FenceService(WorldFrame frame, IFrameSink sink)
{
    private const int MaxItems = 84;
    private const int NorthPoleDegE7 = 900_000_000;
    private const int DateLineDegE7 = 1_800_000_000;
    private static readonly TimeSpan AskAgainAfter = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan GiveUpAfter = TimeSpan.FromSeconds(8);

    private readonly List<MissionItemInt> _upload = [];
    private Sender? _uploader;
    private int _uploadCount;
    private TimeSpan _received;
    private TimeSpan _asked;

    /// <summary>What is stored; kept over a reboot.</summary>
    public IReadOnlyList<MissionItemInt> Items { get; private set; } = [];

    /// <summary>Called when another fence is stored: its items and shapes.</summary>
    public Action<FenceShapes>? Stored { get; set; }

    public void Handle(in MissionRequestList request, Sender sender) => sink.Send(new MissionCount
    {
        TargetSystem = sender.SystemId,
        TargetComponent = sender.ComponentId,
        Count = request.MissionType == MavMissionType.Fence ? (ushort)Items.Count : (ushort)0,
        MissionType = request.MissionType,
    });

    public void HandleRequest(int sequence, MavMissionType type, Sender sender)
    {
        if (type != MavMissionType.Fence || sequence >= Items.Count)
        {
            Acknowledge(MavMissionResult.InvalidSequence, type, sender);
            return;
        }

        MissionItemInt item = Items[sequence];
        item.TargetSystem = sender.SystemId;
        item.TargetComponent = sender.ComponentId;
        sink.Send(item);
    }

    public void Handle(in MissionClearAll request, Sender sender)
    {
        if (request.MissionType is not (MavMissionType.Fence or MavMissionType.Mission or MavMissionType.Rally))
        {
            Acknowledge(MavMissionResult.Unsupported, request.MissionType, sender);
            return;
        }

        if (request.MissionType == MavMissionType.Fence)
            Store([]);
        Acknowledge(MavMissionResult.Accepted, request.MissionType, sender);
    }

    public void Handle(in MissionCount offer, Sender sender, TimeSpan time)
    {
        MavMissionResult? rejection = offer.MissionType != MavMissionType.Fence ? MavMissionResult.Unsupported
            : IsUploadOfAnother(sender) ? MavMissionResult.Denied
            : offer.Count > MaxItems ? MavMissionResult.NoSpace
            : null;
        if (rejection is { } result)
        {
            Acknowledge(result, offer.MissionType, sender);
            return;
        }

        _upload.Clear();
        _uploader = sender;
        _uploadCount = offer.Count;
        _received = time;
        GoOn(time);
    }

    public void Handle(in MissionItemInt item, Sender sender, TimeSpan time)
    {
        MavMissionResult? rejection = item.MissionType != MavMissionType.Fence ? MavMissionResult.Unsupported
            : IsUploadOfAnother(sender) ? MavMissionResult.Denied
            : _uploader is null ? MavMissionResult.Error
            : item.Seq != _upload.Count ? MavMissionResult.InvalidSequence
            : FindFault(item);
        if (rejection is { } result)
        {
            Acknowledge(result, item.MissionType, sender);
            return;
        }

        _upload.Add(item);
        _received = time;
        GoOn(time);
    }

    /// <summary>Asks again for what does not come, and gives up at last.</summary>
    public void Step(TimeSpan time)
    {
        if (_uploader is not { } sender)
            return;
        if (time - _received > GiveUpAfter)
        {
            _uploader = null;
            Acknowledge(MavMissionResult.OperationCancelled, MavMissionType.Fence, sender);
        }
        else if (time - _asked > AskAgainAfter)
        {
            Ask(sender, time);
        }
    }

    /// <summary>Takes what was stored before a reboot.</summary>
    public void Restore(FenceService before) => Store(before.Items);

    private void GoOn(TimeSpan time)
    {
        Sender sender = _uploader!.Value;
        if (_upload.Count < _uploadCount)
        {
            Ask(sender, time);
            return;
        }

        _uploader = null;
        bool isStored = Store(_upload.ToArray());
        Acknowledge(isStored ? MavMissionResult.Accepted : MavMissionResult.Error, MavMissionType.Fence, sender);
    }

    private void Ask(Sender sender, TimeSpan time)
    {
        _asked = time;
        sink.Send(new MissionRequest
        {
            TargetSystem = sender.SystemId,
            TargetComponent = sender.ComponentId,
            Seq = (ushort)_upload.Count,
            MissionType = MavMissionType.Fence,
        });
    }

    private bool Store(IReadOnlyList<MissionItemInt> items)
    {
        if (!FenceShapes.TryCreate(items, frame, out FenceShapes shapes))
            return false;
        Items = items;
        Stored?.Invoke(shapes);
        return true;
    }

    private bool IsUploadOfAnother(Sender sender)
        => _uploader is { } other
            && (other.SystemId != sender.SystemId || other.ComponentId != sender.ComponentId);

    private static MavMissionResult? FindFault(in MissionItemInt item)
    {
        bool isCircle = item.Command is MavCmd.NavFenceCircleInclusion or MavCmd.NavFenceCircleExclusion;
        bool isVertex =
            item.Command is MavCmd.NavFencePolygonVertexInclusion or MavCmd.NavFencePolygonVertexExclusion;
        if (!isCircle && !isVertex && item.Command != MavCmd.NavFenceReturnPoint)
            return MavMissionResult.Unsupported;
        if (item.Frame is not (MavFrame.Global or MavFrame.GlobalInt or MavFrame.GlobalRelativeAlt
            or MavFrame.GlobalRelativeAltInt))
            return MavMissionResult.UnsupportedFrame;
        if ((isCircle && !(item.Param1 > 0)) || (isVertex && !(item.Param1 >= 3)))
            return MavMissionResult.InvalidParam1;
        if (item.X is < -NorthPoleDegE7 or > NorthPoleDegE7)
            return MavMissionResult.InvalidParam5X;
        return item.Y is < -DateLineDegE7 or > DateLineDegE7 ? MavMissionResult.InvalidParam6Y : null;
    }

    private void Acknowledge(MavMissionResult result, MavMissionType type, Sender sender) => sink.Send(new MissionAck
    {
        TargetSystem = sender.SystemId,
        TargetComponent = sender.ComponentId,
        Type = result,
        MissionType = type,
    });
}
