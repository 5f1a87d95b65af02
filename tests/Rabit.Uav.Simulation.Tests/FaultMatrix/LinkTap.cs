using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>
/// Around the companion's end of the link: notes the commands that go out and the modes that are reported, sends what a
/// ground station would send over the same link, and holds back what a test wants to be lost.
/// </summary>
internal sealed class LinkTap(IByteLink link, Func<TimeSpan> now) : WrappedLink(link)
{
    private readonly MavlinkFrameReader _out = new(MavlinkDialect.All);
    private readonly MavlinkFrameReader _in = new(MavlinkDialect.All);
    private readonly byte[] _frame = new byte[MavlinkFrame.MaxWireLength];
    private byte _sequence;

    /// <summary>Everything that moves the vehicle or changes its mode, by when it was sent.</summary>
    public List<SentCommand> Sent { get; } = [];

    /// <summary>Every report of the autopilot's mode, by when it was received.</summary>
    public List<(TimeSpan Time, uint Mode)> Reports { get; } = [];

    /// <summary>Whether the messages about the battery are held back.</summary>
    public bool HidesBattery { get; set; }

    /// <summary>Until when the heartbeats of the ground station are held back.</summary>
    public TimeSpan HidesGroundStationUntil { get; set; }

    public override LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        LinkRead read = Inner.Read(buffer, timeoutMilliseconds);
        if (read.Kind is LinkReadKind.NothingYet or LinkReadKind.Ended)
            return read;
        var bytes = new ReadOnlySpan<byte>(buffer, 0, read.Count);
        int kept = 0;
        bool isWhole = true;
        while (bytes.Length > 0 && isWhole)
        {
            int before = bytes.Length;
            int start = read.Count - before;
            isWhole = _in.TryRead(ref bytes, out MavlinkFrame frame, out _);
            int length = before - bytes.Length;
            if (isWhole)
                Note(frame);
            if (HidesBattery && isWhole && frame.MessageId is SysStatus.MavlinkId or BatteryStatus.MavlinkId)
                continue;
            if (isWhole && now() < HidesGroundStationUntil && frame is
                { MessageId: Heartbeat.MavlinkId, SystemId: Ground.SystemId, ComponentId: Ground.ComponentId })
                continue;
            Buffer.BlockCopy(buffer, start, buffer, kept, length);
            kept += length;
        }

        return kept == read.Count ? read : kept == 0 ? LinkRead.NothingYet : LinkRead.Bytes(kept);
    }

    public override void Write(byte[] buffer, int offset, int count)
    {
        var bytes = new ReadOnlySpan<byte>(buffer, offset, count);
        while (_out.TryRead(ref bytes, out MavlinkFrame frame, out _))
        {
            if (SentCommand.Of(frame, now()) is { } command)
                Sent.Add(command);
        }

        Inner.Write(buffer, offset, count);
    }

    /// <summary>Sends as the ground station 255/190.</summary>
    public void SendAsGroundStation<T>(in T message)
        where T : struct, IMavlinkMessage
    {
        int length = MavlinkFrame.Create(message, Ground.SystemId, Ground.ComponentId, _sequence++).WriteTo(_frame);
        Inner.Write(_frame, 0, length);
    }

    private void Note(in MavlinkFrame frame)
    {
        if (frame.TryDecode(out Heartbeat heartbeat) && heartbeat.Autopilot != MavAutopilot.Invalid)
            Reports.Add((now(), heartbeat.CustomMode));
    }
}
