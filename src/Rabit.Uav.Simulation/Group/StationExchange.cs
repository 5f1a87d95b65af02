using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// One command of a simulated ground station under way: sent again each second until all have answered that it is for,
/// ten times at most. A command to all is one frame, to system 0. One thread.
/// </summary>
internal sealed class StationExchange
{
    private const byte MaxTries = 10;

    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    // A vehicle that is at work on it says so twice a second.
    private static readonly TimeSpan MaxWork = TimeSpan.FromSeconds(30);

    private readonly SortedDictionary<byte, MavResult?> _answers = [];
    private readonly CommandLong _message;
    private byte _tries;
    private TimeSpan _begun;
    private TimeSpan _due;
    private TimeSpan? _atWork;

    /// <param name="command">Gets the answers.</param>
    /// <param name="vehicles">Who is to answer.</param>
    /// <param name="component">The component of the vehicles that it is for.</param>
    public StationExchange(StationCommand command, IEnumerable<byte> vehicles, byte component)
    {
        Command = command;
        _message = MessageOf(command) with { TargetSystem = command.Target, TargetComponent = component };
        foreach (byte id in vehicles)
            _answers.Add(id, null);
        Set();
    }

    public StationCommand Command { get; }

    public bool IsDone { get; private set; }

    public bool HasBegun => _tries > 0;

    /// <summary>Whether an acknowledgement could be for either: it does not say which one it is for.</summary>
    public bool IsSameKindAs(StationExchange other) => _message.Command == other._message.Command
        && (Command.Target == 0 || other.Command.Target == 0 || Command.Target == other.Command.Target);

    public void Handle(byte from, in CommandAck answer, TimeSpan now)
    {
        bool isForIt = HasBegun && !IsDone && answer.Command == _message.Command
            && (Command.Target == 0 || Command.Target == from);
        if (!isForIt || answer.Result == MavResult.TemporarilyRejected)
            return;
        if (answer.Result == MavResult.InProgress)
        {
            _atWork = now;
            return;
        }

        _answers[from] = answer.Result;
        IsDone = _answers.Values.All(r => r is not null);
        Set();
    }

    /// <summary>Takes the next sending, where it is due.</summary>
    public bool TryTake(TimeSpan now, out CommandLong message)
    {
        message = _message;
        if (IsDone || (HasBegun && now < _due))
            return false;
        if (!HasBegun)
            _begun = now;
        bool isAtWork = now - _atWork < Period && now - _begun < MaxWork;
        if (_tries >= MaxTries && !isAtWork)
        {
            IsDone = true;
            Set();
            return false;
        }

        message.Confirmation = _tries;
        _tries = (byte)Math.Min(byte.MaxValue, _tries + 1);
        _due = now + Period;
        return true;
    }

    private static CommandLong MessageOf(StationCommand command) => command.Command switch
    {
        OperatorCommand.Hold => new CommandLong { Command = MavCmd.DoPauseContinue, Param1 = 0 },
        OperatorCommand.Continue => new CommandLong { Command = MavCmd.DoPauseContinue, Param1 = 1 },
        OperatorCommand.Return => new CommandLong { Command = MavCmd.NavReturnToLaunch },
        OperatorCommand.Land => new CommandLong { Command = MavCmd.NavLand },
        OperatorCommand.SkipLane => new CommandLong { Command = MavCmd.User1, Param1 = 1 },
        OperatorCommand.Revisit => new CommandLong { Command = MavCmd.User1, Param1 = 2, Param2 = command.TrackId },
        OperatorCommand.Confirm => new CommandLong { Command = MavCmd.User1, Param1 = 3, Param2 = command.TrackId },
        OperatorCommand.Reject => new CommandLong { Command = MavCmd.User1, Param1 = 4, Param2 = command.TrackId },
        _ => throw new InvalidOperationException($"A simulated ground station does not send {command.Command}."),
    };

    private void Set() => Command.Set(_answers.Select(a => new StationAnswer(a.Key, a.Value)), IsDone);
}
