using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.GroundControl;

/// <summary>
/// Receives what ground stations address to our component, gives it to Mission Control, and answers by its answers:
/// commands, the values of the mission as parameters, a fence as another area to search, image chips of targets as
/// files (docs/ground-stations.md). A command to our component of all systems (system 0) is ours too. What is addressed
/// to all components, or to the autopilot, is neither executed nor acknowledged; a list of parameters that is asked of
/// all is sent.
/// </summary>
/// <example>
/// <code>
/// options.GroundCommands = new GroundCommandOptions { SystemIds = [255] };
/// using UavSystem uav = UavSystem.Open(options);
/// </code>
/// </example>
public sealed class GroundCommandManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "ground commands";

    private const string Queue = "ground commands";
    private const int QueueCapacity = 256;

    // Answers of Mission Control come with its ticks.
    private static readonly TimeSpan TickPeriod = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan FrameValidity = TimeSpan.FromSeconds(2);

    private static readonly MavlinkCommandServerOptions CommandOptions = new() { HandlesAllSystems = true };

    private readonly IMissionOperator _mission;
    private readonly Authority _authority;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueReceiver<LinkFrame> _frames;
    // What finds no room is counted by the queue, and shown; each protocol sends again what is not answered.
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private readonly List<(int Handle, OperatorRequest Request)> _atWork = [];
    private readonly StatusTextChunks _texts = new();
    private readonly Func<long, int, byte[]?>? _picture;
    private readonly MessageSubscriber<TrackList>? _tracks;
    private readonly MessageSubscriber<VehicleState>? _vehicle;
    private readonly MessageSubscriber<AutopilotFence>? _fence;
    private readonly AutopilotFenceOffer _fenceOffer;
    private Servers? _servers;

    /// <summary>Makes the manager.</summary>
    /// <param name="mission">Takes the commands.</param>
    /// <param name="options">Read now; later changes have no effect.</param>
    /// <exception cref="ArgumentNullException">One of them is null.</exception>
    public GroundCommandManager(IMissionOperator mission, GroundCommandOptions options)
        : this(mission, options, null)
    {
    }

    /// <param name="mission">Takes the commands.</param>
    /// <param name="options">Read now.</param>
    /// <param name="picture">The image chips, as <see cref="TargetFiles"/> takes them; null without any.</param>
    internal GroundCommandManager(
        IMissionOperator mission, GroundCommandOptions options, Func<long, int, byte[]?>? picture)
        : base(ManagerName)
    {
        _picture = picture;
        if (picture is not null)
        {
            _tracks = Subscribe<TrackList>(MessageNames.Tracks);
            _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        }

        _mission = mission ?? throw new ArgumentNullException(nameof(mission));
        _authority = new Authority((options ?? throw new ArgumentNullException(nameof(options))).Copy());
        _fenceOffer = new AutopilotFenceOffer(_mission, Announce);
        if (options.OffersAutopilotFence)
            _fence = Subscribe<AutopilotFence>(MessageNames.AutopilotFence);
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _frames = Receive<LinkFrame>(Queue, QueueCapacity, QueueFullMode.DropOldest, wakeOnPush: true);
        _outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        WakeUpDelay = TickPeriod;
    }

    /// <summary>The frames that it needs, for <see cref="UavOptions.Subscriptions"/>.</summary>
    public static MavlinkSubscription CreateSubscription() => new(Queue)
    {
        MessageIds =
        [
            CommandLong.MavlinkId, CommandInt.MavlinkId, CommandCancel.MavlinkId, .. GroundParameters.MessageIds,
            .. GroundAreas.MessageIds, FileTransferProtocol.MavlinkId, Ping.MavlinkId,
        ],
    };

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        if (_servers is null && _ownAddress.Fetch() && _ownAddress.Value.IsKnown)
        {
            var sender = new MavlinkSender(_ownAddress.Value.SystemId, _ownAddress.Value.ComponentId);
            _servers = new Servers(
                sender, new MavlinkCommandServer(sender, CommandOptions),
                new GroundParameters(_mission, _authority, sender),
                new GroundAreas(_mission, _authority, sender, Announce),
                _picture is null ? null : new TargetFiles(sender, _picture), new MavlinkPingClient(sender));
        }

        while (_frames.TryPop(out LinkFrame frame))
            _servers?.Handle(frame.Frame, Now);
        if (_servers is not { } servers)
            return;
        while (servers.Commands.TryTakeRequest(out MavlinkCommandRequest request))
            Begin(servers, request);
        Answer(servers.Commands);
        servers.Parameters.Update(Now);
        servers.Areas.Update(Now);
        UpdateFiles(servers);
        if (_fence?.Fetch() == true)
            _fenceOffer.Take(_fence.Value, servers.Areas.Offers);
        _fenceOffer.Update();
        while (servers.TryTakeFrame(Now, out MavlinkFrame answer))
            Send(answer);
    }

    private void UpdateFiles(Servers servers)
    {
        if (servers.Files is null || !_tracks!.Fetch())
            return;
        _vehicle!.Fetch();
        servers.Files.Update(_tracks.Value, _vehicle.Value, Now);
    }

    private void Begin(Servers servers, in MavlinkCommandRequest request)
    {
        string by = Authority.NameOf(request.Source);
        MavlinkCommandServer server = servers.Commands;
        if (OwnVersion.IsWanted(request.Command.Command, request.Command.Param1))
        {
            // What we serve is no secret.
            server.Complete(request.Handle, MavResult.Accepted, Now);
            Send(servers.Sender.Create(OwnVersion.Create(servesFiles: servers.Files is not null)));
        }
        else if (_authority.FindDenial(request.Source, request.IsSigned) is { } denial)
        {
            Log($"{MavlinkNames.Of(request.Command.Command)} of {by} denied: {denial}");
            server.Complete(request.Handle, MavResult.Denied, Now);
        }
        else if (!GroundCommands.TryRead(request.Command, by, out OperatorRequest? command, out MavResult refusal))
        {
            Log($"{MavlinkNames.Of(request.Command.Command)} of {by}: {MavlinkNames.Of(refusal)}");
            server.Complete(request.Handle, refusal, Now);
        }
        else
        {
            _mission.Give(command!);
            _atWork.Add((request.Handle, command!));
        }
    }

    private void Answer(MavlinkCommandServer server)
    {
        for (int i = 0; i < _atWork.Count; i++)
        {
            (int handle, OperatorRequest request) = _atWork[i];
            if (request.Outcome == OperatorOutcome.InProgress)
                continue;
            bool isAccepted = request.Outcome == OperatorOutcome.Accepted;
            server.Complete(handle, isAccepted ? MavResult.Accepted : MavResult.Failed, Now);
            if (!isAccepted)
                Announce($"{request.Name} refused: {request.Answer}");
            _atWork.RemoveAt(i--);
        }
    }

    // An acknowledgement has no room for the reason.
    private void Announce(string text)
    {
        Log(text);
        foreach (Statustext part in _texts.Of("Rabit: " + text, MavSeverity.Warning))
            Send(_servers!.Sender.Create(part));
    }

    private void Send(in MavlinkFrame frame)
        => _ = _outgoing.Push(new OutgoingFrame { Frame = frame, ValidUntil = Now + FrameValidity });

    private sealed record Servers(
        MavlinkSender Sender, MavlinkCommandServer Commands, GroundParameters Parameters, GroundAreas Areas,
        TargetFiles? Files, MavlinkPingClient Ping)
    {
        public void Handle(in MavlinkFrame frame, TimeSpan now)
        {
            Commands.Handle(frame, now);
            Parameters.Handle(frame, now);
            Files?.Handle(frame, now);
            Ping.Handle(frame, now);

            // What the autopilot sends us of missions belongs to a transfer that we asked it for.
            if (frame.SystemId != Sender.SystemId || frame.ComponentId != (byte)MavComponent.Autopilot1)
                Areas.Handle(frame, now);
        }

        public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
            => Commands.TryTakeFrame(now, out frame) || Parameters.TryTakeFrame(now, out frame)
                || Areas.TryTakeFrame(now, out frame) || Ping.TryTakeFrame(now, out frame)
                || (Files?.TryTakeFrame(now, out frame) ?? false);
    }
}
