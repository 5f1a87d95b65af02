using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// What Communications sends by itself: our position.
public sealed partial class CommunicationsManager
{
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly OwnPosition _position;

    private void SendPosition()
    {
        _vehicle.Fetch();
        OwnAddress own = _ownAddress.Value;
        if (own.IsKnown && _position.TryNext(_vehicle.Value, Now, out GlobalPositionInt message))
            SendPosition(MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0));
    }

    private void SendPosition(in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        ulong links = _router.RouteOwn(frame, message);
        foreach (LinkPort port in _ports)
        {
            if (!port.TakesPosition)
                links &= ~(1UL << port.Number);
        }

        SendOwn(links, frame, message.CrcExtra);
    }

    private void SendOwn(in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        SendOwn(_router.RouteOwn(frame, message), frame, message.CrcExtra);
    }
}
