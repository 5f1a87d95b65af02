using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Stations;

/// <summary>
/// A ground station on a link of its own that does with the autopilot what stock ones do: lists its parameters, sets
/// one, uploads and downloads a mission, a fence and rally points, reads a file, pings, clears all.
/// </summary>
internal sealed class StationClient : RabitManager
{
    private static readonly MavlinkAddress Autopilot = new(1, 1);

    private readonly SimulatedAutopilot _autopilot;
    private readonly IByteLink _link;
    private readonly BlockingReader<LinkFrame> _reader;
    private readonly MavlinkParameterClient _parameters;
    private readonly MavlinkMissionClient _missions;
    private readonly MavlinkFtpClient _files;
    private readonly MavlinkPingClient _ping;
    private readonly MavlinkHeartbeatSender _heartbeats;
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];
    private readonly IEnumerator<bool> _work;

    public StationClient(byte systemId, SimulatedAutopilot autopilot, IByteLink link)
        : base("station " + systemId)
    {
        (_autopilot, _link) = (autopilot, link);
        _reader = AttachReader("link", new MavlinkLinkSource(link), 4096);
        var sender = new MavlinkSender(systemId, 190);
        _heartbeats = new MavlinkHeartbeatSender(
            sender, new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid, MavlinkVersion = 3 });
        _parameters = new MavlinkParameterClient(
            sender, Autopilot,
            autopilot == SimulatedAutopilot.Px4 ? MavlinkParameterEncoding.Bytewise : MavlinkParameterEncoding.CCast);
        _missions = new MavlinkMissionClient(sender, Autopilot);
        _files = new MavlinkFtpClient(sender, Autopilot);
        _ping = new MavlinkPingClient(sender, Autopilot, TimeSpan.FromSeconds(1));
        _work = Work().GetEnumerator();
        WakeUpDelay = TimeSpan.FromMilliseconds(10);
    }

    public bool IsDone { get; private set; }

    /// <summary>What it has done so far, and what came of it.</summary>
    public List<string> Results { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_reader.TryPop(out LinkFrame received))
        {
            _parameters.Handle(received.Frame, Now);
            _missions.Handle(received.Frame, Now);
            _files.Handle(received.Frame, Now);
            _ping.Handle(received.Frame, Now);
        }

        if (!IsDone)
            IsDone = !_work.MoveNext();
        while (_heartbeats.TryTakeFrame(Now, out MavlinkFrame frame) || _parameters.TryTakeFrame(Now, out frame)
            || _missions.TryTakeFrame(Now, out frame) || _files.TryTakeFrame(Now, out frame)
            || _ping.TryTakeFrame(Now, out frame))
            _link.Write(_buffer, 0, frame.WriteTo(_buffer));
    }

    private IEnumerable<bool> Work()
    {
        TimeSpan start = Now;
        while (Now < start + TimeSpan.FromSeconds(3))
            yield return false;   // the vehicle knows where it is
        _parameters.TryStartList(Now);
        MavlinkParameterOutcome listed;
        while (!_parameters.TryTakeOutcome(out listed))
            yield return false;
        Results.Add($"parameters {listed.Status} {_parameters.Parameters.Count}");

        (string name, MavParamType type) = _autopilot == SimulatedAutopilot.Px4
            ? ("RTL_RETURN_ALT", MavParamType.Real32)
            : ("RTL_ALT", MavParamType.Int32);
        _parameters.TryStartSet(name, type, 1800, Now);
        MavlinkParameterOutcome set;
        while (!_parameters.TryTakeOutcome(out set))
            yield return false;
        Results.Add($"set {set.Status}");

        foreach (MavMissionType kind in new[] { MavMissionType.Mission, MavMissionType.Fence, MavMissionType.Rally })
        {
            MissionItemInt[] items = ItemsOf(kind);
            MavlinkMissionOutcome outcome;
            int tries = 0;

            // What another station uploads meanwhile may end either.
            do
            {
                _missions.TryStartUpload(kind, items, Now);
                while (!_missions.TryTakeOutcome(out outcome))
                    yield return false;
            }
            while (outcome.Status != MavlinkMissionStatus.Done && ++tries < 20);
            Results.Add($"{kind} up {outcome.Status}");
            do
            {
                _missions.TryStartDownload(kind, Now);
                while (!_missions.TryTakeOutcome(out outcome))
                    yield return false;
            }
            while (outcome.Status != MavlinkMissionStatus.Done && ++tries < 20);
            bool isSame = _missions.Items.Length == items.Length;
            for (int i = kind == MavMissionType.Mission ? 1 : 0; isSame && i < items.Length; i++)
                isSame = (_missions.Items[i].X, _missions.Items[i].Command) == (items[i].X, items[i].Command);
            Results.Add($"{kind} down {outcome.Status} {(isSame ? "the same" : "others")}");
        }

        string? path = _autopilot == SimulatedAutopilot.Px4 ? null : "@PARAM/param.pck";
        if (path is null)
            _files.TryStartList("/", Now);
        else
            _files.TryStartRead(path, Now);
        MavlinkFtpOutcome file;
        while (!_files.TryTakeOutcome(out file))
            yield return false;
        Results.Add($"file {file.Status}");
        File = _files.Content.ToArray();
        Results.Add(_ping.Answers > 0 && _ping.RoundTrip < TimeSpan.FromMilliseconds(500) ? "ping" : "no ping");
    }

    /// <summary>The file that was read last.</summary>
    public byte[] File { get; private set; } = [];

    private static MissionItemInt[] ItemsOf(MavMissionType kind)
    {
        MavCmd command = kind switch
        {
            MavMissionType.Fence => MavCmd.NavFencePolygonVertexInclusion,
            MavMissionType.Rally => MavCmd.NavRallyPoint,
            _ => MavCmd.NavWaypoint,
        };
        return Enumerable.Range(0, 5).Select(i => new MissionItemInt
        {
            Command = command,
            Frame = kind == MavMissionType.Fence ? MavFrame.Global : MavFrame.GlobalRelativeAlt,
            Autocontinue = 1,
            Param1 = kind == MavMissionType.Fence ? 5 : 0,
            X = -353_632_620 + (int)(20_000 * Math.Cos(i * 1.2566)),
            Y = 1_491_652_370 + (int)(20_000 * Math.Sin(i * 1.2566)),
            Z = 30,
        }).ToArray();
    }
}
