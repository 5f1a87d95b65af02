using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The mission protocol for the fence: upload, download, clear. For missions and rally points it has none and takes
/// none.
/// </summary>
internal sealed class Px4FenceServer(Px4Fence fence, ILinkSink sink)
{
    private const int MaxItems = 100;

    private readonly List<MissionItemInt> _stored = [];
    private readonly List<MissionItemInt> _incoming = [];
    private int _expected;

    public void Handle(in MissionCount offer, Sender sender, int link)
    {
        if (offer.MissionType != MavMissionType.Fence)
            Acknowledge(MavMissionResult.Unsupported, offer.MissionType, sender, link);
        else if (offer.Count > MaxItems)
            Acknowledge(MavMissionResult.NoSpace, offer.MissionType, sender, link);
        else if (offer.Count == 0)
            Clear(offer.MissionType, sender, link);
        else
            Begin(offer.Count, sender, link);
    }

    public void Handle(in MissionItemInt item, Sender sender, int link)
    {
        if (item.MissionType != MavMissionType.Fence || _expected == 0)
            return;
        if (item.Seq != _incoming.Count)
        {
            Ask(sender, link);
            return;
        }

        _incoming.Add(item);
        if (_incoming.Count < _expected)
        {
            Ask(sender, link);
            return;
        }

        _expected = 0;
        bool isTaken = fence.TrySet(_incoming);
        if (isTaken)
        {
            _stored.Clear();
            _stored.AddRange(_incoming);
        }

        Acknowledge(isTaken ? MavMissionResult.Accepted : MavMissionResult.Error, item.MissionType, sender, link);
    }

    public void Handle(in MissionRequestList request, Sender sender, int link) => sink.Send(link, new MissionCount
    {
        TargetSystem = sender.SystemId,
        TargetComponent = sender.ComponentId,
        MissionType = request.MissionType,
        Count = (ushort)(request.MissionType == MavMissionType.Fence ? _stored.Count : 0),
    });

    public void Handle(in MissionRequestInt request, Sender sender, int link)
    {
        if (request.MissionType != MavMissionType.Fence || request.Seq >= _stored.Count)
        {
            Acknowledge(MavMissionResult.InvalidSequence, request.MissionType, sender, link);
            return;
        }

        MissionItemInt item = _stored[request.Seq];
        item.TargetSystem = sender.SystemId;
        item.TargetComponent = sender.ComponentId;
        sink.Send(link, item);
    }

    public void Handle(in MissionClearAll clear, Sender sender, int link) => Clear(clear.MissionType, sender, link);

    private void Clear(MavMissionType type, Sender sender, int link)
    {
        if (type is MavMissionType.Fence or MavMissionType.All)
        {
            _stored.Clear();
            fence.TrySet(_stored);
        }

        Acknowledge(MavMissionResult.Accepted, type, sender, link);
    }

    private void Begin(int count, Sender sender, int link)
    {
        _incoming.Clear();
        _expected = count;
        Ask(sender, link);
    }

    private void Ask(Sender sender, int link) => sink.Send(link, new MissionRequestInt
    {
        TargetSystem = sender.SystemId,
        TargetComponent = sender.ComponentId,
        Seq = (ushort)_incoming.Count,
        MissionType = MavMissionType.Fence,
    });

    private void Acknowledge(MavMissionResult result, MavMissionType type, Sender sender, int link)
        => sink.Send(link, new MissionAck
        {
            TargetSystem = sender.SystemId,
            TargetComponent = sender.ComponentId,
            Type = result,
            MissionType = type,
        });
}
