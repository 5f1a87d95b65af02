using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

public class CommandDeskTests
{
    private static readonly TimeSpan Retry = TimeSpan.FromSeconds(1);

    private readonly List<VehicleCommand> _sent = [];
    private readonly CommandDispatcher _desk;
    private bool _isFull;

    public CommandDeskTests() => _desk = new CommandDispatcher(Push, static _ => { });

    [Fact]
    public void Want_TheSameAgain_IsSentOnce()
    {
        for (int i = 0; i < 10; i++)
        {
            _desk.Want(GoTo(1), "go", Retry);
            _desk.Send(At(i * 0.2));
        }

        Assert.Single(_sent);
        _desk.Want(GoTo(2), "go", Retry);
        _desk.Send(At(3));
        Assert.Equal([1L, 2L], _sent.ConvertAll(c => c.Id));
    }

    [Fact]
    public void Take_AnswerToAnOlderCommand_MeansNothing()
    {
        _desk.Want(GoTo(1), "go", Retry);
        _desk.Send(At(0));
        _desk.Want(GoTo(2), "go", Retry);
        _desk.Send(At(0.2));
        _desk.Take(Answer(1, VehicleCommandOutcome.Accepted), At(0.3));
        Assert.False(_desk.IsAccepted);
        _desk.Take(Answer(2, VehicleCommandOutcome.Accepted), At(0.3));
        Assert.True(_desk.IsAccepted);
    }

    [Fact]
    public void Take_Refused_IsSentAgainAfterAWhile()
    {
        _desk.Want(GoTo(1), "go", Retry);
        _desk.Send(At(0));
        _desk.Take(Answer(1, VehicleCommandOutcome.Refused), At(0.5));
        _desk.Send(At(1.4));
        Assert.Single(_sent);
        _desk.Send(At(1.5));
        Assert.Equal(2, _sent.Count);
        Assert.Equal((1, "refused: no"), (_desk.Failures, _desk.LastFailure));
        _desk.Take(Answer(2, VehicleCommandOutcome.Accepted), At(1.6));
        Assert.Equal(0, _desk.Failures);
    }

    [Fact]
    public void Send_NoAnswerAtAll_CountsAsFailed()
    {
        _desk.Want(GoTo(1), "go", Retry);
        _desk.Send(At(0));
        _desk.Send(At(21));
        Assert.Equal(1, _desk.Failures);
        _desk.Send(At(22));
        Assert.Equal(2, _sent.Count);
    }

    [Fact]
    public void Send_QueueIsFull_IsTriedAgain()
    {
        _isFull = true;
        _desk.Want(GoTo(1), "go", Retry);
        _desk.Send(At(0));
        _isFull = false;
        _desk.Send(At(0.2));
        Assert.Equal(1, Assert.Single(_sent).Id);
    }

    [Fact]
    public void Take_NotInCommand_SendsNothingMore()
    {
        _desk.Want(GoTo(1), "go", Retry);
        _desk.Send(At(0));
        _desk.Take(Answer(1, VehicleCommandOutcome.NotInCommand), At(0.1));
        _desk.Send(At(60));
        Assert.Single(_sent);
        Assert.Equal("no", _desk.NotInCommand);
    }

    private static VehicleCommand GoTo(double latitude)
        => new() { Kind = VehicleCommandKind.GoTo, LatitudeRadians = latitude, YawRadians = double.NaN };

    private static VehicleCommandResult Answer(long id, VehicleCommandOutcome outcome)
        => new() { Id = id, Kind = VehicleCommandKind.GoTo, Outcome = outcome, Text = outcome == VehicleCommandOutcome.Accepted ? null : "no" };

    private static TimeSpan At(double seconds) => TimeSpan.FromSeconds(seconds);

    private bool Push(VehicleCommand command)
    {
        if (!_isFull)
            _sent.Add(command);
        return !_isFull;
    }
}
