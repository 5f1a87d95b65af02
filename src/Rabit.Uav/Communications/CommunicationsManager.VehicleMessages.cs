using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// What Communications says by itself: where we are, and mail for other vehicles.
public sealed partial class CommunicationsManager
{
    // Senders push all they saw in one picture at once.
    private const int MailWaiting = 256;

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly OwnPosition _position;
    private readonly VehicleMessageChannel[] _mail;

    /// <summary>What became of the mail, type by type in the order of the routes. Any thread.</summary>
    public IReadOnlyList<VehicleMessageCounters> CountVehicleMessages() => _mail.Select(m => m.Counts).ToArray();

    internal QueueReceiver<Envelope<T>> ReceiveMail<T>(string queue)
        where T : struct
        => Receive<Envelope<T>>(queue, MailWaiting, QueueFullMode.DropOldest);

    internal QueueSender<T> SendMail<T>(string queue)
        where T : struct
        => Send<T>(queue);

    private void SendPosition()
    {
        _vehicle.Fetch();
        OwnAddress own = _ownAddress.Value;
        if (own.IsKnown && _position.TryNext(_vehicle.Value, Now, out GlobalPositionInt message))
            SendOwn(MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0));
    }

    private void SendOwn(in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        MavlinkFrame numbered = Numbered(frame, message);
        SendOwn(_router.RouteOwn(numbered, message), numbered, message.CrcExtra);
    }

    private void SendMail()
    {
        OwnAddress own = _ownAddress.Value;
        foreach (VehicleMessageChannel slot in _mail)
        {
            while (slot.TryTake(Now, out Tunnel? tunnel))
            {
                if (tunnel is not { } letter)
                    continue;
                if (own.IsKnown)
                    SendMail(slot, MavlinkFrame.Create(letter, own.SystemId, own.ComponentId, sequence: 0));
                else
                    slot.CountUnsendable();
            }
        }
    }

    // A number is taken only for a frame that goes out: a gap would look like a loss to whoever counts.
    private void SendMail(VehicleMessageChannel slot, in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        ulong links = _router.RouteOwn(frame, message);
        if (links == 0)
            slot.CountUnsendable();

        MavlinkFrame? numbered = null;
        foreach (LinkPort port in _ports)
        {
            if ((links & (1UL << port.Number)) == 0)
                continue;
            if (!port.HasMailBudget(frame, Now))
            {
                slot.CountOverBudget();
                continue;
            }

            numbered ??= Numbered(frame, message);
            Send(port, numbered.Value, message.CrcExtra);
            slot.CountSent();
        }
    }

    /// <returns>Whether it is mail of a type that has a route: that is no business of the autopilot's.</returns>
    private bool IsMail(in LinkFrame frame)
    {
        MavlinkFrame mavlink = frame.Frame;
        if (_mail.Length == 0 || mavlink.MessageId != Tunnel.MavlinkId)
            return false;
        mavlink.TryDecode(out Tunnel tunnel);
        foreach (VehicleMessageChannel slot in _mail)
        {
            if (slot.PayloadType != (int)tunnel.PayloadType)
                continue;
            slot.Take(mavlink, tunnel, _ownAddress.Value.SystemId, frame.Time);
            return true;
        }

        return false;
    }
}
