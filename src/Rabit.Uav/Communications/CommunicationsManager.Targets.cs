using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// What Communications sends of the targets, for the maps of ground stations.
public sealed partial class CommunicationsManager
{
    private readonly MessageSubscriber<TrackList>? _tracks;
    private readonly TargetTelemetry _targets = new();

    private void SendTargets()
    {
        OwnAddress own = _ownAddress.Value;
        if (_tracks is null || !own.IsKnown)
            return;
        _tracks.Fetch();
        if (!_targets.TryNext(_tracks.Value, Now))
            return;
        SendOwn(MavlinkFrame.Create(_targets.GeoStatus(), own.SystemId, own.ComponentId, sequence: 0));
        foreach (Statustext text in _targets.Texts())
            SendOwn(MavlinkFrame.Create(text, own.SystemId, own.ComponentId, sequence: 0));
        if (_options.SendsTargetsAsTraffic)
            SendToGroundStations(_targets.Traffic(own.SystemId, Now), own);
    }

    // An autopilot would evade what it takes for traffic.
    private void SendToGroundStations(in AdsbVehicle traffic, OwnAddress own)
    {
        MavlinkFrame frame = MavlinkFrame.Create(traffic, own.SystemId, own.ComponentId, sequence: 0);
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        SendOwn(LinksToGroundStations(), frame, message.CrcExtra);
    }
}
