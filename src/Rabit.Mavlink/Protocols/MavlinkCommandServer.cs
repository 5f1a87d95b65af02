using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Receives commands for one component and acknowledges them (MAVLink guide, "Command Protocol"): each is handed out
/// once, however often it arrives, and each copy gets its answer. No I/O, no clock: frames in, frames out, time as
/// argument. One thread; nothing is allocated per frame or command.
/// </summary>
/// <remarks>
/// A copy is what the same sender sends again with the same parameters while the command is at work, or shortly after
/// its result (<see cref="MavlinkCommandServerOptions.RepeatTime"/>,
/// <see cref="MavlinkCommandServerOptions.ConfirmedRepeatTime"/>): with <c>confirmation</c> above 0, with the
/// sequence number of the frame before, or without another command of its kind in between. It gets the answer of the
/// first. A result TEMPORARILY_REJECTED is not kept. While a command is at work, another of its kind (other
/// parameters, or another sender) is answered TEMPORARILY_REJECTED, as the guide has it: an acknowledgement does not
/// say which of the two it is for.
/// </remarks>
/// <example>
/// <code>
/// // For every frame that arrives: server.Handle(frame, now). After that, and at server.NextDue at the latest:
/// static void Step(MavlinkCommandServer server, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (server.TryTakeRequest(out MavlinkCommandRequest request))
///     {
///         MavResult result = request.Command.Command == MavCmd.DoChangeSpeed
///             ? MavResult.Accepted
///             : MavResult.Unsupported;
///         server.Complete(request.Handle, result, now);
///     }
///
///     while (server.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
/// }
/// </code>
/// </example>
public sealed partial class MavlinkCommandServer
{
    private readonly MavlinkSender _sender;
    private readonly MavlinkCommandServerOptions _options;
    private readonly CommandExecution[] _executions;
    private readonly (MavCmd Command, MavlinkAddress Source)[] _rejections;
    private int _rejected;
    private int _lastHandle;

    /// <summary>Makes a server.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures; it is who is asked.</param>
    /// <param name="options">What it listens to, and its times; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The capacity is below 1, or a time is out of range.</exception>
    public MavlinkCommandServer(MavlinkSender sender, MavlinkCommandServerOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _options = options ?? new MavlinkCommandServerOptions();
        if (_options.Capacity < 1)
            throw new ArgumentOutOfRangeException(nameof(options), _options.Capacity, "The capacity is at min 1.");
        if (_options.ProgressInterval <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.ProgressInterval, "The progress interval is above 0.");
        if (_options.RepeatTime < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(options), _options.RepeatTime, "The repeat time is at min 0.");
        if (_options.ConfirmedRepeatTime < _options.RepeatTime)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.ConfirmedRepeatTime,
                $"The repeat time of confirmed copies is at min that of others, {_options.RepeatTime}.");
        _executions = new CommandExecution[_options.Capacity];
        _rejections = new (MavCmd, MavlinkAddress)[_options.Capacity];
        for (int i = 0; i < _executions.Length; i++)
            _executions[i] = new CommandExecution(_options);
    }

    /// <summary>Copies of a command that were answered and not handed out again.</summary>
    public long Repeats { get; private set; }

    /// <summary>
    /// Commands answered TEMPORARILY_REJECTED by the server itself: one of their kind, or too many, were at work.
    /// </summary>
    public long Rejections { get; private set; }

    /// <summary>Commands that got no answer, since too many answers were waiting to be sent.</summary>
    public long Dropped { get; private set; }

    /// <summary>Requests to cancel a command that is not at work.</summary>
    public long StrayCancellations { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for. A time in the past means at once.
    /// </summary>
    public TimeSpan NextDue
    {
        get
        {
            TimeSpan next = _rejected > 0 ? TimeSpan.Zero : TimeSpan.MaxValue;
            foreach (CommandExecution execution in _executions)
                next = execution.Due < next ? execution.Due : next;
            return next;
        }
    }

    /// <summary>Takes the next command to execute. Call it until there is none; each is returned once.</summary>
    /// <param name="request">The command.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeRequest(out MavlinkCommandRequest request)
    {
        CommandExecution? first = null;
        foreach (CommandExecution execution in _executions)
        {
            if (execution.IsWaiting && (first is null || execution.Handle < first.Handle))
                first = execution;
        }

        request = first?.Request ?? default;
        first?.Take();
        return first is not null;
    }

    /// <summary>
    /// Takes the next request to cancel a command that is at work. To obey it, complete the command with
    /// <see cref="MavResult.Cancelled"/>; otherwise go on as before.
    /// </summary>
    /// <param name="cancellation">The request.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeCancellation(out MavlinkCommandCancellation cancellation)
    {
        foreach (CommandExecution execution in _executions)
        {
            if (!execution.IsRunning || execution.Cancellation is not { } found)
                continue;
            cancellation = found;
            execution.Cancellation = null;
            return true;
        }

        cancellation = default;
        return false;
    }

    /// <summary>Sets the progress that the next IN_PROGRESS reports.</summary>
    /// <param name="handle">Of the command.</param>
    /// <param name="percent">0 to 100.</param>
    /// <returns>Whether it is at work.</returns>
    /// <exception cref="ArgumentOutOfRangeException">No percentage.</exception>
    public bool ReportProgress(int handle, int percent)
    {
        if (percent is < 0 or > 100)
            throw new ArgumentOutOfRangeException(nameof(percent), percent, "0 to 100.");
        CommandExecution? execution = Find(handle);
        if (execution is not null)
            execution.Progress = (byte)percent;
        return execution is not null;
    }

    /// <summary>Ends a command with its result, which is sent, and sent again to copies.</summary>
    /// <param name="handle">Of the command.</param>
    /// <param name="result">
    /// The result; <see cref="MavResult.Unsupported"/> for a command that is not known here. A result
    /// <see cref="MavResult.CommandIntOnly"/> or <see cref="MavResult.CommandLongOnly"/> asks for the other form.
    /// </param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <param name="resultParam2">Whatever the command's definition has there.</param>
    /// <returns>Whether it was at work.</returns>
    /// <exception cref="ArgumentException">IN_PROGRESS, which is no result: it is sent by itself.</exception>
    public bool Complete(int handle, MavResult result, TimeSpan now, int resultParam2 = 0)
    {
        if (result == MavResult.InProgress)
            throw new ArgumentException("IN_PROGRESS is no result; it is sent by itself.", nameof(result));
        CommandExecution? execution = Find(handle);
        execution?.Complete(result, resultParam2, now);
        return execution is not null;
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        if (_rejected > 0)
        {
            (MavCmd command, MavlinkAddress source) = _rejections[--_rejected];
            frame = _sender.Create(new CommandAck
            {
                Command = command,
                Result = MavResult.TemporarilyRejected,
                Progress = byte.MaxValue,
                TargetSystem = source.SystemId,
                TargetComponent = source.ComponentId,
            });
            return true;
        }

        foreach (CommandExecution execution in _executions)
        {
            if (execution.TryNext(now, _sender, out frame))
                return true;
        }

        frame = default;
        return false;
    }

    private CommandExecution? Find(int handle)
    {
        foreach (CommandExecution execution in _executions)
        {
            if (execution.IsOpen && execution.Handle == handle)
                return execution;
        }

        return null;
    }
}
