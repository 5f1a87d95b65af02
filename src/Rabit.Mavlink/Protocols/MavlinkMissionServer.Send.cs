using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Frames to send.
public sealed partial class MavlinkMissionServer
{
    private MavlinkFrame Create(in MissionReply reply) => reply.Is switch
    {
        MissionReply.Kind.Count => _sender.Create(new MissionCount
        {
            TargetSystem = reply.Target.SystemId,
            TargetComponent = reply.Target.ComponentId,
            Count = (ushort)_plans[(int)reply.Type].Count,
            MissionType = reply.Type,
            OpaqueId = IdOf(reply.Type),
        }),
        MissionReply.Kind.Item => _sender.Create(ItemOf(reply)),
        MissionReply.Kind.Ack => _sender.Create(new MissionAck
        {
            TargetSystem = reply.Target.SystemId,
            TargetComponent = reply.Target.ComponentId,
            Type = reply.Result,
            MissionType = reply.Type,
            OpaqueId = reply.Result == MavMissionResult.Accepted ? IdOf(reply.Type) : 0,
        }),
        MissionReply.Kind.Current => _sender.Create(CurrentMessage()),
        _ => _sender.Create(new MissionItemReached { Seq = (ushort)reply.Sequence }),
    };

    private MissionItemInt ItemOf(in MissionReply reply)
    {
        // The number was checked when it was requested; the items may have been changed since.
        StoredMissionItems plan = _plans[(int)reply.Type];
        MissionItemInt item = reply.Sequence < plan.Count ? plan.Items[reply.Sequence] : default;
        item.TargetSystem = reply.Target.SystemId;
        item.TargetComponent = reply.Target.ComponentId;
        item.MissionType = reply.Type;
        item.Current = reply.Type == MavMissionType.Mission && reply.Sequence == Current ? (byte)1 : (byte)0;
        return item;
    }

    private MissionCurrent CurrentMessage()
    {
        int count = _plans[0].Count;
        return new MissionCurrent
        {
            Seq = (ushort)Current,
            Total = (ushort)(_options.BehavesAsArduPilot && count > 0 ? count - 1 : count),
            MissionState = count == 0 ? MissionState.NoMission : State,
            MissionId = IdOf(MavMissionType.Mission),
            FenceId = IdOf(MavMissionType.Fence),
            RallyPointsId = IdOf(MavMissionType.Rally),
        };
    }

    private MavlinkFrame Request()
    {
        MavlinkAddress target = _uploader!.Value;
        int wanted = IsDecisionAwaited ? _uploadCount - 1 : _received;
        return _options.BehavesAsArduPilot
            ? _sender.Create(new MissionRequest
            {
                TargetSystem = target.SystemId,
                TargetComponent = target.ComponentId,
                Seq = (ushort)wanted,
                MissionType = _uploadType,
            })
            : _sender.Create(new MissionRequestInt
            {
                TargetSystem = target.SystemId,
                TargetComponent = target.ComponentId,
                Seq = (ushort)wanted,
                MissionType = _uploadType,
            });
    }

    private void Acknowledge(MavMissionResult result, MavMissionType type, MavlinkAddress target)
    {
        if (result != MavMissionResult.Accepted)
            Refusals++;
        Enqueue(new MissionReply { Is = MissionReply.Kind.Ack, Result = result, Type = type, Target = target });
    }

    private void Enqueue(in MissionReply reply)
    {
        if (_replyCount == _replies.Length)
        {
            Dropped++;
            return;
        }

        _replies[(_firstReply + _replyCount) % _replies.Length] = reply;
        _replyCount++;
    }
}
