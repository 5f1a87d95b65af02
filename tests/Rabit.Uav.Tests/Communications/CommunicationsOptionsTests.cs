using System;
using System.Linq;
using Rabit.Uav.Communications;
using Rabit.Links;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

public sealed class CommunicationsOptionsTests
{
    [Fact]
    public void Manager_OptionsOutOfRange_NamesThemAll()
    {
        var fault = Assert.Throws<ArgumentException>(() => new CommunicationsManager(
            new CommunicationsOptions { FramesWaitingIn = 0, FramesWaitingOut = -1, SilentAfter = TimeSpan.Zero }));

        Assert.StartsWith(
            "Communications: there is no link; FramesWaitingIn is 0; it must be at least 1; FramesWaitingOut is -1; it "
            + "must be at least 1; "
            + "SilentAfter is 00:00:00; it must be above zero.",
            fault.Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Manager_TooManyLinks_SaysHowManyArePossible()
    {
        var options = new CommunicationsOptions
        {
            Links = Enumerable.Repeat(new MemoryLinkPair("many").A, 65).ToList()
        };

        Assert.Contains(
            "there are 65 links; at most 64 are possible",
            Assert.Throws<ArgumentException>(() => new CommunicationsManager(options)).Message);
    }

    [Fact]
    public void Manager_ListIsNull_SaysSo()
        => Assert.Contains("not null", Assert.Throws<ArgumentException>(
            () => new CommunicationsManager(new CommunicationsOptions { Links = null! })).Message);
}
