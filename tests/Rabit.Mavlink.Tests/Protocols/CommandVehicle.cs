using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Does commands. Parameter 1 is a token, which it returns in result_param2, so that a test knows whose answer it is;
/// parameter 2 says what to do: 0 accept, 1 deny, 2 take two seconds with progress, 3 accept COMMAND_INT only, 4 reject
/// once for now, 5 say nothing.
/// </summary>
internal sealed class CommandVehicle : ScriptedVehicle
{
    private readonly Dictionary<int, int> _executions = [];
    private readonly Dictionary<int, int> _rejected = [];
    private readonly List<(MavCmd Command, int Token, TimeSpan NextAt, TimeSpan EndsAt)> _running = [];

    /// <summary>Copies of a command that it had done already.</summary>
    public int Duplicates { get; private set; }

    public IReadOnlyDictionary<int, int> Executions => _executions;

    public override TimeSpan NextDue
    {
        get
        {
            TimeSpan next = TimeSpan.MaxValue;
            foreach ((_, _, TimeSpan at, _) in _running)
                next = at < next ? at : next;
            return next;
        }
    }

    public override void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.TryDecode(out CommandLong command))
            Do(command.Command, (int)command.Param1, (int)command.Param2, isInt: false, now);
        else if (frame.TryDecode(out CommandInt place))
            Do(place.Command, (int)place.Param1, (int)place.Param2, isInt: true, now);
        else if (frame.TryDecode(out CommandCancel cancel))
            Cancel(cancel.Command);
    }

    public override void Tick(TimeSpan now)
    {
        for (int i = _running.Count - 1; i >= 0; i--)
        {
            (MavCmd command, int token, TimeSpan nextAt, TimeSpan endsAt) = _running[i];
            if (now < nextAt)
                continue;
            if (now < endsAt)
            {
                _running[i] = (command, token, nextAt + TimeSpan.FromSeconds(0.5), endsAt);
                Answer(command, MavResult.InProgress, token, 50);
                continue;
            }

            _running.RemoveAt(i);
            _executions[token] = _executions.TryGetValue(token, out int times) ? times + 1 : 1;
            Answer(command, MavResult.Accepted, token);
        }
    }

    private void Do(MavCmd command, int token, int kind, bool isInt, TimeSpan now)
    {
        switch (kind)
        {
            case 1:
                Answer(command, MavResult.Denied, token);
                return;
            case 2 when _running.Exists(entry => entry.Command == command):
                Answer(command, MavResult.TemporarilyRejected, token);
                return;
            case 2 when !_executions.ContainsKey(token):
                _running.Add((command, token, now, now + TimeSpan.FromSeconds(2)));
                return;
            case 3 when !isInt:
                Answer(command, MavResult.CommandIntOnly, token);
                return;
            case 4 when !_rejected.ContainsKey(token):
                _rejected[token] = 1;
                Answer(command, MavResult.TemporarilyRejected, token);
                return;
            case 5:
                return;
            default:
                break;
        }

        // The token distinguishes a copy from a new command; a copy is counted, not executed.
        if (_executions.ContainsKey(token))
            Duplicates++;
        else
            _executions[token] = 1;
        Answer(command, MavResult.Accepted, token);
    }

    private void Cancel(MavCmd command)
    {
        int index = _running.FindIndex(entry => entry.Command == command);
        if (index < 0)
            return;
        int token = _running[index].Token;
        _running.RemoveAt(index);
        Answer(command, MavResult.Cancelled, token);
    }

    private void Answer(MavCmd command, MavResult result, int token, byte progress = byte.MaxValue)
        => Send(new CommandAck
        {
            Command = command,
            Result = result,
            Progress = progress,
            ResultParam2 = token,
            TargetSystem = 1,
            TargetComponent = 191,
        });
}
