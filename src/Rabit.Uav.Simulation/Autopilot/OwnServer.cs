using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A protocol server whose frames carry the autopilot's system id, which is a parameter: made again when that changes.
/// </summary>
/// <param name="systemId">The system id as it stands.</param>
/// <param name="create">Makes a server, from the one before; null at first.</param>
internal sealed class OwnServer<T>(Func<byte> systemId, Func<MavlinkSender, T?, T> create)
    where T : class
{
    private T? _server;
    private byte _systemId;

    public T Value
    {
        get
        {
            byte now = systemId();
            if (_server is null || now != _systemId)
            {
                _systemId = now;
                _server = create(new MavlinkSender(now, AutopilotAddress.ComponentId), _server);
            }

            return _server;
        }
    }
}
