using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The autopilot is asked for the version of its firmware.</summary>
public class VersionRequestTests
{
    [Fact]
    public void Version_Found_IsAskedUntilItIsAnswered()
    {
        using AutopilotRig rig = MakeRig();
        rig.Run(3);
        Assert.Empty(Asked(rig));
        rig.Beat(2);
        int asked = Asked(rig).Length;
        Assert.Equal([MavCmd.RequestAutopilotCapabilities, MavCmd.RequestMessage], Asked(rig).Take(2));
        rig.Send(new AutopilotVersion { FlightSwVersion = 0x0405_07FF });
        rig.Beat(10);
        Assert.Equal(asked, Asked(rig).Length);
    }

    [Fact]
    public void Version_Unanswered_IsGivenUpUntilAReboot()
    {
        using AutopilotRig rig = MakeRig();
        rig.Send(new SystemTime { TimeBootMs = 100_000 });
        rig.Beat(20);
        Assert.Equal(6, Asked(rig).Length);
        rig.Send(new SystemTime { TimeBootMs = 100_000 });
        rig.Beat(1);
        rig.Sink.Frames.Clear();
        rig.Send(new SystemTime { TimeBootMs = 2_000 });
        rig.Send(new SystemTime { TimeBootMs = 2_100 });
        rig.Run();
        Assert.Single(Asked(rig));
    }

    [Fact]
    public void Version_OfAnotherComponent_IsNotTaken()
    {
        using AutopilotRig rig = MakeRig();
        rig.Beat(1);
        rig.Send(new AutopilotVersion { FlightSwVersion = 0x0405_07FF }, component: 154);
        rig.Beat(5);
        Assert.Equal(6, Asked(rig).Length);
    }

    [Theory]
    [InlineData(0x0405_07FFu, "4.5.7")]
    [InlineData(0x0405_07C1u, "4.5.7 release candidate")]
    [InlineData(0x010F_0080u, "1.15.0 beta")]
    [InlineData(0x010F_0040u, "1.15.0 alpha")]
    [InlineData(0x010F_0000u, "1.15.0 development")]
    public void Take_AVersion_SaysItOnce(uint version, string text)
    {
        var requester = new VersionRequester();
        Assert.Equal(text, requester.Take(new AutopilotVersion { FlightSwVersion = version }));
        Assert.Null(requester.Take(new AutopilotVersion { FlightSwVersion = version }));
    }

    private static AutopilotRig MakeRig() => new(new AutopilotOptions { RequestedRates = [] });

    private static MavCmd[] Asked(AutopilotRig rig) => rig.Sink.MessagesOf<CommandLong>()
        .Select(c => c.Command)
        .Where(c => c is MavCmd.RequestAutopilotCapabilities or MavCmd.RequestMessage).ToArray();
}
