using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What ground stations ask beside parameters, missions and commands: PING, files by MAVLink FTP, the list of logs,
/// which is empty.
/// </summary>
/// <param name="systemId">Of the autopilot.</param>
/// <param name="files">What it serves.</param>
/// <param name="send">Sends a frame over a link.</param>
internal sealed class StationService(Func<byte> systemId, IMavlinkFileStore files, Action<int, MavlinkFrame> send)
{
    private readonly OwnServer<MavlinkFtpServer> _files =
        new(systemId, (sender, _) => new MavlinkFtpServer(sender, files));

    private readonly OwnServer<MavlinkPingClient> _ping =
        new(systemId, (sender, _) => new MavlinkPingClient(sender));

    private int _fileLink;

    /// <summary>Whether the message is one of these, and has been handled.</summary>
    public bool TryHandle(in MavlinkFrame frame, TimeSpan time, int link = 0)
    {
        switch (frame.MessageId)
        {
            case Ping.MavlinkId:
                _ping.Value.Handle(frame, time);
                while (_ping.Value.TryTakeFrame(time, out MavlinkFrame answer))
                    send(link, answer);
                return true;
            case FileTransferProtocol.MavlinkId:
                _fileLink = link;
                _files.Value.Handle(frame, time);
                Step(time);
                return true;
            case LogRequestList.MavlinkId:
                send(link, MavlinkFrame.Create(default(LogEntry), systemId(), AutopilotAddress.ComponentId, 0));
                return true;
            default:
                return false;
        }
    }

    /// <summary>Goes on with the files.</summary>
    public void Step(TimeSpan time)
    {
        while (_files.Value.TryTakeFrame(time, out MavlinkFrame frame))
            send(_fileLink, frame);
    }
}
