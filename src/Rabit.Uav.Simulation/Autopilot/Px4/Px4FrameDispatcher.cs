using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Takes in what comes over the links: what is for us goes to whom it concerns, what is for other systems is left
/// alone.
/// </summary>
internal sealed class Px4FrameDispatcher(
    Px4Controller controller,
    Px4CommandHandler commands,
    Px4SetPointReader setPoints,
    Px4ParameterService parameters,
    Px4FenceServer fence,
    Px4Events events,
    Px4Links links,
    SimulationRandom garbage,
    ILinkSink sink)
{
    private const int RadioOnly = 0;
    private const int NoSticks = 4;

    /// <summary>MAV_SYS_ID.</summary>
    public byte SystemId => (byte)NedMath.Limited(controller.Situation.Parameters.SystemId.Value, 1, byte.MaxValue);

    public void Handle(in MavlinkFrame frame, long bootNanoseconds, int link)
    {
        if (!IsForUs(frame))
            return;
        var sender = new Sender(frame.SystemId, frame.ComponentId);
        switch (frame.MessageId)
        {
            case Heartbeat.MavlinkId: frame.TryDecode(out Heartbeat heartbeat); Handle(heartbeat, link); break;
            case CommandLong.MavlinkId:
                frame.TryDecode(out CommandLong commandLong);
                commands.Handle(commandLong, sender, link);
                break;
            case CommandInt.MavlinkId:
                frame.TryDecode(out CommandInt commandInt);
                commands.Handle(commandInt, sender, link);
                break;
            case SetMode.MavlinkId: frame.TryDecode(out SetMode mode); commands.Handle(mode); break;
            case SetPositionTargetGlobalInt.MavlinkId:
                frame.TryDecode(out SetPositionTargetGlobalInt global);
                setPoints.Handle(global);
                break;
            case SetPositionTargetLocalNed.MavlinkId:
                frame.TryDecode(out SetPositionTargetLocalNed local);
                setPoints.Handle(local);
                break;
            case ManualControl.MavlinkId: frame.TryDecode(out ManualControl sticks); Handle(sticks); break;
            case Timesync.MavlinkId: frame.TryDecode(out Timesync sync); Handle(sync, bootNanoseconds, link); break;
            case RequestEvent.MavlinkId:
                frame.TryDecode(out RequestEvent request);
                events.Handle(request, sender, link);
                break;
            default: HandleTransfer(frame, sender, link); break;
        }
    }

    private void HandleTransfer(in MavlinkFrame frame, Sender sender, int link)
    {
        switch (frame.MessageId)
        {
            case ParamRequestRead.MavlinkId:
                frame.TryDecode(out ParamRequestRead read);
                parameters.Handle(read, link);
                break;
            case ParamRequestList.MavlinkId: parameters.HandleListRequest(link); break;
            case ParamSet.MavlinkId: frame.TryDecode(out ParamSet set); parameters.Handle(set, link); break;
            case MissionCount.MavlinkId:
                frame.TryDecode(out MissionCount count);
                fence.Handle(count, sender, link);
                break;
            case MissionItemInt.MavlinkId:
                frame.TryDecode(out MissionItemInt item);
                fence.Handle(item, sender, link);
                break;
            case MissionRequestList.MavlinkId:
                frame.TryDecode(out MissionRequestList list);
                fence.Handle(list, sender, link);
                break;
            case MissionRequestInt.MavlinkId:
                frame.TryDecode(out MissionRequestInt request);
                fence.Handle(request, sender, link);
                break;
            case MissionClearAll.MavlinkId:
                frame.TryDecode(out MissionClearAll clear);
                fence.Handle(clear, sender, link);
                break;
        }
    }

    private bool IsForUs(in MavlinkFrame frame)
    {
        if (!MavlinkDialect.All.TryGetMessage(frame.MessageId, out MavlinkMessageInfo info))
            return false;
        byte system = frame.TargetSystem(info);
        byte component = frame.TargetComponent(info);
        return (system == 0 || system == SystemId) && (component == 0 || component == AutopilotAddress.ComponentId);
    }

    private void Handle(in Heartbeat heartbeat, int link)
    {
        if (heartbeat.Type == MavType.Gcs)
            links.ReceiveGroundHeartbeat(link);
    }

    private void Handle(in ManualControl sticks)
    {
        int input = controller.Situation.Parameters.ManualInput.Whole;
        if (input is not (RadioOnly or NoSticks) && (sticks.Target == 0 || sticks.Target == SystemId))
            controller.Situation.Sticks.Receive(sticks, controller.Situation.Time);
    }

    // PX4 1.14 leaves the target of its answers uninitialised: whatever was on its stack.
    private void Handle(in Timesync request, long bootNanoseconds, int link)
    {
        if (request.Tc1 != 0)
            return;
        ulong target = garbage.Next();
        sink.Send(link, new Timesync
        {
            Tc1 = bootNanoseconds,
            Ts1 = request.Ts1,
            TargetSystem = (byte)target,
            TargetComponent = (byte)(target >> 8),
        });
    }
}
