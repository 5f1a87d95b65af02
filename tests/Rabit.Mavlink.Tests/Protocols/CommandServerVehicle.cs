using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Does commands by <see cref="MavlinkCommandServer"/>. Parameter 1 is a token, returned in result_param2; parameter 2
/// says what to do: 0 accept, 1 deny, 2 take two seconds, 3 accept COMMAND_INT only, 4 reject once for now,
/// 5 unsupported.
/// </summary>
internal sealed class CommandServerVehicle : ScriptedVehicle
{
    private readonly MavlinkCommandServer _server;
    private readonly Dictionary<int, int> _executions = [];
    private readonly HashSet<int> _rejected = [];
    private readonly List<(int Handle, int Token, TimeSpan EndsAt)> _running = [];

    public CommandServerVehicle() => _server = new MavlinkCommandServer(Sender);

    public MavlinkCommandServer Server => _server;

    public IReadOnlyDictionary<int, int> Executions => _executions;

    public override TimeSpan NextDue
    {
        get
        {
            TimeSpan next = _server.NextDue;
            foreach ((_, _, TimeSpan at) in _running)
                next = at < next ? at : next;
            return next;
        }
    }

    public override void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        _server.Handle(frame, now);
        while (_server.TryTakeRequest(out MavlinkCommandRequest request))
            Do(request, now);
        while (_server.TryTakeCancellation(out MavlinkCommandCancellation cancellation))
        {
            _running.RemoveAll(entry => entry.Handle == cancellation.Handle);
            _server.Complete(cancellation.Handle, MavResult.Cancelled, now);
        }
    }

    public override void Tick(TimeSpan now)
    {
        foreach ((int handle, int token, TimeSpan endsAt) in _running.ToArray())
        {
            if (now < endsAt)
                continue;
            _running.RemoveAll(entry => entry.Handle == handle);
            Execute(handle, token, now);
        }

        while (_server.TryTakeFrame(now, out MavlinkFrame frame))
            Send(frame);
    }

    private void Do(in MavlinkCommandRequest request, TimeSpan now)
    {
        int token = (int)request.Command.Param1;
        switch ((int)request.Command.Param2)
        {
            case 1: _server.Complete(request.Handle, MavResult.Denied, now, token); break;
            case 2: _running.Add((request.Handle, token, now + TimeSpan.FromSeconds(2))); break;
            case 3 when request.Command.Forms == MavlinkCommandForms.LongOnly:
                _server.Complete(request.Handle, MavResult.CommandIntOnly, now, token);
                break;
            case 4 when _rejected.Add(token):
                _server.Complete(request.Handle, MavResult.TemporarilyRejected, now, token);
                break;
            case 5: _server.Complete(request.Handle, MavResult.Unsupported, now, token); break;
            default: Execute(request.Handle, token, now); break;
        }
    }

    private void Execute(int handle, int token, TimeSpan now)
    {
        _executions[token] = _executions.TryGetValue(token, out int times) ? times + 1 : 1;
        _server.Complete(handle, MavResult.Accepted, now, token);
    }
}
