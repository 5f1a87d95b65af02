using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Knows which commands may still be answered: an acknowledgement names the command but not which sending of it, so that one which
/// comes late would be taken for that of the next of the same kind. That one waits until the earlier ones are answered or out of date.
/// </summary>
internal sealed class OpenAcknowledgements
{
    private readonly Dictionary<MavCmd, (int Open, TimeSpan LastSent)> _commands = [];

    public void Sent(MavCmd command, TimeSpan now)
    {
        _commands.TryGetValue(command, out (int Open, TimeSpan LastSent) entry);
        _commands[command] = (entry.Open + 1, now);
    }

    public void Answered(MavCmd command)
    {
        if (_commands.TryGetValue(command, out (int Open, TimeSpan LastSent) entry) && entry.Open > 0)
            _commands[command] = (entry.Open - 1, entry.LastSent);
    }

    /// <summary>Whether an answer that comes from now on can only be to a command that is sent from now on.</summary>
    public bool IsClear(MavCmd command, TimeSpan now)
    {
        if (!_commands.TryGetValue(command, out (int Open, TimeSpan LastSent) entry) || entry.Open == 0)
            return true;
        if (now - entry.LastSent < CommandTransaction.AnswerTimeout)
            return false;
        _commands[command] = (0, entry.LastSent);
        return true;
    }
}
