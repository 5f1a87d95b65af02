using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// PING measures the links whose budget follows their round trip. That of others Ground Control answers.
public sealed partial class CommunicationsManager
{
    private void SendPings()
    {
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
        if (port.Scheduler?.Probe is null || !frame.IsChecked || !frame.Frame.TryDecode(out Ping ping))
            return;
        if (own.IsKnown && ping.TargetSystem == own.SystemId && ping.TargetComponent == own.ComponentId)
            port.Scheduler.TakePing(ping, frame.Time);
    }

    private void SendPing(in Ping ping, OwnAddress own, ulong link)
    {
        MavlinkFrame frame = MavlinkFrame.Create(ping, own.SystemId, own.ComponentId, sequence: 0);
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        SendOwn(link, frame, message.CrcExtra);
    }
}
