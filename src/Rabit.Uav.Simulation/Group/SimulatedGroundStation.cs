using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.Linq;
using System.Threading;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A ground station of a simulated group: it stands at one place, receives the vehicles by radio, and sends the
/// operator's commands to one of them or to all, again where an answer is missing. The group works without any.
/// <see cref="Command"/> may be called and the properties read by any thread; the rest is done by that of the group.
/// </summary>
/// <example>
/// <code>
/// var group = new SimulatedGroup(new SimulatedGroupOptions { GroundStations = [new SimulatedStationPlace(0, 0)] });
/// StationCommand home = group.GroundStations[0].Command(systemId: 2, OperatorCommand.Return);
/// StationCommand pause = group.GroundStations[0].Command(systemId: 0, OperatorCommand.Hold);
/// // later: home.Answer is "accepted by 2", say
/// </code>
/// </example>
public sealed class SimulatedGroundStation
{
    /// <summary>The system id of the first one; each other one has the id before.</summary>
    internal const byte FirstSystemId = byte.MaxValue;

    private static readonly TimeSpan HeartbeatPeriod = TimeSpan.FromSeconds(1);

    private readonly IByteLink _link;
    private readonly MavlinkSender _sender;
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private readonly ConcurrentQueue<StationCommand> _given = new();
    private readonly List<StationExchange> _exchanges = [];
    private readonly byte[] _buffer = new byte[4096];
    private ImmutableArray<byte> _vehicles = [];
    private TimeSpan _nextHeartbeat;

    internal SimulatedGroundStation(byte systemId, IByteLink link)
    {
        (SystemId, _link) = (systemId, link);
        _sender = new MavlinkSender(systemId, (byte)MavComponent.Missionplanner);
    }

    /// <summary>Its MAVLink system id.</summary>
    public byte SystemId { get; }

    /// <summary>The system ids of the vehicles that it has ever received, in their order.</summary>
    public ImmutableArray<byte> Vehicles
        => ImmutableInterlocked.InterlockedCompareExchange(ref _vehicles, default, default);

    /// <summary>Takes each command that is done; on the thread of the group.</summary>
    public Action<TimeSpan, StationCommand>? OnDone { get; set; }

    /// <summary>
    /// Sends a command: each second until all have answered, ten times at most. One that could be mistaken for another
    /// one under way to the same vehicle waits for that.
    /// </summary>
    /// <param name="systemId">The vehicle; 0 for all.</param>
    /// <param name="command">
    /// Hold, continue, return, land, skip lane; revisit, confirm and reject, which are of one vehicle.
    /// </param>
    /// <param name="trackId">The track of the vehicle, for those that are about one.</param>
    /// <exception cref="ArgumentException">Another command, or a track that is missing or of all.</exception>
    public StationCommand Command(byte systemId, OperatorCommand command, int trackId = 0)
    {
        bool isOfTrack = command is OperatorCommand.Revisit or OperatorCommand.Confirm or OperatorCommand.Reject;
        if (!isOfTrack && command is not (OperatorCommand.Hold or OperatorCommand.Continue or OperatorCommand.Return
            or OperatorCommand.Land or OperatorCommand.SkipLane))
            throw new ArgumentException($"A simulated ground station does not send {command}.", nameof(command));
        if (isOfTrack && systemId == 0)
            throw new ArgumentException("Each vehicle numbers its tracks itself: say which vehicle.", nameof(systemId));
        if (isOfTrack ? trackId < 1 : trackId != 0)
            throw new ArgumentException(
                isOfTrack ? $"{command} needs a track, from 1 on." : $"{command} has no track.", nameof(trackId));
        var given = new StationCommand(systemId, command, trackId);
        _given.Enqueue(given);
        return given;
    }

    /// <summary>Takes what has arrived, and sends what is due.</summary>
    internal void Step(TimeSpan now)
    {
        while (_link.Read(_buffer) is { Kind: LinkReadKind.Bytes } read)
        {
            var bytes = new ReadOnlySpan<byte>(_buffer, 0, read.Count);
            while (_reader.TryRead(ref bytes, out MavlinkFrame frame, out _))
                Handle(frame, now);
        }

        while (_given.TryDequeue(out StationCommand? given))
            Begin(given, now);
        if (now >= _nextHeartbeat)
        {
            _nextHeartbeat = now + HeartbeatPeriod;
            Send(new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid, MavlinkVersion = 3 });
        }

        for (int i = 0; i < _exchanges.Count; i++)
        {
            StationExchange exchange = _exchanges[i];
            bool mayBegin = exchange.HasBegun || !_exchanges.Take(i).Any(e => e.IsSameKindAs(exchange));
            if (mayBegin && exchange.TryTake(now, out CommandLong message))
                Send(message);
            if (!exchange.IsDone)
                continue;
            _exchanges.RemoveAt(i--);
            OnDone?.Invoke(now, exchange.Command);
        }
    }

    private void Begin(StationCommand command, TimeSpan now)
    {
        ImmutableArray<byte> known = Vehicles;
        if (command.Target == 0 ? known.IsEmpty : !known.Contains(command.Target))
        {
            command.Refuse(known.IsEmpty
                ? "no vehicle was received yet"
                : $"there is no vehicle {Number(command.Target)}; received were "
                    + string.Join(", ", known.Select(Number)));
            OnDone?.Invoke(now, command);
            return;
        }

        _exchanges.Add(new StationExchange(
            command, command.Target == 0 ? known : [command.Target], (byte)MavComponent.OnboardComputer));
    }

    private void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.ComponentId != (byte)MavComponent.OnboardComputer)
            return;
        if (frame.MessageId == Heartbeat.MavlinkId && !_vehicles.Contains(frame.SystemId))
        {
            ImmutableArray<byte> all = [.. _vehicles.Add(frame.SystemId).OrderBy(id => id)];
            ImmutableInterlocked.InterlockedExchange(ref _vehicles, all);
        }
        else if (frame.MessageId == CommandAck.MavlinkId && frame.TryDecode(out CommandAck answer)
            && answer.TargetSystem == SystemId)
        {
            foreach (StationExchange exchange in _exchanges)
                exchange.Handle(frame.SystemId, answer, now);
        }
    }

    private void Send<T>(in T message)
        where T : struct, IMavlinkMessage
        => _link.Write(_buffer, 0, _sender.Create(message).WriteTo(_buffer));

    private static string Number(byte id) => id.ToString(CultureInfo.InvariantCulture);
}
