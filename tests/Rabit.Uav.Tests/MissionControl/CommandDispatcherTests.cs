using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

public class CommandDispatcherTests
{
    private static readonly TimeSpan Retry = TimeSpan.FromSeconds(1);

    private readonly List<VehicleCommand> _sent = [];
    private readonly CommandDispatcher _dispatcher;
    private bool _isFull;

    public CommandDispatcherTests() => _dispatcher = new CommandDispatcher(Push, static _ => { });

    [Fact]
    public void SetGoal_TheSameAgain_IsSentOnce()
    {
        for (int i = 0; i < 10; i++)
        {
            _dispatcher.SetGoal(GoTo(1), "go", Retry);
            _dispatcher.Send(At(i * 0.2));
        }

        Assert.Single(_sent);
        _dispatcher.SetGoal(GoTo(2), "go", Retry);
        _dispatcher.Send(At(3));
        Assert.Equal([1L, 2L], _sent.ConvertAll(c => c.Id));
    }

    [Fact]
    public void Apply_AnswerToAnOlderCommand_IsIgnored()
    {
        _dispatcher.SetGoal(GoTo(1), "go", Retry);
        _dispatcher.Send(At(0));
        _dispatcher.SetGoal(GoTo(2), "go", Retry);
        _dispatcher.Send(At(0.2));
        _dispatcher.Apply(Result(1, VehicleCommandOutcome.Accepted), At(0.3));
        Assert.False(_dispatcher.IsAccepted);
        _dispatcher.Apply(Result(2, VehicleCommandOutcome.Accepted), At(0.3));
        Assert.True(_dispatcher.IsAccepted);
    }

    [Fact]
    public void Apply_Refused_IsSentAgainAfterAWhile()
    {
        _dispatcher.SetGoal(GoTo(1), "go", Retry);
        _dispatcher.Send(At(0));
        _dispatcher.Apply(Result(1, VehicleCommandOutcome.Refused), At(0.5));
        _dispatcher.Send(At(1.4));
        Assert.Single(_sent);
        _dispatcher.Send(At(1.5));
        Assert.Equal(2, _sent.Count);
        Assert.Equal((1, "refused: no"), (_dispatcher.Failures, _dispatcher.LastFailure));
        _dispatcher.Apply(Result(2, VehicleCommandOutcome.Accepted), At(1.6));
        Assert.Equal(0, _dispatcher.Failures);
    }

    [Fact]
    public void Send_NoResultAtAll_CountsAsFailed()
    {
        _dispatcher.SetGoal(GoTo(1), "go", Retry);
        _dispatcher.Send(At(0));
        _dispatcher.Send(At(21));
        Assert.Equal(1, _dispatcher.Failures);
        _dispatcher.Send(At(22));
        Assert.Equal(2, _sent.Count);
    }

    [Fact]
    public void Send_QueueIsFull_IsTriedAgain()
    {
        _isFull = true;
        _dispatcher.SetGoal(GoTo(1), "go", Retry);
        _dispatcher.Send(At(0));
        _isFull = false;
        _dispatcher.Send(At(0.2));
        Assert.Equal(1, Assert.Single(_sent).Id);
    }

    [Fact]
    public void Apply_NotInCommand_SendsNothingMore()
    {
        _dispatcher.SetGoal(GoTo(1), "go", Retry);
        _dispatcher.Send(At(0));
        _dispatcher.Apply(Result(1, VehicleCommandOutcome.NotInCommand), At(0.1));
        _dispatcher.Send(At(60));
        Assert.Single(_sent);
        Assert.Equal("no", _dispatcher.NotInCommand);
    }

    private static VehicleCommand GoTo(double latitude)
        => new() { Kind = VehicleCommandKind.GoTo, Latitude = Angle.FromRadians(latitude), Yaw = Angle.NaN };

    private static VehicleCommandResult Result(long id, VehicleCommandOutcome outcome)
        => new()
        {
            Id = id,
            Kind = VehicleCommandKind.GoTo,
            Outcome = outcome,
            Text = outcome == VehicleCommandOutcome.Accepted ? null : "no"
        };

    private static TimeSpan At(double seconds) => TimeSpan.FromSeconds(seconds);

    private bool Push(VehicleCommand command)
    {
        if (!_isFull)
            _sent.Add(command);
        return !_isFull;
    }
}
