using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Commands that ask for messages. An interval for HEARTBEAT is FAILED, a request for one is answered at once; what is
/// not known is DENIED (CURRENT_MODE among it) or, as a command, UNSUPPORTED.
/// </summary>
internal sealed class Px4RequestHandler(
    Px4Controller controller, Px4Links links, Px4Telemetry telemetry, ILinkSink sink)
{
    private const float MaxNumber = 1 << 24;   // message ids have 24 bits

    public MavResult Execute(in CommandInt command, int link)
    {
        int messageId = command.Param1 >= 0 && command.Param1 < MaxNumber ? (int)command.Param1 : -1;
        switch (command.Command)
        {
            case MavCmd.SetMessageInterval:
                return links.Streams(link).Set(messageId, command.Param2, controller.Situation.Time);
            case MavCmd.GetMessageInterval:
                int interval = messageId == Heartbeat.MavlinkId ? 1_000_000 : links.Streams(link).IntervalOf(messageId);
                sink.Send(link, new MessageInterval { MessageId = (ushort)messageId, IntervalUs = interval });
                return MavResult.Accepted;
            case MavCmd.RequestMessage:
                return Request(messageId, link);
            case MavCmd.GetHomePosition:
                return Request(HomePosition.MavlinkId, link);
            case MavCmd.RequestAutopilotCapabilities:
                return Request(AutopilotVersion.MavlinkId, link);
            default:
                return MavResult.Unsupported;
        }
    }

    private MavResult Request(int messageId, int link)
        => Px4Telemetry.IsKnown(messageId) && telemetry.TrySend(messageId, link)
            ? MavResult.Accepted
            : MavResult.Denied;
}
