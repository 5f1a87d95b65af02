using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// MAVLink's address rules, from link to link and to Autopilot Interface (docs/managers/communications.md).
/// </summary>
public sealed class RoutingTests
{
    public static TheoryData<string> Broadcasts => [.. BroadcastFrames.Keys];

    private static Dictionary<string, byte[]> BroadcastFrames { get; } = new(System.StringComparer.Ordinal)
    {
        ["MAVLink 2"] = Frames.Heartbeat(),
        ["MAVLink 1"] = Frames.Of(new Heartbeat { MavlinkVersion = 3 }, version: MavlinkVersion.V1),
        ["MAVLink 2 with its last zeros"] = Frames.Raw(Heartbeat.MavlinkId, [1, 0, 0, 0, 2, 3, 0, 0, 0], crcExtra: 50),
        ["MAVLink 2, signed"] = Frames.Raw(
            Heartbeat.MavlinkId, [1, 0, 0, 0, 2, 3, 4, 5, 3], crcExtra: 50, isSigned: true),
    };

    [Theory]
    [MemberData(nameof(Broadcasts))]
    public void Broadcast_GoesToAutopilotAndToAllOtherLinksUnchanged(string kind)
    {
        byte[] bytes = BroadcastFrames[kind];
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);

        rig.Send(1, bytes);

        LinkFrame taken = Assert.Single(rig.Autopilot.Taken);
        Assert.Equal((1, 0L), (taken.Link, taken.Index));
        Assert.Equal(Frames.Hex(bytes), Frames.Hex(Frames.Bytes(taken.Frame)));
        Assert.Equal(Frames.Hex(bytes), Frames.Hex(rig.Received(0)));
        Assert.Equal(Frames.Hex(bytes), Frames.Hex(rig.Received(2)));
        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void Addressed_TargetSeenOnALink_GoesThereAlone()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);
        rig.Send(0, Frames.Heartbeat(system: 1));
        rig.Send(2, Frames.Heartbeat(system: 255, component: 190));
        ForgetAll(rig);

        byte[] command = Frames.Of(Frames.Command(1, 1), 255, 190);
        rig.Send(2, command);

        Assert.Equal(Frames.Hex(command), Frames.Hex(rig.Received(0)));
        Assert.Empty(rig.Received(1));
        Assert.Empty(rig.Received(2));
        Assert.Empty(rig.Autopilot.Taken);
    }

    [Fact]
    public void Addressed_TargetSeenOnTwoLinks_GoesToBothButNeverBack()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);
        rig.Send(0, Frames.Heartbeat(system: 7));
        rig.Send(1, Frames.Heartbeat(system: 7));
        rig.Send(2, Frames.Heartbeat(system: 7));
        ForgetAll(rig);

        rig.Send(2, Frames.Of(Frames.Command(7, 0), 255, 190));

        Assert.Single(rig.ReceivedFrames(0));
        Assert.Single(rig.ReceivedFrames(1));
        Assert.Empty(rig.Received(2));
    }

    [Fact]
    public void Addressed_TargetNeverSeen_GoesNowhere()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);

        rig.Send(0, Frames.Of(Frames.Command(9, 1), 255, 190));
        rig.Send(0, Frames.Of(Frames.Command(1, 77), 255, 190));

        Assert.Empty(rig.Received(1));
        Assert.Empty(rig.Autopilot.Taken);
    }

    [Fact]
    public void Addressed_ToUs_IsHandedOverAndGoesNoFurther()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(1, Frames.Heartbeat());
        ForgetAll(rig);

        rig.Send(0, Frames.Of(Frames.Command(1, 191), 255, 190));

        Assert.Single(rig.Autopilot.Taken);
        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void Addressed_ToAllOfOurSystem_IsHandedOverAndGoesWhereItWasSeen()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);
        rig.Send(1, Frames.Heartbeat());
        ForgetAll(rig);

        rig.Send(0, Frames.Of(Frames.Command(1, 0), 255, 190));

        Assert.Single(rig.Autopilot.Taken);
        Assert.Single(rig.ReceivedFrames(1));
        Assert.Empty(rig.Received(2));
    }

    [Fact]
    public void Addressed_BeforeWeKnowWhoWeAre_StillReachesItsTarget()
    {
        using var rig = new CommunicationsRig(links: 2);
        rig.Send(0, Frames.Heartbeat(system: 1));
        rig.Send(1, Frames.Heartbeat(system: 255, component: 190));
        ForgetAll(rig);

        rig.Send(1, Frames.Of(Frames.Command(1, 1), 255, 190));
        rig.Send(0, Frames.Of(new CommandAck { TargetSystem = 255, TargetComponent = 190 }));

        Assert.Single(rig.ReceivedFrames(0));
        Assert.Single(rig.ReceivedFrames(1));
    }

    [Theory]
    [InlineData(nameof(SetupSigning))]
    [InlineData(nameof(RadioStatus))]
    public void LinkLocal_IsNeverForwarded(string message)
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(1, Frames.Heartbeat(system: 7));
        ForgetAll(rig);

        rig.Send(0, message == nameof(RadioStatus)
            ? Frames.Of(new RadioStatus { Rssi = 1 }, 51, 68)
            : Frames.Of(new SetupSigning { TargetSystem = 7, TargetComponent = 1 }, 255, 190));

        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void UnknownId_IsForwardedUnchangedAndNotHandedOver()
    {
        byte[] bytes = Frames.Raw(Frames.UnknownId, [1, 2, 3, 0, 0], crcExtra: 77);
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);

        rig.Send(0, Frames.Heartbeat(), bytes, Frames.Heartbeat(sequence: 1));

        Assert.Equal(
            Frames.Hex(Frames.Join([Frames.Heartbeat(), bytes, Frames.Heartbeat(sequence: 1)])),
            Frames.Hex(rig.Received(1)));
        Assert.Equal(2, rig.Autopilot.Taken.Count);
    }

    [Fact]
    public void OurOwnAddress_ComingIn_IsCountedAndGoesNowhere()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);

        rig.Send(0, Frames.Heartbeat(system: 1, component: 191));

        Assert.Empty(rig.Received(1));
        Assert.Empty(rig.Autopilot.Taken);
        Assert.Equal(1, rig.Manager.SummariseLinks()[0].Frames);
    }

    [Fact]
    public void Frames_InAnyPieces_ComeInOrderWithTheirIndex()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        byte[] bytes = Frames.Join(Enumerable.Range(0, 50).Select(n => Frames.Heartbeat(sequence: (byte)n)));

        for (int at = 0; at < bytes.Length; at += 7)
            rig.Send(0, bytes.Skip(at).Take(7).ToArray());

        Assert.Equal(Enumerable.Range(0, 50).Select(n => (long)n), rig.Autopilot.Taken.Select(f => f.Index));
        Assert.Equal(Enumerable.Range(0, 50).Select(n => (byte)n), rig.Autopilot.Taken.Select(f => f.Frame.Sequence));
        Assert.Equal(Frames.Hex(bytes), Frames.Hex(rig.Received(1)));
    }

    private static void ForgetAll(CommunicationsRig rig)
    {
        for (int link = 0; link < rig.Manager.SummariseLinks().Count; link++)
            rig.Received(link);
        rig.Autopilot.Taken.Clear();
    }
}
