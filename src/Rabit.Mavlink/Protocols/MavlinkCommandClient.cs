using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Sends commands and reports how they ended (MAVLink guide, "Command Protocol"): several at once, each with exactly
/// one outcome, whatever the link loses, duplicates or reorders. No I/O, no clock: frames in, frames out, time as
/// argument. One thread; nothing is allocated per frame or command.
/// </summary>
/// <remarks>
/// An acknowledgement is matched by command, sender and addressee. It does not say which sending of a command it is
/// for; so two commands of the same kind to the same component are never under way together, and the second waits until
/// late answers to the first can arrive no more (<see cref="MavlinkCommandOptions.LateAnswerTime"/>).
/// TEMPORARILY_REJECTED counts as a refusal only while every sending was answered: after an unanswered one the vehicle
/// may be busy with that very copy, and the command ends as <see cref="MavlinkCommandStatus.Unknown"/>.
/// </remarks>
/// <example>
/// <code>
/// static void Arm(MavlinkCommandClient client, TimeSpan now)
/// {
///     var vehicle = new MavlinkAddress(SystemId: 1, ComponentId: 1);
///     client.TryStart(MavlinkCommand.Create(vehicle, MavCmd.ComponentArmDisarm, param1: 1), now, out int handle);
/// }
///
/// // For every frame that arrives: client.Handle(frame, now). After that, and at client.NextDue at the latest:
/// static void Step(MavlinkCommandClient client, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (client.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     while (client.TryTakeOutcome(out MavlinkCommandOutcome outcome))
///         Console.WriteLine($"{outcome.Command.Command}: {outcome.Status} {outcome.Result}");
/// }
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
    /// <param name="options">Time-outs and retries; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The capacity is below 1.</exception>
    public MavlinkCommandClient(MavlinkSender sender, MavlinkCommandOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        options ??= new MavlinkCommandOptions();
        if (options.Capacity < 1)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, "The capacity is at min 1.");
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _exchanges = new CommandExchange[options.Capacity];
        for (int i = 0; i < _exchanges.Length; i++)
            _exchanges[i] = new CommandExchange(options);
    }

    /// <summary>Acknowledgements for us that no open command was waiting for: late ones, and duplicates.</summary>
    public long StrayAnswers { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for. A time in the past means at once.
    /// </summary>
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

    /// <summary>
    /// Starts a command. It is sent with the next <see cref="TryTakeFrame"/>, or later while one of the same kind is
    /// under way.
    /// </summary>
    /// <param name="command">The command, to one system.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <param name="handle">Identifies it in its outcome; above 0.</param>
    /// <returns>Whether there was room; otherwise the command is not started and gets no outcome.</returns>
    /// <exception cref="ArgumentException">
    /// The target system is 0: a broadcast command has no one to acknowledge it.
    /// </exception>
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

    /// <summary>
    /// Cancels a command: at once where it was not sent yet, otherwise by COMMAND_CANCEL; the outcome reports the
    /// result.
    /// </summary>
    /// <param name="handle">What <see cref="TryStart"/> gave.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether it was still open.</returns>
    public bool Cancel(int handle, TimeSpan now)
    {
        CommandExchange? exchange = Find(handle);
        exchange?.Cancel(now);
        return exchange is not null;
    }

    /// <summary>
    /// Stops tracking a command without sending anything to the vehicle, which may still execute it: for one that was
    /// superseded by another.
    /// </summary>
    /// <param name="handle">What <see cref="TryStart"/> gave.</param>
    /// <param name="now">The time.</param>
    /// <returns>
    /// Whether it was still open. Its outcome is <see cref="MavlinkCommandStatus.Unknown"/>, or
    /// <see cref="MavlinkCommandStatus.Cancelled"/> where it was never sent.
    /// </returns>
    public bool StopTracking(int handle, TimeSpan now)
    {
        CommandExchange? exchange = Find(handle);
        exchange?.StopTracking(now);
        return exchange is not null;
    }

    /// <summary>The progress of a command, as the vehicle reports it.</summary>
    /// <param name="handle">What <see cref="TryStart"/> gave.</param>
    /// <param name="percent">0 to 100.</param>
    /// <returns>Whether it is open and the vehicle reported its progress.</returns>
    public bool TryGetProgress(int handle, out int percent)
    {
        percent = Find(handle)?.Progress ?? byte.MaxValue;
        return percent != byte.MaxValue;
    }

    /// <summary>Handles a received frame; all but COMMAND_ACK for us are ignored.</summary>
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
        if (!_own.IsTargetOf(answer.TargetSystem, answer.TargetComponent))
            return;
        foreach (CommandExchange exchange in _exchanges)
        {
            if (!exchange.IsAnswered(frame, answer))
                continue;
            exchange.HandleAnswer(answer, now);
            return;
        }

        StrayAnswers++;
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.HandleLateAnswer(frame, answer, now))
                return;
        }
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
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

    /// <summary>Takes the next outcome. Call it until there is none; each is returned once.</summary>
    /// <param name="outcome">How a command ended.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeOutcome(out MavlinkCommandOutcome outcome)
    {
        foreach (CommandExchange exchange in _exchanges)
        {
            if (exchange.Phase != CommandPhase.Completed)
                continue;
            outcome = exchange.Outcome;
            exchange.MarkOutcomeTaken();
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
            if (exchange.Phase == CommandPhase.OutcomeTaken && now >= exchange.LateUntil)
                exchange.Release();
        }
    }

    // When a queued command may be sent: after all of the same kind, and after their late answers.
    private TimeSpan BeginOf(CommandExchange queued)
    {
        TimeSpan begin = TimeSpan.Zero;
        foreach (CommandExchange other in _exchanges)
        {
            if (ReferenceEquals(other, queued) || other.Phase == CommandPhase.Free || !other.IsSameKindAs(queued))
                continue;
            if (other.IsOpen || (other.Phase == CommandPhase.Queued && other.Handle < queued.Handle))
                return TimeSpan.MaxValue;
            if (other.Phase is CommandPhase.Completed or CommandPhase.OutcomeTaken && other.LateUntil > begin)
                begin = other.LateUntil;
        }

        return begin;
    }
}
