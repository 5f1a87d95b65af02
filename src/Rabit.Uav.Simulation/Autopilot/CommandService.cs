using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// COMMAND_LONG and COMMAND_INT by the command protocol's server, as autopilots do it: each copy is executed, at once.
/// </summary>
/// <param name="systemId">Of the autopilot.</param>
/// <param name="execute">Executes a command that came over a link.</param>
/// <param name="send">Sends a frame over a link.</param>
internal sealed class CommandService(
    Func<byte> systemId, Func<MavlinkCommandRequest, int, MavResult> execute, Action<int, MavlinkFrame> send)
{
    // They keep no record of what they have executed.
    private static readonly MavlinkCommandServerOptions Options = new()
    {
        HandlesBroadcast = true,
        RepeatTime = TimeSpan.Zero,
        ConfirmedRepeatTime = TimeSpan.Zero,
        Capacity = 4,
    };

    private readonly OwnServer<MavlinkCommandServer> _server =
        new(systemId, (sender, _) => new MavlinkCommandServer(sender, Options));

    public void Handle(in MavlinkFrame frame, TimeSpan time, int link = 0)
    {
        // The one that received it answers it: a command may change the system id.
        MavlinkCommandServer server = _server.Value;
        server.Handle(frame, time);
        while (server.TryTakeRequest(out MavlinkCommandRequest request))
            server.Complete(request.Handle, execute(request, link), time);
        while (server.TryTakeFrame(time, out MavlinkFrame answer))
            send(link, answer);
    }
}
