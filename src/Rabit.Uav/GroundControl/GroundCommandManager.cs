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
/// Receives the MAVLink commands that ground stations address to our component, gives them to Mission Control, and
/// acknowledges them by its answers. What is addressed to all components, or to the autopilot, is neither executed nor
/// acknowledged.
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
    private const int QueueCapacity = 64;

    // Answers of Mission Control come with its ticks.
    private static readonly TimeSpan TickPeriod = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan FrameValidity = TimeSpan.FromSeconds(2);

    private readonly IMissionOperator _mission;
    private readonly GroundCommandOptions _options;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueReceiver<LinkFrame> _frames;
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private readonly List<(int Handle, OperatorRequest Request)> _atWork = [];
    private MavlinkCommandServer? _server;

    /// <summary>Makes the manager.</summary>
    /// <param name="mission">Takes the commands.</param>
    /// <param name="options">Read now; later changes have no effect.</param>
    /// <exception cref="ArgumentNullException">One of them is null.</exception>
    public GroundCommandManager(IMissionOperator mission, GroundCommandOptions options)
        : base(ManagerName)
    {
        _mission = mission ?? throw new ArgumentNullException(nameof(mission));
        _options = (options ?? throw new ArgumentNullException(nameof(options))).Copy();
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _frames = Receive<LinkFrame>(Queue, QueueCapacity, QueueFullMode.DropOldest, wakeOnPush: true);
        _outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        WakeUpDelay = TickPeriod;
    }

    /// <summary>The frames that it needs, for <see cref="UavOptions.Subscriptions"/>.</summary>
    public static MavlinkSubscription CreateSubscription() => new(Queue)
    {
        MessageIds = [CommandLong.MavlinkId, CommandInt.MavlinkId, CommandCancel.MavlinkId],
    };

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        if (_server is null && _ownAddress.Fetch() && _ownAddress.Value.IsKnown)
            _server = new MavlinkCommandServer(
                new MavlinkSender(_ownAddress.Value.SystemId, _ownAddress.Value.ComponentId));
        while (_frames.TryPop(out LinkFrame frame))
            _server?.Handle(frame.Frame, Now);
        if (_server is not { } server)
            return;
        while (server.TryTakeRequest(out MavlinkCommandRequest request))
            Begin(server, request);
        Answer(server);
        while (server.TryTakeFrame(Now, out MavlinkFrame answer))
            _outgoing.Push(new OutgoingFrame { Frame = answer, ValidUntil = Now + FrameValidity });
    }

    private void Begin(MavlinkCommandServer server, in MavlinkCommandRequest request)
    {
        string by = FormattableString.Invariant(
            $"system {request.Source.SystemId} component {request.Source.ComponentId}");
        if (FindDenial(request) is { } denial)
        {
            Log($"{request.Command.Command} of {by} denied: {denial}");
            server.Complete(request.Handle, MavResult.Denied, Now);
        }
        else if (!GroundCommands.TryRead(request.Command, by, out OperatorRequest? command, out MavResult refusal))
        {
            Log($"{request.Command.Command} of {by}: {refusal}");
            server.Complete(request.Handle, refusal, Now);
        }
        else
        {
            _mission.Give(command!);
            _atWork.Add((request.Handle, command!));
        }
    }

    private string? FindDenial(in MavlinkCommandRequest request)
    {
        if (!_options.SystemIds.Contains(request.Source.SystemId))
            return "it may not command";
        return _options.OnlySigned && !request.IsSigned ? "it is not signed" : null;
    }

    private void Answer(MavlinkCommandServer server)
    {
        for (int i = 0; i < _atWork.Count; i++)
        {
            (int handle, OperatorRequest request) = _atWork[i];
            if (request.Outcome == OperatorOutcome.InProgress)
                continue;
            MavResult result = request.Outcome == OperatorOutcome.Accepted ? MavResult.Accepted : MavResult.Failed;
            server.Complete(handle, result, Now);
            _atWork.RemoveAt(i--);
        }
    }
}
