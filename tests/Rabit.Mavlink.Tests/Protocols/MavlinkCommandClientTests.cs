using System;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Single exchanges, frame by frame.</summary>
public class MavlinkCommandClientTests
{
    private static readonly TimeSpan Start = TimeSpan.FromSeconds(10);
    private static readonly MavlinkSender Vehicle = new(1, 1);
    private MavlinkCommandClient _client = new(ScriptedVehicle.Companion());
    private TimeSpan _now = Start;

    [Fact]
    public void NoAnswer_FourTriesWithConfirmation_ThenUnknown()
    {
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.ComponentArmDisarm, 1));
        for (byte confirmation = 0; confirmation < 4; confirmation++)
        {
            Assert.True(
                _client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out CommandLong command)
                    && command.Confirmation == confirmation);
            Assert.False(_client.TryTakeFrame(_now, out _));
            _now = _client.NextDue;
        }

        Assert.False(_client.TryTakeFrame(_now, out _));
        AssertOutcome(MavlinkCommandStatus.Unknown, null);
        Assert.Equal(TimeSpan.FromSeconds(4 * 0.7), _now - Start);
    }

    [Theory]
    [InlineData(1, 1, MavCmd.NavTakeoff, 1, 191)]
    [InlineData(2, 1, MavCmd.ComponentArmDisarm, 1, 191)]
    [InlineData(1, 2, MavCmd.ComponentArmDisarm, 1, 191)]
    [InlineData(1, 1, MavCmd.ComponentArmDisarm, 255, 190)]
    [InlineData(1, 1, MavCmd.ComponentArmDisarm, 1, 192)]
    public void AnswerOfAnother_IsNotTaken(
        byte system, byte component, MavCmd command, byte targetSystem, byte targetComponent)
    {
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.ComponentArmDisarm, 1));
        Assert.True(_client.TryTakeFrame(_now, out _));
        var answer = new CommandAck
        {
            Command = command,
            TargetSystem = targetSystem,
            TargetComponent = targetComponent
        };
        _client.Handle(MavlinkFrame.Create(answer, system, component, 0), _now);
        Assert.False(_client.TryTakeOutcome(out _));
        Answer(MavCmd.ComponentArmDisarm, MavResult.Accepted);
        AssertOutcome(MavlinkCommandStatus.Accepted, MavResult.Accepted);
    }

    [Theory]
    [InlineData(MavResult.CommandLongOnly)]
    [InlineData(MavResult.CommandUnsupportedMavFrame)]
    [InlineData(MavResult.Unsupported)]
    public void Location_RefusedAsInt_IsSentAsLong(MavResult result)
    {
        Begin(
            MavlinkCommand.AtLocation(
                ScriptedVehicle.Address, MavCmd.DoReposition, MavFrame.GlobalRelativeAlt, 473_000_000, 85_000_000, 30,
                -1, 1, 0, float.NaN));
        Assert.True(
            _client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out CommandInt place)
                && place.X == 473_000_000 && place.Frame == MavFrame.GlobalRelativeAlt);
        Answer(MavCmd.DoReposition, result);
        Answer(MavCmd.DoReposition, result);   // a copy
        _now = _client.NextDue;
        Assert.True(
            _client.TryTakeFrame(_now, out frame) && frame.TryDecode(out CommandLong command) && command.Param5 == 47.3f
                && command.Param6 == 8.5f && command.Param7 == 30);
        Answer(MavCmd.DoReposition, MavResult.Accepted);
        AssertOutcome(MavlinkCommandStatus.Accepted, MavResult.Accepted);
    }

    [Fact]
    public void Location_IntOnlyAndUnsupported_IsRefused()
    {
        Begin(
            MavlinkCommand.AtLocation(ScriptedVehicle.Address, MavCmd.DoOrbit, MavFrame.Global, 1, 2, 3) with
            {
                Forms = MavlinkCommandForms.IntOnly
            });
        Assert.True(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.DoOrbit, MavResult.Unsupported);
        AssertOutcome(MavlinkCommandStatus.Refused, MavResult.Unsupported);
    }

    [Fact]
    public void InProgress_WaitsLongerAndIsNotSentAgain()
    {
        int handle = Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.PreflightCalibration));
        Assert.True(_client.TryTakeFrame(_now, out _));
        for (int i = 1; i <= 5; i++)
        {
            _now += TimeSpan.FromSeconds(4);
            Assert.False(_client.TryTakeFrame(_now, out _) && i > 1);
            Answer(MavCmd.PreflightCalibration, MavResult.InProgress, (byte)(i * 10));
            Assert.True(_client.TryGetProgress(handle, out int percent) && percent == i * 10);
        }

        _now += TimeSpan.FromSeconds(5);
        Assert.False(_client.TryTakeFrame(_now, out _));
        AssertOutcome(MavlinkCommandStatus.Unknown, null);
    }

    [Fact]
    public void Cancel_UnderWay_RequestsItAndReportsTheAnswer()
    {
        int handle = Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.PreflightCalibration));
        Assert.True(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.PreflightCalibration, MavResult.InProgress);
        Assert.True(_client.Cancel(handle, _now));
        Assert.True(
            _client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out CommandCancel cancel)
                && cancel.Command == MavCmd.PreflightCalibration);
        Answer(MavCmd.PreflightCalibration, MavResult.Cancelled);
        AssertOutcome(MavlinkCommandStatus.Cancelled, MavResult.Cancelled);
        Assert.False(_client.Cancel(handle, _now));
    }

    [Fact]
    public void SameCommandAgain_WaitsForLateAnswers_AnotherDoesNot()
    {
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 1));
        Assert.True(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.DoSetMode, MavResult.Accepted);
        AssertOutcome(MavlinkCommandStatus.Accepted, MavResult.Accepted);
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 2));
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.NavTakeoff));
        Assert.True(
            _client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out CommandLong other)
                && other.Command == MavCmd.NavTakeoff);
        Answer(MavCmd.DoSetMode, MavResult.Denied);   // a late copy
        Assert.Equal(1, _client.StrayAnswers);
        Assert.False(_client.TryTakeFrame(_now + TimeSpan.FromSeconds(0.5), out _));
        Assert.False(_client.TryTakeOutcome(out _));
        _now += TimeSpan.FromSeconds(1);
        Assert.True(_client.TryTakeFrame(_now, out frame));
    }

    [Fact]
    public void InProgressThenSilent_RetriesInProgress_IsSentAgainByTheTriesThatAreLeft()
    {
        _client = new MavlinkCommandClient(
            ScriptedVehicle.Companion(), new MavlinkCommandOptions { RetriesInProgress = true });
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode));
        Assert.True(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.DoSetMode, MavResult.InProgress);
        Assert.Equal(_now + TimeSpan.FromSeconds(5), _client.NextDue);
        for (int tries = 2; tries <= 4; tries++)
        {
            _now = _client.NextDue;
            Assert.True(_client.TryTakeFrame(_now, out _));
        }

        _now = _client.NextDue;
        Assert.False(_client.TryTakeFrame(_now, out _));
        AssertOutcome(MavlinkCommandStatus.Unknown, null);
    }

    [Fact]
    public void SameCommandAgain_LinkThatDoesNotDuplicate_WaitsForOutstandingAnswers()
    {
        _client = new MavlinkCommandClient(
            ScriptedVehicle.Companion(), new MavlinkCommandOptions { AnswersMayBeDuplicated = false });
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 1));
        Assert.True(_client.TryTakeFrame(_now, out _));
        _now = _client.NextDue;
        Assert.True(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.DoSetMode, MavResult.Accepted);   // to one of the two
        AssertOutcome(MavlinkCommandStatus.Accepted, MavResult.Accepted);
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 2));
        Assert.False(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.DoSetMode, MavResult.Denied);     // to the other
        Assert.False(_client.TryTakeOutcome(out _));

        Assert.True(
            _client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out CommandLong command)
                && command.Param1 == 2);
        Answer(MavCmd.DoSetMode, MavResult.Accepted);
        AssertOutcome(MavlinkCommandStatus.Accepted, MavResult.Accepted);
    }

    [Fact]
    public void StopTracking_SentOrNot_SendsNothingAndItsLateAnswerIsNotThatOfTheNext()
    {
        int sent = Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 1));
        Assert.True(_client.TryTakeFrame(_now, out _));
        int queued = Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 2));
        Assert.True(_client.StopTracking(queued, _now));
        AssertOutcome(MavlinkCommandStatus.Cancelled, null);
        Assert.True(_client.StopTracking(sent, _now));
        Assert.False(_client.StopTracking(sent, _now));
        Assert.False(_client.TryTakeFrame(_now, out _));
        AssertOutcome(MavlinkCommandStatus.Unknown, null);

        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode, 3));
        Answer(MavCmd.DoSetMode, MavResult.Accepted);
        Assert.False(_client.TryTakeOutcome(out _));
        _now += TimeSpan.FromSeconds(5);
        Assert.True(
            _client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out CommandLong command)
                && command.Param1 == 3);
    }

    [Fact]
    public void TemporarilyRejected_EverySendingAnswered_IsRefused()
    {
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.PreflightCalibration));
        for (int rejections = 1; rejections <= 4; rejections++)
        {
            Assert.True(_client.TryTakeFrame(_now, out _));
            Answer(MavCmd.PreflightCalibration, MavResult.TemporarilyRejected);
            _now = _client.NextDue;
        }

        AssertOutcome(MavlinkCommandStatus.Refused, MavResult.TemporarilyRejected);
    }

    // The vehicle executes the first copy, whose IN_PROGRESS was lost, and is busy with it when the later copies
    // arrive.
    [Fact]
    public void TemporarilyRejected_FirstSendingUnanswered_IsUnknown()
    {
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.PreflightCalibration));
        Assert.True(_client.TryTakeFrame(_now, out _));
        int sent = 1;
        for (_now = _client.NextDue; _client.TryTakeFrame(_now, out MavlinkFrame copy); _now = _client.NextDue, sent++)
        {
            Assert.True(copy.TryDecode(out CommandLong command) && command.Confirmation == sent);
            Answer(MavCmd.PreflightCalibration, MavResult.TemporarilyRejected);
        }

        AssertOutcome(MavlinkCommandStatus.Unknown, null);
        Assert.Equal(4, sent);   // a rejection gives no new tries
    }

    [Fact]
    public void TemporarilyRejected_FirstSendingUnanswered_TheFinalAnswerStillCounts()
    {
        Begin(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.PreflightCalibration));
        Assert.True(_client.TryTakeFrame(_now, out _));
        _now = _client.NextDue;
        Assert.True(_client.TryTakeFrame(_now, out _));
        Answer(MavCmd.PreflightCalibration, MavResult.TemporarilyRejected);
        Answer(MavCmd.PreflightCalibration, MavResult.Accepted);
        AssertOutcome(MavlinkCommandStatus.Accepted, MavResult.Accepted);
    }

    [Fact]
    public void Param7_IsZ_InBothForms()
    {
        MavlinkCommand command = MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.NavTakeoff, param7: 30);
        Assert.Equal((30f, 30f), (command.Param7, command.Z));
        Assert.Equal(40f, (command with { Param7 = 40 }).Z);
        Assert.Equal(50f, (command with { Z = 50 }).Param7);
        Assert.Equal(command with { Param7 = 40 }, command with { Z = 40 });
    }

    [Fact]
    public void MoreThanThereIsRoom_IsNotTaken()
    {
        var client = new MavlinkCommandClient(ScriptedVehicle.Companion(), new MavlinkCommandOptions { Capacity = 1 });
        Assert.True(client.TryStart(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode), Start, out _));
        Assert.False(client.TryStart(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode), Start, out _));
        Assert.Throws<ArgumentException>(() => client.TryStart(default, Start, out _));
    }

    private int Begin(MavlinkCommand command)
    {
        Assert.True(_client.TryStart(command, _now, out int handle));
        return handle;
    }

    private void Answer(MavCmd command, MavResult result, byte progress = byte.MaxValue) => _client.Handle(
        Vehicle.Create(
            new CommandAck
            {
                Command = command,
                Result = result,
                Progress = progress,
                TargetSystem = 1,
                TargetComponent = 191
            }),
        _now);

    private void AssertOutcome(MavlinkCommandStatus status, MavResult? result)
    {
        Assert.True(_client.TryTakeOutcome(out MavlinkCommandOutcome outcome));
        Assert.Equal((status, result), (outcome.Status, outcome.Result));
        Assert.False(_client.TryTakeOutcome(out _));
    }
}
