using System;
using System.Linq;
using Rabit.Links;
using Rabit.Tests.Shared;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>What goes together and what does not, with the text that a user reads.</summary>
public sealed class UavOptionsTests
{
    private const string Flight = "tlog:a.tlog?speed=10";

    [Theory]
    [InlineData("tlog:a.tlog?speed=10 plays at another pace than udpin:0.0.0.0:14550; a log at another speed than 1 "
        + "goes with logs of the same speed only.",
        Flight, "udpin:0.0.0.0:14550")]
    [InlineData("tlog:a.tlog?speed=10 plays at another pace than udpin:0.0.0.0:14550; a log at another speed than 1 "
        + "goes with logs of the same speed only.",
        "udpin:0.0.0.0:14550", Flight)]
    [InlineData("tlog:a.tlog?speed=10 plays at another pace than tlog:b.tlog?speed=20; a log at another speed than 1 "
        + "goes with logs of the same speed only.",
        Flight, "tlog:b.tlog?speed=20")]
    [InlineData("tlog:a.tlog?speed=10 plays at another pace than tlog:b.tlog; a log at another speed than 1 goes with "
        + "logs of the same speed only.",
        Flight, "tlog:b.tlog")]
    [InlineData("tlog:a.tlog?speed=max plays at another pace than tlog:a.tlog?speed=10; a log at another speed than 1 "
        + "goes with logs of the same speed only.",
        "tlog:a.tlog?speed=max", Flight)]
    [InlineData("link udpin:0.0.0.0:14550 is given 2 times.", "udpin:0.0.0.0:14550", "UDPIN:0.0.0.0:14550")]
    [InlineData("link tlog:a.tlog is given 3 times.", "tlog:a.tlog", "tlog:a.tlog?speed=1", "tlog:a.tlog?speed=1.0")]
    [InlineData("A UAV needs at least one link.")]
    public void Open_LinksThatDoNotGoTogether_SaysWhich(string expected, params string[] links)
        => AssertRefused(expected, new UavOptions { Links = links.Select(LinkUrl.Parse).ToList() });

    [Fact]
    public void Open_SeveralFaults_NamesThemAll()
        => AssertRefused(
            "SystemId is 0; it must be 1 to 255; ComponentId is 0; it must be 1 to 255; link tlog:a.tlog is given 2 "
                + "times.",
            new UavOptions
            {
                Links = [LinkUrl.Parse("tlog:a.tlog"), LinkUrl.Parse("tlog:a.tlog")],
                SystemId = 0,
                ComponentId = 0
            });

    [Fact]
    public void Open_NoListOfLinks_SaysSo()
    {
        AssertRefused("A UAV needs at least one link.", new UavOptions { Links = null! });
        AssertRefused("A link is null.", new UavOptions { Links = [null!] });
        Assert.Throws<ArgumentNullException>(() => UavSystem.Open(null!));
    }

    [Fact]
    public void Open_SecondLinkCannotBeOpened_ClosesTheFirst()
    {
        int port = FreePort.Udp();

        var fault = Assert.Throws<LinkException>(() => UavSystem.Open(new UavOptions
        {
            Links = [LinkUrl.Parse($"udpin:127.0.0.1:{port}"), LinkUrl.Parse("tlog:/nowhere/a.tlog")],
        }));

        Assert.Equal("link tlog:/nowhere/a.tlog: no such file", fault.Message);
        using UdpListenLink again = UdpListenLink.Open("127.0.0.1", port);
    }

    [Theory]
    [InlineData(5, 19, "Mission Control: Mission in layer 5, 95.0 m above layer 0: heightMetres is 135; it must be 5 "
        + "to 120; with 19.0 m from one layer to the next there is room for 5 vehicles, in layers 0 to 4.")]
    [InlineData(1, 90, "Mission Control: Mission in layer 1, 90.0 m above layer 0: heightMetres is 130; it must be 5 "
        + "to 120; with 90.0 m from one layer to the next there is room for 1 vehicle, in layer 0.")]
    public void Open_LayerAboveTheLimit_SaysHowManyVehiclesThereIsRoomFor(int layer, double spacing, string expected)
        => AssertRefused(expected, InGroup(new GroupOptions { HeightLayer = layer, LayerSpacingMetres = spacing }));

    [Fact]
    public void Open_LayersUpToTheLimit_AreAllowed()
        => UavSystem.Open(InGroup(new GroupOptions { HeightLayer = 4, LayerSpacingMetres = 20 })).Dispose();

    private static UavOptions InGroup(GroupOptions group) => new()
    {
        OpenLinks = [new MemoryLinkPair("vehicle").A],
        Mission = MissionPlan.Parse(MissionRig.Text(), "mission"),
        MayCommand = true,
        MissionControl = new MissionControlOptions { Group = group },
    };

    private static void AssertRefused(string expected, UavOptions options)
    {
        var fault = Assert.Throws<ArgumentException>(() => UavSystem.Open(options));
        Assert.StartsWith(expected, fault.Message, StringComparison.Ordinal);
        Assert.Equal("options", fault.ParamName);
    }
}
