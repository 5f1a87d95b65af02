using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The mission, the fence and the rally points, kept by the mission protocol's server as ArduPilot has it: it asks for
/// one item after the other by MISSION_REQUEST, an item that it rejects does not end the transfer, and what was there
/// stays until the new one is complete. Item 0 of a mission is home.
/// </summary>
internal sealed class MissionService(
    WorldFrame frame, AutopilotAddress address, TelemetrySender telemetry, IFrameSink sink)
{
    private const double DegE7PerRadian = 1e7 / NedMath.RadiansPerDegree;

    // ArduCopter's for a mission on a simulated board; a fence may have fewer.
    private const int MaxItems = 724;
    private const int MaxFenceItems = 84;
    private static readonly TimeSpan CurrentEvery = TimeSpan.FromSeconds(1);

    private static readonly MavlinkMissionServerOptions Options = new()
    {
        BehavesAsArduPilot = true,
        HandlesBroadcast = true,
        MaxItems = MaxItems,
        RequestInterval = TimeSpan.FromSeconds(1),
        SendsIds = false,
        Timeout = TimeSpan.FromSeconds(8),
    };

    private readonly OwnServer<MavlinkMissionServer> _server =
        new(() => address.SystemId, (sender, before) => Create(sender, frame, before));

    private TimeSpan _currentDue;

    /// <summary>Called when another fence is stored: its shapes, and how many items it has.</summary>
    public Action<FenceShapes, int>? FenceStored { get; set; }

    /// <summary>Called when another mission is stored.</summary>
    public Action? MissionStored { get; set; }

    /// <summary>Called when a ground station made an item the current one.</summary>
    public Action<int>? CurrentSet { get; set; }

    /// <summary>How many items the mission has, with home.</summary>
    public int Count => Server.Items(MavMissionType.Mission).Length;

    public MissionItemInt this[int sequence] => Server.Items(MavMissionType.Mission)[sequence];

    private MavlinkMissionServer Server => _server.Value;

    public void Handle(in MavlinkFrame message, TimeSpan time)
    {
        Server.Handle(message, time);
        TakeChanges();
        Send(time);
    }

    /// <summary>Asks again for what does not come, and gives up at last.</summary>
    public void Step(TimeSpan time, bool isFlown)
    {
        if (isFlown && time >= _currentDue)
        {
            _currentDue = time + CurrentEvery;
            Server.ReportCurrent();
        }

        Send(time);
    }

    /// <summary>Sends MISSION_CURRENT.</summary>
    public void ReportCurrent(TimeSpan time)
    {
        Server.ReportCurrent();
        Send(time);
    }

    /// <summary>Makes an item the current one; false where there is none of that number.</summary>
    public bool TrySetCurrent(int sequence) => Server.TrySetCurrent(sequence);

    public void Report(MissionState state) => Server.State = state;

    public void ReportReached(int sequence) => Server.ReportReached(sequence);

    /// <summary>Takes what was stored before a reboot.</summary>
    public void Restore(MissionService before)
    {
        CopyItems(before.Server, Server);
        UseFence();
    }

    private static MavlinkMissionServer Create(MavlinkSender sender, WorldFrame frame, MavlinkMissionServer? before)
    {
        var rules = new MissionRules(i => FenceShapes.TryCreate(i, frame, out _), MaxFenceItems, MaxItems);
        var server = new MavlinkMissionServer(sender, rules, Options);
        if (before is not null)
            CopyItems(before, server);
        return server;
    }

    /// <summary>Stores all that another one has.</summary>
    public static void CopyItems(MavlinkMissionServer from, MavlinkMissionServer to)
    {
        foreach (MavMissionType type in new[] { MavMissionType.Mission, MavMissionType.Fence, MavMissionType.Rally })
            to.Store(type, from.Items(type));
    }

    private void TakeChanges()
    {
        while (Server.TryTakeChange(out MavlinkMissionChange change))
        {
            if (change.Type == MavMissionType.Fence)
                UseFence();
            if (change.Type != MavMissionType.Mission)
                continue;
            StoreHome();
            MissionStored?.Invoke();
        }

        if (Server.TryTakeSetCurrent(out int sequence))
            CurrentSet?.Invoke(sequence);
    }

    private void UseFence()
    {
        MissionItemInt[] items = Server.Items(MavMissionType.Fence).ToArray();
        if (FenceShapes.TryCreate(items, frame, out FenceShapes shapes))
            FenceStored?.Invoke(shapes, items.Length);
    }

    // Item 0 comes back as the autopilot knows home, not as sent.
    private void StoreHome()
    {
        MissionItemInt[] items = Server.Items(MavMissionType.Mission).ToArray();
        if (items.Length == 0 || telemetry.Home is not { } home)
            return;
        GeodeticPosition place = frame.ToPlace(home);
        items[0] = new MissionItemInt
        {
            Command = MavCmd.NavWaypoint,
            Frame = MavFrame.Global,
            Autocontinue = 1,
            X = (int)Math.Round(place.Latitude.Radians * DegE7PerRadian),
            Y = (int)Math.Round(place.Longitude.Radians * DegE7PerRadian),
            Z = (float)place.AltitudeAmslMetres,
        };
        Server.Store(MavMissionType.Mission, items);
    }

    private void Send(TimeSpan time)
    {
        while (Server.TryTakeFrame(time, out MavlinkFrame next))
            sink.SendNumbered(next);
    }
}
