using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkCommandServerTests
{
    private static readonly MavlinkAddress Own = new(1, 191);
    private readonly MavlinkSender _station = new(255, 190);
    private readonly MavlinkSender _other = new(254, 190);
    private MavlinkCommandServer _server = new(new MavlinkSender(1, 191));
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    [Fact]
    public void Handle_Long_HandedOutOnceAndAnswered()
    {
        Send(_station, MavCmd.DoChangeSpeed, 7);
        MavlinkCommandRequest request = Take();
        Assert.Equal(new MavlinkAddress(255, 190), request.Source);
        Assert.Equal(
            (MavCmd.DoChangeSpeed, 7f, MavlinkCommandForms.LongOnly, false),
            (request.Command.Command, request.Command.Param1, request.Command.Forms, request.Command.HasLocation));
        Assert.Equal((Own, false, _now), (request.Command.Target, request.IsSigned, request.ReceivedAt));
        Assert.False(_server.TryTakeRequest(out _));
        Assert.Empty(Answers());

        Assert.True(_server.Complete(request.Handle, MavResult.Accepted, _now, 42));
        Assert.Equal(TimeSpan.Zero, _server.NextDue);
        CommandAck answer = Assert.Single(Answers());
        Assert.Equal(
            (MavCmd.DoChangeSpeed, MavResult.Accepted, 42), (answer.Command, answer.Result, answer.ResultParam2));
        Assert.Equal((255, 190), (answer.TargetSystem, answer.TargetComponent));
        Assert.Equal(TimeSpan.MaxValue, _server.NextDue);
        Assert.False(_server.Complete(request.Handle, MavResult.Accepted, _now));
    }

    [Fact]
    public void Handle_Int_HasLocation()
    {
        MavlinkCommand sent = MavlinkCommand.AtLocation(
            Own, MavCmd.DoSetRoiLocation, MavFrame.GlobalRelativeAlt, 473_000_001, 85_000_002, 30);
        _server.Handle(_station.Create(sent.ToInt()), _now);
        MavlinkCommand command = Take().Command;
        Assert.Equal(
            (473_000_001, 85_000_002, 30f, MavFrame.GlobalRelativeAlt, true, MavlinkCommandForms.IntOnly),
            (command.X, command.Y, command.Z, command.Frame, command.HasLocation, command.Forms));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(0, 0)]
    [InlineData(0, 191)]
    [InlineData(1, 1)]
    [InlineData(2, 191)]
    public void Handle_NotOurAddress_IgnoredAndUnanswered(byte system, byte component)
    {
        var message = new CommandLong
        {
            TargetSystem = system,
            TargetComponent = component,
            Command = MavCmd.NavLand
        };
        _server.Handle(_station.Create(message), _now);
        Assert.False(_server.TryTakeRequest(out _));
        Assert.Empty(Answers());

        _server = new MavlinkCommandServer(
            new MavlinkSender(1, 191), new MavlinkCommandServerOptions { HandlesBroadcast = true });
        _server.Handle(_station.Create(message), _now);
        Assert.Equal(system != 2 && component != 1, _server.TryTakeRequest(out _));
    }

    [Fact]
    public void Handle_RepeatByConfirmation_SameAnswerNotExecuted()
    {
        Send(_station, MavCmd.User1, 1);
        Answer(MavResult.Accepted, 9);
        _now += TimeSpan.FromSeconds(3);
        Send(_station, MavCmd.User1, 1, confirmation: 1);
        Assert.False(_server.TryTakeRequest(out _));
        CommandAck answer = Assert.Single(Answers());
        Assert.Equal((MavResult.Accepted, 9), (answer.Result, answer.ResultParam2));
        Assert.Equal(1, _server.Repeats);
    }

    [Fact]
    public void Handle_SameCommandAgain_NewOnlyAfterRepeatTime()
    {
        Send(_station, MavCmd.User1, 1);
        Answer(MavResult.Accepted);
        _now += TimeSpan.FromSeconds(3.9);
        Send(_station, MavCmd.User1, 1);
        Assert.False(_server.TryTakeRequest(out _));
        Assert.Single(Answers());
        _now += TimeSpan.FromSeconds(4.1);
        Send(_station, MavCmd.User1, 1, confirmation: 1);
        Assert.Single(Answers());
        _now += TimeSpan.FromSeconds(4.1);
        Send(_station, MavCmd.User1, 1);
        Assert.True(_server.TryTakeRequest(out _));
    }

    [Fact]
    public void Handle_PauseContinuePause_AreThreeCommands()
    {
        foreach (float isContinue in new[] { 0f, 1f, 0f })
        {
            Send(_station, MavCmd.DoPauseContinue, isContinue);
            Answer(MavResult.Accepted);
            _now += TimeSpan.FromSeconds(0.5);
        }

        Assert.Equal(0, _server.Repeats);
    }

    [Fact]
    public void Handle_LateCopyAfterOtherOfItsKind_NotExecuted()
    {
        Send(_station, MavCmd.DoPauseContinue, 0);
        Answer(MavResult.Accepted);
        Send(_station, MavCmd.DoPauseContinue, 1);
        Answer(MavResult.Accepted);
        Send(_station, MavCmd.DoPauseContinue, 0, confirmation: 2);
        Assert.False(_server.TryTakeRequest(out _));
        Assert.Single(Answers());
    }

    [Fact]
    public void Handle_FrameDoubledByTheLink_NotExecuted()
    {
        MavlinkFrame pause = _station.Create(MavlinkCommand.Create(Own, MavCmd.DoPauseContinue, 0).ToLong(0));
        _server.Handle(pause, _now);
        Answer(MavResult.Accepted);
        Send(_station, MavCmd.DoPauseContinue, 1);
        Answer(MavResult.Accepted);
        _server.Handle(pause, _now);
        Assert.False(_server.TryTakeRequest(out _));
    }

    [Fact]
    public void TryTakeFrame_TakesLong_InProgressEveryHalfSecondThenResult()
    {
        Send(_station, MavCmd.NavLand, 0);
        int handle = Take().Handle;
        TimeSpan start = _now;
        Assert.Equal(start + TimeSpan.FromSeconds(0.5), _server.NextDue);
        var progress = new List<byte>();
        for (int i = 0; i < 3; i++)
        {
            _now = _server.NextDue;
            CommandAck answer = Assert.Single(Answers());
            Assert.Equal(MavResult.InProgress, answer.Result);
            progress.Add(answer.Progress);
            Assert.True(_server.ReportProgress(handle, 30 * (i + 1)));
        }

        Assert.Equal([255, 30, 60], progress);
        Assert.Equal(TimeSpan.FromSeconds(1.5), _now - start);

        // A copy does not begin it again and gets its answer at once.
        _now += TimeSpan.FromSeconds(0.1);
        Send(_station, MavCmd.NavLand, 0, confirmation: 1);
        Assert.Equal(MavResult.InProgress, Assert.Single(Answers()).Result);
        Assert.False(_server.TryTakeRequest(out _));
        Assert.True(_server.Complete(handle, MavResult.Failed, _now));
        Assert.Equal(MavResult.Failed, Assert.Single(Answers()).Result);
        Assert.Equal(TimeSpan.MaxValue, _server.NextDue);
    }

    [Fact]
    public void Handle_SameKindAtWork_TemporarilyRejectedToItsSender()
    {
        Send(_station, MavCmd.NavLand, 0);
        int handle = Take().Handle;
        Send(_other, MavCmd.NavLand, 0);
        Send(_station, MavCmd.NavLand, 1);
        Assert.False(_server.TryTakeRequest(out _));
        List<CommandAck> answers = Answers();
        Assert.Equal(2, answers.Count);
        Assert.All(answers, answer => Assert.Equal(MavResult.TemporarilyRejected, answer.Result));
        Assert.Contains(answers, answer => answer.TargetSystem == 254);
        Assert.Equal(2, _server.Rejections);

        _server.Complete(handle, MavResult.Accepted, _now);
        Answers();
        Send(_other, MavCmd.NavLand, 0, confirmation: 1);
        Assert.True(_server.TryTakeRequest(out _));
    }

    [Fact]
    public void Complete_TemporarilyRejected_LookedAtAgain()
    {
        Send(_station, MavCmd.NavLand, 0);
        Answer(MavResult.TemporarilyRejected);
        Send(_station, MavCmd.NavLand, 0, confirmation: 1);
        Assert.True(_server.TryTakeRequest(out _));
    }

    [Fact]
    public void Cancel_AtWork_ReportedAndAnsweredToTheFirstSender()
    {
        Send(_station, MavCmd.NavLand, 0);
        int handle = Take().Handle;
        Cancel(_other, MavCmd.NavLand);
        Assert.True(_server.TryTakeCancellation(out MavlinkCommandCancellation cancellation));
        Assert.Equal(
            new MavlinkCommandCancellation(handle, new MavlinkAddress(254, 190), IsSigned: false), cancellation);
        Assert.False(_server.TryTakeCancellation(out _));
        _server.Complete(handle, MavResult.Cancelled, _now);
        CommandAck answer = Assert.Single(Answers());
        Assert.Equal((MavResult.Cancelled, (byte)255), (answer.Result, answer.TargetSystem));

        // The answer was lost: the sender asks again and gets it again.
        Cancel(_station, MavCmd.NavLand);
        Assert.Equal(MavResult.Cancelled, Assert.Single(Answers()).Result);
        Assert.Equal(0, _server.StrayCancellations);
        Cancel(_station, MavCmd.DoSetMode);
        Assert.Empty(Answers());
        Assert.Equal(1, _server.StrayCancellations);
    }

    [Fact]
    public void Handle_MoreThanFit_RejectedAndDroppedAreCounted()
    {
        _server = new MavlinkCommandServer(new MavlinkSender(1, 191), new MavlinkCommandServerOptions { Capacity = 2 });
        for (int i = 0; i < 5; i++)
            Send(_station, (MavCmd)(31010 + i), 0);
        Assert.Equal((2, 1), (_server.Rejections, _server.Dropped));
        Assert.Equal(2, Answers().Count);

        // Results that are only remembered make room.
        while (_server.TryTakeRequest(out MavlinkCommandRequest request))
            _server.Complete(request.Handle, MavResult.Accepted, _now);
        Answers();
        Send(_station, (MavCmd)31014, 0, confirmation: 1);
        Assert.Equal((MavCmd)31014, Take().Command.Command);
    }

    [Fact]
    public void BadInput_Throws()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkCommandServer(null!));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkCommandServerOptions { Capacity = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkCommandServerOptions { ProgressInterval = TimeSpan.Zero }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkCommandServerOptions { RepeatTime = -TimeSpan.FromTicks(1) }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkCommandServerOptions { ConfirmedRepeatTime = TimeSpan.FromSeconds(3) }));
        Assert.Throws<ArgumentException>(() => _server.Complete(1, MavResult.InProgress, _now));
        Assert.Throws<ArgumentOutOfRangeException>(() => _server.ReportProgress(1, 101));
        Assert.False(_server.ReportProgress(1, 100));
    }

    private static MavlinkCommandServer New(MavlinkCommandServerOptions options)
        => new(new MavlinkSender(1, 191), options);

    private void Send(MavlinkSender from, MavCmd command, float param1, byte confirmation = 0)
        => _server.Handle(from.Create(MavlinkCommand.Create(Own, command, param1).ToLong(confirmation)), _now);

    private void Cancel(MavlinkSender from, MavCmd command) => _server.Handle(
        from.Create(new CommandCancel { TargetSystem = 1, TargetComponent = 191, Command = command }), _now);

    private MavlinkCommandRequest Take()
    {
        Assert.True(_server.TryTakeRequest(out MavlinkCommandRequest request));
        return request;
    }

    private void Answer(MavResult result, int resultParam2 = 0)
    {
        Assert.True(_server.Complete(Take().Handle, result, _now, resultParam2));
        Assert.Equal(result, Assert.Single(Answers()).Result);
    }

    private List<CommandAck> Answers()
    {
        var answers = new List<CommandAck>();
        while (_server.TryTakeFrame(_now, out MavlinkFrame frame))
        {
            Assert.True(frame.TryDecode(out CommandAck answer));
            answers.Add(answer);
        }

        return answers;
    }
}
