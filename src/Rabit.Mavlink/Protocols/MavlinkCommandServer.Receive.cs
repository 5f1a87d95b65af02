using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Received frames.
public sealed partial class MavlinkCommandServer
{
    /// <summary>Handles a received frame; all but commands for us are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        switch (frame.MessageId)
        {
            case CommandLong.MavlinkId when frame.TryDecode(out CommandLong message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Receive(frame, MavlinkCommand.From(message), message.Confirmation, now);
                break;
            case CommandInt.MavlinkId when frame.TryDecode(out CommandInt message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Receive(frame, MavlinkCommand.From(message), 0, now);
                break;
            case CommandCancel.MavlinkId when frame.TryDecode(out CommandCancel message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Cancel(frame, message.Command, now);
                break;
            default:
                break;
        }
    }

    private bool IsForUs(byte system, byte component) => _options.HandlesBroadcast
        ? new MavlinkAddress(_sender.SystemId, _sender.ComponentId).IsTargetOf(system, component)
        : component == _sender.ComponentId
            && (system == _sender.SystemId || (system == 0 && _options.HandlesAllSystems));

    private void Receive(in MavlinkFrame frame, in MavlinkCommand command, int confirmation, TimeSpan now)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        var request = new MavlinkCommandRequest(0, source, frame.IsSigned, command, now);
        if (FindCopied(request, frame.Sequence, confirmation) is { } copied)
        {
            Repeats++;
            copied.Repeat(frame.Sequence, now);
            return;
        }

        CommandExecution? free = IsAtWork(command.Command) ? null : FindFree(now);
        if (free is null)
        {
            Reject(command.Command, source);
            return;
        }

        _lastHandle = _lastHandle == int.MaxValue ? 1 : _lastHandle + 1;
        free.Begin(request with { Handle = _lastHandle }, frame.Sequence);
    }

    private CommandExecution? FindCopied(in MavlinkCommandRequest request, byte sequence, int confirmation)
    {
        CommandExecution? newest = null;
        foreach (CommandExecution execution in _executions)
        {
            bool isCopy = execution.IsCopyOf(request, confirmation > 0);
            if (isCopy && (execution.IsOpen || confirmation > 0 || execution.HasSequence(sequence)))
                return execution;
            if (execution.IsSameKindAs(request) && (newest is null || execution.Handle > newest.Handle))
                newest = execution;
        }

        // Without a confirmation (COMMAND_INT has none) it is a copy unless another one of its kind came in between:
        // pause, continue, pause are three commands.
        return newest is not null && newest.IsCopyOf(request, isConfirmed: false) ? newest : null;
    }

    private bool IsAtWork(MavCmd command)
    {
        foreach (CommandExecution execution in _executions)
        {
            if (execution.IsOpen && execution.Request.Command.Command == command)
                return true;
        }

        return false;
    }

    // The place of the oldest result where nothing else is free.
    private CommandExecution? FindFree(TimeSpan now)
    {
        CommandExecution? oldest = null;
        foreach (CommandExecution execution in _executions)
        {
            if (execution.IsFree(now))
                return execution;
            if (execution.IsKept && !execution.IsAnswerDue
                && (oldest is null || execution.LastCopyAt < oldest.LastCopyAt))
                oldest = execution;
        }

        return oldest;
    }

    private void Reject(MavCmd command, MavlinkAddress source)
    {
        if (_rejected == _rejections.Length)
        {
            Dropped++;
            return;
        }

        Rejections++;
        _rejections[_rejected++] = (command, source);
    }

    private void Cancel(in MavlinkFrame frame, MavCmd command, TimeSpan now)
    {
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        bool isKnown = false;
        foreach (CommandExecution execution in _executions)
        {
            if (execution.Request.Command.Command != command)
                continue;
            if (execution.IsOpen)
                execution.Cancellation = new MavlinkCommandCancellation(execution.Handle, source, frame.IsSigned);
            else if (execution.IsKept && !execution.IsFree(now) && execution.Request.Source == source)
                execution.AnswerAgain();
            else
                continue;
            isKnown = true;
        }

        if (!isKnown)
            StrayCancellations++;
    }
}
