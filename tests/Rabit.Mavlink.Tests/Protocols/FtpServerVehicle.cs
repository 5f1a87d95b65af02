using System;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Has files, served by <see cref="MavlinkFtpServer"/>.</summary>
internal sealed class FtpServerVehicle : ScriptedVehicle
{
    public FtpServerVehicle() => Server = new MavlinkFtpServer(Sender, Files);

    public MavlinkMemoryFiles Files { get; } = new();

    public MavlinkFtpServer Server { get; }

    public override TimeSpan NextDue => Server.NextDue;

    public override void Handle(in MavlinkFrame frame, TimeSpan now) => Server.Handle(frame, now);

    public override void Tick(TimeSpan now)
    {
        while (Server.TryTakeFrame(now, out MavlinkFrame frame))
            Send(frame);
    }
}
