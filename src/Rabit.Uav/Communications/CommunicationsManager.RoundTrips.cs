using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// PING: that of others is answered, and our own measures the links whose budget follows their round trip.
public sealed partial class CommunicationsManager
{
    // In one unit of work: a flood of requests gets no flood of answers.
    private const int MaxPingAnswers = 4;

    private int _pingAnswers;

    private void SendPings()
    {
        _pingAnswers = 0;
        OwnAddress own = _ownAddress.Value;
        foreach (LinkPort port in _ports)
        {
            if (own.IsKnown && port.Scheduler?.Probe is { } probe && probe.TryNext(Now, out Ping request))
                SendPing(request, own, 1UL << port.Number);
        }
    }

    private void TakePing(LinkPort port, in LinkFrame frame)
    {
        OwnAddress own = _ownAddress.Value;
        bool isPing = frame.IsChecked && frame.Frame.MessageId == Ping.MavlinkId && !port.IsRecorded && own.IsKnown;
        if (!isPing || !frame.Frame.TryDecode(out Ping ping))
            return;
        bool isRequest = ping.TargetSystem == 0 && ping.TargetComponent == 0;
        bool isOwn = frame.Frame.SystemId == own.SystemId && frame.Frame.ComponentId == own.ComponentId;
        if (isRequest && !isOwn && _pingAnswers++ < MaxPingAnswers)
        {
            (ping.TargetSystem, ping.TargetComponent) = (frame.Frame.SystemId, frame.Frame.ComponentId);
            SendPing(ping, own, 1UL << port.Number);
        }
        else if (ping.TargetSystem == own.SystemId && ping.TargetComponent == own.ComponentId)
        {
            port.Scheduler?.TakePing(ping, frame.Time);
        }
    }

    private void SendPing(in Ping ping, OwnAddress own, ulong link)
    {
        MavlinkFrame frame = MavlinkFrame.Create(ping, own.SystemId, own.ComponentId, sequence: 0);
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        SendOwn(link, frame, message.CrcExtra);
    }
}
