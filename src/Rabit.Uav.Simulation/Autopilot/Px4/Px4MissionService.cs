using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The mission, the fence and the rally points, kept by the mission protocol's server as PX4 1.14 has it: an item that
/// it rejects ends the upload, item 0 of a mission is flown. Answers go where the request came from, the progress of
/// the mission to all links.
/// </summary>
internal sealed class Px4MissionService
{
    private const int MaxItems = 500;
    private const int MaxFenceItems = 100;
    private const int MaxRallyPoints = 8;
    private static readonly TimeSpan CurrentEvery = TimeSpan.FromSeconds(1);

    private static readonly MavlinkMissionServerOptions Options = new()
    {
        HandlesBroadcast = true,
        MaxItems = MaxItems,
        SendsIds = false,
    };

    private readonly Px4Fence _fence;
    private readonly ILinkSink _sink;
    private readonly OwnServer<MavlinkMissionServer> _server;
    private TimeSpan _currentDue;
    private int _uploadLink;

    /// <param name="fence">Takes the fence.</param>
    /// <param name="systemId">Of the autopilot.</param>
    /// <param name="sink">Takes what it sends.</param>
    public Px4MissionService(Px4Fence fence, Func<byte> systemId, ILinkSink sink)
    {
        (_fence, _sink) = (fence, sink);
        _server = new OwnServer<MavlinkMissionServer>(systemId, Create);
    }

    /// <summary>Called when another mission is stored, or there is none any more.</summary>
    public Action? MissionStored { get; set; }

    /// <summary>Called when a ground station made an item the current one.</summary>
    public Action<int>? CurrentSet { get; set; }

    /// <summary>How many items the mission has.</summary>
    public int Count => Server.Items(MavMissionType.Mission).Length;

    private MavlinkMissionServer Server => _server.Value;

    public MissionItemInt this[int sequence] => Server.Items(MavMissionType.Mission)[sequence];

    public void Handle(in MavlinkFrame frame, TimeSpan time, int link)
    {
        MavlinkMissionServer server = Server;
        bool wasUploading = server.IsUploading;
        server.Handle(frame, time);
        if (!wasUploading && server.IsUploading)
            _uploadLink = link;
        TakeChanges(server);
        Send(server, time, link);
    }

    /// <summary>Asks again for what does not come, and gives up at last.</summary>
    public void Step(TimeSpan time, bool isFlown)
    {
        MavlinkMissionServer server = Server;
        if (isFlown && time >= _currentDue)
        {
            _currentDue = time + CurrentEvery;
            server.ReportCurrent();
        }

        Send(server, time, _uploadLink);
    }

    /// <summary>Sends MISSION_CURRENT.</summary>
    public void ReportCurrent(TimeSpan time, int link)
    {
        Server.ReportCurrent();
        Send(Server, time, link);
    }

    /// <summary>Makes an item the current one; false where there is none of that number.</summary>
    public bool TrySetCurrent(int sequence) => Server.TrySetCurrent(sequence);

    public void Report(MissionState state)
    {
        Server.State = state;
        Server.ReportCurrent();
    }

    public void ReportReached(int sequence) => Server.ReportReached(sequence);

    /// <summary>Takes what was stored before a reboot.</summary>
    public void Restore(Px4MissionService before)
    {
        MissionService.CopyItems(before.Server, Server);
        _fence.TrySet(Server.Items(MavMissionType.Fence).ToArray());
    }

    private MavlinkMissionServer Create(MavlinkSender sender, MavlinkMissionServer? before)
    {
        var server = new MavlinkMissionServer(
            sender, new MissionRules(_fence.IsFence, MaxFenceItems, MaxRallyPoints), Options);
        if (before is not null)
            MissionService.CopyItems(before, server);
        return server;
    }

    private void TakeChanges(MavlinkMissionServer server)
    {
        while (server.TryTakeChange(out MavlinkMissionChange change))
        {
            if (change.Type == MavMissionType.Fence)
                _fence.TrySet(server.Items(MavMissionType.Fence).ToArray());
            else if (change.Type == MavMissionType.Mission)
                MissionStored?.Invoke();
        }

        if (server.TryTakeSetCurrent(out int sequence))
            CurrentSet?.Invoke(sequence);
    }

    private void Send(MavlinkMissionServer server, TimeSpan time, int link)
    {
        while (server.TryTakeFrame(time, out MavlinkFrame frame))
        {
            bool isProgress = frame.MessageId is MissionCurrent.MavlinkId or MissionItemReached.MavlinkId;
            for (int each = 0; each < _sink.LinkCount; each++)
            {
                if (each == link || isProgress)
                    _sink.SendNumbered(each, frame);
            }
        }
    }
}
