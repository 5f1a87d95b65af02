using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Sends commands and finds out what became of them (MAVLink guide, "Command Protocol"): several at once, each with exactly one outcome, whatever
/// the link loses, doubles or turns round. No I/O, no clock: frames in, frames out, time as argument. One thread; nothing is allocated per frame or command.
/// </summary>
/// <remarks>
/// An acknowledgement is matched by command, sender and addressee. It does not say which sending of a command it is for; so two commands of the same kind
/// to the same component are never under way together, and the second waits until late answers to the first are out of the way
/// (<see cref="MavlinkCommandOptions.LateAnswerTime"/>).
/// </remarks>
/// <example>
/// <code>
/// client.TryStart(MavlinkCommand.Create(vehicle, MavCmd.ComponentArmDisarm, 1), out int handle);
/// // for every frame that comes in:          client.Handle(frame, now);
/// // after that, and at client.NextDue:      while (client.TryTakeFrame(now, out MavlinkFrame frame)) Send(frame);
/// //                                         while (client.TryTakeOutcome(out MavlinkCommandOutcome outcome)) ...
/// </code>
/// </example>
public sealed class MavlinkCommandClient
{
    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _own;
    private readonly CommandExchange[] _exchanges;
    private int _lastHandle;

    /// <summary>Makes a client.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="options">How patient it is; null for the usual.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The capacity is below 1.</exception>
    public MavlinkCommandClient(MavlinkSender sender, MavlinkCommandOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        options ??= new MavlinkCommandOptions();
        if (options.Capacity < 1)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, "The capacity is at least 1.");
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _exchanges = new CommandExchange[options.Capacity];
        for (int i = 0; i < _exchanges.Length; i++)
            _exchanges[i] = new CommandExchange(options);
    }

    /// <summary>Acknowledgements for us that no open command was waiting for: late ones, and copies.</summary>
    public long StrayAnswers { get; private set; }

    /// <summary>When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to wait for. A time in the past means now.</summary>
    public TimeSpan NextDue
    {
        get
        {
            TimeSpan next = TimeSpan.MaxValue;
            foreach (CommandExchange exchange in _exchanges)
            {
                TimeSpan due = exchange.IsOpen ? exchange.Due
                    : exchange.Phase == CommandPhase.Queued ? BeginOf(exchange)
                    : TimeSpan.MaxValue;
                if (due < next)
                    next = due;
            }

            return next;
        }
    }

    /// <summary>Takes a command. It goes out with the next <see cref="TryTakeFrame"/>, or later where one like it is not done with.</summary>
    /// <param name="command">The command, to one system.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <param name="handle">Names it in its outcome; above 0.</param>
    /// <returns>Whether there was room; otherwise the command is not taken and gets no outcome.</returns>
    /// <exception cref="ArgumentException">The target system is 0: commands to everybody are acknowledged by nobody in particular.</exception>
    public bool TryStart(in MavlinkCommand command, TimeSpan now, out int handle)
    {
        if (command.Target.SystemId == 0)
            throw new ArgumentException("A command with an outcome is for one system; 0 means all.", nameof(command));
        Release(now);
        handle = 0;
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.Phase != CommandPhase.Free)
                continue;
            handle = _lastHandle = _lastHandle == int.MaxValue ? 1 : _lastHandle + 1;
            exchange.Queue(handle, command);
            return true;
        }

        return false;
    }

    /// <summary>Asks for a command to be cancelled: at once where it was not sent yet, otherwise by COMMAND_CANCEL; the outcome tells what became of it.</summary>
    /// <param name="handle">What <see cref="TryStart"/> gave.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether it was still open.</returns>
    public bool Cancel(int handle, TimeSpan now)
    {
        CommandExchange? exchange = Find(handle);
        exchange?.Cancel(now);
        return exchange is not null;
    }

    /// <summary>Ends a command without a word to the vehicle, which may still do it: for one that another has taken the place of.</summary>
    /// <param name="handle">What <see cref="TryStart"/> gave.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether it was still open. Its outcome is <see cref="MavlinkCommandVerdict.Unknown"/>, or <see cref="MavlinkCommandVerdict.Cancelled"/> where it was never sent.</returns>
    public bool Abandon(int handle, TimeSpan now)
    {
        CommandExchange? exchange = Find(handle);
        exchange?.Abandon(now);
        return exchange is not null;
    }

    /// <summary>How far a command is, by the vehicle's own word.</summary>
    /// <param name="handle">What <see cref="TryStart"/> gave.</param>
    /// <param name="percent">0 to 100.</param>
    /// <returns>Whether it is open and the vehicle said so.</returns>
    public bool TryGetProgress(int handle, out int percent)
    {
        percent = Find(handle)?.Progress ?? byte.MaxValue;
        return percent != byte.MaxValue;
    }

    /// <summary>Takes a frame that came in; all but COMMAND_ACK for us are none of its business.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.TryDecode(out CommandAck answer))
            Handle(frame, answer, now);
    }

    /// <summary>Takes an acknowledgement that came in, where its frame was decoded before.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="answer">Its message.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, in CommandAck answer, TimeSpan now)
    {
        if (!_own.IsMeantBy(answer.TargetSystem, answer.TargetComponent))
            return;
        foreach (CommandExchange exchange in _exchanges)
        {
            if (!exchange.IsAnswered(frame, answer))
                continue;
            exchange.Take(answer, now);
            return;
        }

        StrayAnswers++;
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.TakeLate(frame, answer, now))
                return;
        }
    }

    /// <summary>Gives the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        Release(now);
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.Phase == CommandPhase.Queued && BeginOf(exchange) <= now)
                exchange.Begin(now);
            if (exchange.TryNext(now, _sender, out frame))
                return true;
        }

        frame = default;
        return false;
    }

    /// <summary>Gives the next outcome. Call it until there is none; each comes once.</summary>
    /// <param name="outcome">What became of a command.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeOutcome(out MavlinkCommandOutcome outcome)
    {
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.Phase != CommandPhase.Over)
                continue;
            outcome = exchange.Outcome;
            exchange.Settle();
            return true;
        }

        outcome = default;
        return false;
    }

    private CommandExchange? Find(int handle)
    {
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.Handle == handle && (exchange.IsOpen || exchange.Phase == CommandPhase.Queued))
                return exchange;
        }

        return null;
    }

    private void Release(TimeSpan now)
    {
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.Phase == CommandPhase.Settled && now >= exchange.LateUntil)
                exchange.Free();
        }
    }

    // When a queued command may go out: after all that are like it, and after their late answers.
    private TimeSpan BeginOf(CommandExchange queued)
    {
        TimeSpan begin = TimeSpan.Zero;
        foreach (CommandExchange other in _exchanges)
        {
            if (ReferenceEquals(other, queued) || other.Phase == CommandPhase.Free || !other.IsLike(queued))
                continue;
            if (other.IsOpen || (other.Phase == CommandPhase.Queued && other.Handle < queued.Handle))
                return TimeSpan.MaxValue;
            if (other.Phase is CommandPhase.Over or CommandPhase.Settled && other.LateUntil > begin)
                begin = other.LateUntil;
        }

        return begin;
    }
}
