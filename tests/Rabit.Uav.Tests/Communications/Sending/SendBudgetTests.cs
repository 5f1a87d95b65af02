using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>Links with and without a budget, through Communications.</summary>
public sealed class SendBudgetTests
{
    [Fact]
    public void ForwardedBulk_MoreThanTheBudget_GoesOutAtItsRateAndOwnHeartbeatsAtOnce()
    {
        using CommunicationsRig rig = Rig(new SendBudget()).As(1);
        rig.Send(0, Enumerable.Range(0, 60).Select(n => Bulk((byte)n)).ToArray());
        rig.Run(TimeSpan.FromMilliseconds(100));
        rig.Received(1);
        rig.Received(2);

        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });   // runs 0.2 s
        List<MavlinkFrame> first = rig.ReceivedFrames(1);
        int bytes = first.Sum(f => f.WireLength);
        for (int n = 0; n < 8; n++)
        {
            rig.Run(TimeSpan.FromMilliseconds(100));
            bytes += rig.Received(1).Length;
        }

        Assert.Equal(Heartbeat.MavlinkId, first[0].MessageId);
        Assert.InRange(bytes, 0.9 * 3600, 3600 + 560);
        LinkBudgetStatus budget = rig.LastStatus(1).Budget;
        Assert.Equal(1, budget.Urgent.Sent);
        Assert.True(budget.Bulk.Sent >= 10 && budget.Waiting > 20, $"{budget.Bulk.Sent} sent, {budget.Waiting} waiting");
    }

    [Fact]
    public void OwnFrames_ThatOvertakeEachOther_AreNumberedAsTheyGoOut()
    {
        using CommunicationsRig rig = Rig(new SendBudget { BytesPerSecond = 500 }).As(1);
        var frames = new List<MavlinkFrame>();
        for (int n = 0; n < 10; n++)
        {
            rig.SendOwn(new Statustext { Severity = MavSeverity.Info, Id = 1 });
            rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
            frames.AddRange(rig.ReceivedFrames(1));
        }

        Assert.Equal(Enumerable.Range(0, frames.Count).Select(n => (byte)n), frames.Select(f => f.Sequence));
        Assert.Contains(frames, f => f.MessageId == Statustext.MavlinkId);
    }

    [Fact]
    public void Link_WithoutABudget_SendsAllAtOnce()
    {
        using CommunicationsRig rig = Rig(new SendBudget()).As(1);
        rig.Send(0, Enumerable.Range(0, 60).Select(n => Bulk((byte)n)).ToArray());

        Assert.Equal(60, rig.ReceivedFrames(2).Count);
        Assert.Equal(0, rig.Status(2).Budget.BytesPerSecond);
    }

    [Fact]
    public void RadioStatus_OfTheLink_SlowsItDown()
    {
        using CommunicationsRig rig = Rig(new SendBudget()).As(1);
        for (int n = 0; n < 3; n++)
            rig.Send(1, Frames.Of(new RadioStatus { Txbuf = 10 }, 51, 68, (byte)n));
        rig.Send(2, Frames.Of(new RadioStatus { Txbuf = 10 }, 52, 68));

        Assert.Equal(3600 * 0.8 * 0.8 * 0.8, rig.Status(1).Budget.BytesPerSecond, 3);
    }

    [Fact]
    public void Stop_FramesThatWait_UrgentOnesAndCommandsStillGoOut()
    {
        using CommunicationsRig rig = Rig(new SendBudget { BytesPerSecond = 100 }).As(1);
        rig.Send(1, Frames.Heartbeat(system: 7));
        rig.SendOwn(new Statustext { Severity = MavSeverity.Info, Id = 1 });
        rig.Received(1);
        rig.SendOwn(Frames.Command(7, 1));
        Assert.Empty(rig.ReceivedFrames(1));

        rig.Finish();

        Assert.Equal(CommandLong.MavlinkId, Assert.Single(rig.ReceivedFrames(1)).MessageId);
    }

    [Theory]
    [InlineData(99, 560, "BytesPerSecond is 99; it must be at least 100")]
    [InlineData(100, 20, "BurstBytes is 20; it must be at least the longest frame, 280")]
    public void Options_OutOfRange_AreNamed(int rate, int burst, string expected)
    {
        var budget = new SendBudget { BytesPerSecond = rate, BurstBytes = burst };
        var fault = Assert.Throws<ArgumentException>(() => Rig(budget));
        Assert.Contains("SendBudgets of link 1: " + expected, fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Options_LinkThatIsNotThere_IsNamed()
    {
        var fault = Assert.Throws<ArgumentException>(() => new CommunicationsRig(
            links: 1, o => o.SendBudgets = new Dictionary<int, SendBudget> { [5] = new SendBudget() }));
        Assert.Contains("SendBudgets names link 5; there are 1 live links", fault.Message, StringComparison.Ordinal);
    }

    // Link 1 has the budget.
    private static CommunicationsRig Rig(SendBudget budget)
        => new(links: 3, o => o.SendBudgets = new Dictionary<int, SendBudget> { [1] = budget });

    private static byte[] Bulk(byte sequence)
    {
        var content = new byte[251];
        content[250] = 1;
        return Frames.Of(new FileTransferProtocol { Payload = new ByteArray251(content) }, 255, 190, sequence);
    }
}
