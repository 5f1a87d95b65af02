using System;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Has a mission, a fence and rally points, served by <see cref="MavlinkMissionServer"/>.</summary>
internal sealed class MissionServerVehicle : ScriptedVehicle
{
    private readonly MavlinkMissionServer _server;

    public MissionServerVehicle(MavlinkMissionServerOptions options)
        => _server = new MavlinkMissionServer(Sender, rules: null, options);

    public MavlinkMissionServer Server => _server;

    public override TimeSpan NextDue => _server.NextDue;

    public override void Handle(in MavlinkFrame frame, TimeSpan now) => _server.Handle(frame, now);

    public override void Tick(TimeSpan now)
    {
        while (_server.TryTakeFrame(now, out MavlinkFrame frame))
            Send(frame);
    }
}
