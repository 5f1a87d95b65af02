using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>What the options of a link do: who may send what over it, and what is said of it.</summary>
public sealed class LinkSettingsTests
{
    private static readonly byte[] Autopilot = Frames.Heartbeat(system: 1, component: 1);
    private static readonly byte[] Radio = Frames.Heartbeat(system: 51, component: 68);
    private static readonly byte[] Text = Frames.Of(new Statustext { Severity = MavSeverity.Info }, 1, 1);

    [Fact]
    public void ListenOnly_WhatComesIn_IsCountedAndGoesNowhere()
    {
        using CommunicationsRig rig = Rig("listen-only");

        rig.Send(0, Autopilot);
        rig.Send(1, Text);

        Assert.Empty(rig.Received(1));
        Assert.Equal(Text, rig.Received(0));
        LinkStatus status = Status(rig, 0);
        Assert.Equal((1L, 1L, 1L), (status.FramesIn, status.FramesFilteredIn, status.FramesOut));
    }

    [Fact]
    public void ReceiveOnly_NothingGoesOut_AndWhatComesInIsForwarded()
    {
        using CommunicationsRig rig = Rig("receive-only");

        rig.Send(0, Autopilot);
        rig.Send(1, Text);

        Assert.Equal(Autopilot, rig.Received(1));
        Assert.Empty(rig.Received(0));
    }

    [Theory]
    [InlineData("deny-out=253", "hr")]
    [InlineData("deny-out=@51/68", "ht")]
    [InlineData("deny-out=@51+253", "h")]
    [InlineData("allow-out=253", "t")]
    [InlineData("allow-out=@1/1", "ht")]
    [InlineData("allow-out=0+@1", "h")]
    [InlineData("allow-out=0+253", "hrt")]
    [InlineData("deny-in=0", "hrt")]
    [InlineData("deny=0", "t")]
    [InlineData("allow=0+253,position=no", "hrt")]
    public void Filter_WhatGoesOut_IsThatWhichIsLetOut(string options, string passed)
    {
        using CommunicationsRig rig = Rig(options);

        rig.Send(1, Autopilot);
        rig.Send(1, Radio);
        rig.Send(1, Text);

        Dictionary<char, byte[]> frames = new() { ['h'] = Autopilot, ['r'] = Radio, ['t'] = Text };
        Assert.Equal(Frames.Join(passed.Select(f => frames[f])), rig.Received(0));
        Assert.Equal(3 - passed.Length, Status(rig, 0).FramesFilteredOut);
    }

    [Theory]
    [InlineData("deny-in=253", "hr")]
    [InlineData("allow-in=@51", "r")]
    [InlineData("deny=@1", "r")]
    [InlineData("deny-out=0", "hrt")]
    public void Filter_WhatComesIn_IsThatWhichIsLetIn(string options, string passed)
    {
        using CommunicationsRig rig = Rig(options);

        rig.Send(0, Autopilot);
        rig.Send(0, Radio);
        rig.Send(0, Text);

        Dictionary<char, byte[]> frames = new() { ['h'] = Autopilot, ['r'] = Radio, ['t'] = Text };
        Assert.Equal(Frames.Join(passed.Select(f => frames[f])), rig.Received(1));
        Assert.Equal(3 - passed.Length, Status(rig, 0).FramesFilteredIn);
    }

    [Fact]
    public void Status_OfANamedOptionalLink_SaysSo()
    {
        using CommunicationsRig rig = Rig("name=radio,optional");

        LinkStatus status = Status(rig, 0);

        Assert.Equal(("radio", true), (status.Name, status.IsOptional));
        Assert.Equal((null, false), (Status(rig, 1).Name, Status(rig, 1).IsOptional));
    }

    [Theory]
    [InlineData(99)]
    [InlineData(0)]
    [InlineData(-1)]
    public void Settings_RateThatCarriesNothing_IsRefusedByName(int rate)
    {
        var options = new CommunicationsOptions
        {
            Links = [new MemoryLinkPair("a").A],
            LinkSettings = new Dictionary<int, LinkSettings> { [0] = new() { BytesPerSecond = rate } },
        };

        var fault = Assert.Throws<ArgumentException>(() => new CommunicationsManager(options));

        Assert.Contains(
            $"LinkSettings of link 0: BytesPerSecond is {rate}; it must be at least 100", fault.Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Settings_OfALinkThatIsNotThere_AreRefused()
    {
        var options = new CommunicationsOptions
        {
            Links = [new MemoryLinkPair("a").A],
            LinkSettings = new Dictionary<int, LinkSettings> { [1] = new() { IsOptional = true } },
        };

        var fault = Assert.Throws<ArgumentException>(() => new CommunicationsManager(options));

        Assert.Contains(
            "LinkSettings has link 1, but there are 1 links, numbered from 0", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void LinkKeys_TwoLinksWithTwoKeys_AreSignedAndVerifiedByTheirOwn()
    {
        using MavlinkSigningKey first = MavlinkSigningKey.FromPassphrase("the first link");
        using MavlinkSigningKey second = MavlinkSigningKey.FromPassphrase("the second link");
        using CommunicationsRig rig = new CommunicationsRig(links: 3, o => o.Signing = new SigningOptions(first)
        {
            Links = [0],
            LinkKeys = new Dictionary<int, MavlinkSigningKey> { [1] = second },
        }).As(1);
        var heartbeat = MavlinkFrame.Create(new Heartbeat { Type = MavType.Gcs }, 255, 190, 0);
        byte crcExtra = CrcExtraOf(heartbeat);

        rig.Send(0, Frames.Bytes(Sign(heartbeat, crcExtra, first)));
        rig.Send(1, Frames.Bytes(Sign(heartbeat, crcExtra, second)));
        rig.Send(1, Frames.Bytes(Sign(heartbeat, crcExtra, first)));
        rig.Send(0, Frames.Bytes(Sign(heartbeat, crcExtra, second)));

        Assert.Equal((1L, 1L), (Status(rig, 0).Signatures.Valid, Status(rig, 0).Signatures.BadSignatures));
        Assert.Equal((1L, 1L), (Status(rig, 1).Signatures.Valid, Status(rig, 1).Signatures.BadSignatures));
    }

    private static byte CrcExtraOf(in MavlinkFrame frame)
        => MavlinkDialect.All.TryGetMessage(frame.MessageId, out MavlinkMessageInfo info) ? info.CrcExtra : (byte)0;

    private static MavlinkFrame Sign(in MavlinkFrame frame, byte crcExtra, MavlinkSigningKey key)
    {
        var clock = new MavlinkSigningClock();
        clock.Advance(new DateTime(2030, 1, 1, 0, 0, 0, DateTimeKind.Utc), TimeSpan.Zero);
        return new MavlinkSigner(key, 7, clock).Sign(frame, crcExtra);
    }

    private static CommunicationsRig Rig(string options)
        => new(links: 2, o => o.LinkSettings = new Dictionary<int, LinkSettings>
        {
            [0] = LinkUrl.Parse("tcp:127.0.0.1:5760," + options).Settings,
        });

    private static LinkStatus Status(CommunicationsRig rig, int link)
    {
        rig.Run(TimeSpan.FromSeconds(1));
        return rig.Status(link);
    }
}
