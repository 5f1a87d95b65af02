using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Takes in what comes over the link: what is for us goes to whom it concerns, what is for other systems is left
/// alone.
/// </summary>
internal sealed class FrameDispatcher(
    FlightController controller,
    CommandService commands,
    CommandHandler modes,
    TargetReader targets,
    ParameterService parameters,
    MissionService missions,
    StationService stations,
    StreamSchedule streams,
    AutopilotAddress address,
    IFrameSink sink)
{
    /// <param name="frame">One that a reader has checked.</param>
    /// <param name="bootNanoseconds">When it came, by the autopilot's clock.</param>
    public void Handle(in MavlinkFrame frame, long bootNanoseconds)
    {
        if (!IsForUs(frame))
            return;
        var sender = new Sender(frame.SystemId, frame.ComponentId);
        switch (frame.MessageId)
        {
            case Heartbeat.MavlinkId:
                controller.Failsafes.GroundStation.Receive(frame.SystemId, Now);
                break;
            case RcChannelsOverride.MavlinkId:
                frame.TryDecode(out RcChannelsOverride channels);
                Handle(channels, sender);
                break;
            case CommandLong.MavlinkId or CommandInt.MavlinkId: commands.Handle(frame, Now); break;
            case SetMode.MavlinkId: frame.TryDecode(out SetMode mode); modes.Handle(mode, sender); break;
            case SetPositionTargetGlobalInt.MavlinkId:
                frame.TryDecode(out SetPositionTargetGlobalInt global);
                targets.Handle(global);
                break;
            case SetPositionTargetLocalNed.MavlinkId:
                frame.TryDecode(out SetPositionTargetLocalNed local);
                targets.Handle(local);
                break;
            case ParamRequestRead.MavlinkId or ParamRequestList.MavlinkId or ParamSet.MavlinkId:
                parameters.Handle(frame, Now);
                break;
            case RequestDataStream.MavlinkId: frame.TryDecode(out RequestDataStream stream); Handle(stream); break;
            case Timesync.MavlinkId: frame.TryDecode(out Timesync sync); Handle(sync, sender, bootNanoseconds); break;
            default:
                if (!stations.TryHandle(frame, Now))
                    missions.Handle(frame, Now);
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
        return (system == 0 || system == address.SystemId)
            && (component == 0 || component == AutopilotAddress.ComponentId);
    }

    private void Handle(in RequestDataStream request)
        => streams.SetGroup(
            request.ReqStreamId, request.StartStop == 0 ? 0 : request.ReqMessageRate, controller.Situation.Time);

    private void Handle(in Timesync request, Sender sender, long bootNanoseconds)
    {
        // Anything but zero is the answer to a question of ours.
        if (request.Tc1 != 0)
            return;
        sink.Send(
            new Timesync
            {
                Tc1 = bootNanoseconds,
                Ts1 = request.Ts1,
                TargetSystem = sender.SystemId,
                TargetComponent = sender.ComponentId
            });
    }

    private void Handle(in RcChannelsOverride channels, Sender sender)
    {
        // Only the ground station of SYSID_MYGCS may; FLTMODE_CH is channel 5.
        Parameter groundStation = controller.Situation.Parameters.GroundSystemId;
        if (sender.SystemId == (byte)groundStation.Value)
            controller.Switch.Override(channels.Chan5Raw, Now);
    }
}
