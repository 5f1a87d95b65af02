using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Takes in what comes over the links: what is for us goes to whom it concerns, what is for other systems is left
/// alone.
/// </summary>
internal sealed class Px4FrameDispatcher(
    Px4Controller controller,
    CommandService commands,
    Px4CommandHandler modes,
    Px4SetPointReader setPoints,
    Px4ParameterService parameters,
    Px4MissionService missions,
    StationService stations,
    Px4Events events,
    Px4Links links,
    SimulationRandom garbage,
    ILinkSink sink)
{
    private const int RadioOnly = 0;
    private const int NoSticks = 4;

    public void Handle(in MavlinkFrame frame, long bootNanoseconds, int link)
    {
        if (!IsForUs(frame))
            return;
        switch (frame.MessageId)
        {
            case Heartbeat.MavlinkId: frame.TryDecode(out Heartbeat heartbeat); Handle(heartbeat, link); break;
            case CommandLong.MavlinkId or CommandInt.MavlinkId: commands.Handle(frame, Now, link); break;
            case SetMode.MavlinkId: frame.TryDecode(out SetMode mode); modes.Handle(mode); break;
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
                events.Handle(request, new Sender(frame.SystemId, frame.ComponentId), link);
                break;
            case ParamRequestRead.MavlinkId or ParamRequestList.MavlinkId or ParamSet.MavlinkId:
                parameters.Handle(frame, Now, link);
                break;
            default:
                if (!stations.TryHandle(frame, Now, link))
                    missions.Handle(frame, Now, link);
                break;
        }
    }

    private TimeSpan Now => controller.Situation.Time;

    private bool IsForUs(in MavlinkFrame frame)
    {
        if (!MavlinkDialect.All.TryGetMessage(frame.MessageId, out MavlinkMessageInfo info))
            return false;
        byte system = frame.TargetSystem(info);
        byte component = frame.TargetComponent(info);
        byte own = controller.Situation.Parameters.OwnSystemId;
        return (system == 0 || system == own) && (component == 0 || component == AutopilotAddress.ComponentId);
    }

    private void Handle(in Heartbeat heartbeat, int link)
    {
        if (heartbeat.Type == MavType.Gcs)
            links.ReceiveGroundHeartbeat(link);
    }

    private void Handle(in ManualControl sticks)
    {
        int input = controller.Situation.Parameters.ManualInput.Whole;
        byte own = controller.Situation.Parameters.OwnSystemId;
        if (input is not (RadioOnly or NoSticks) && (sticks.Target == 0 || sticks.Target == own))
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
