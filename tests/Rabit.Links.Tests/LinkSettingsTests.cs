using System;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>The options behind the URL of a link.</summary>
public sealed class LinkSettingsTests
{
    [Fact]
    public void Parse_OptionsBehindASerialLine_GivesBoth()
    {
        LinkUrl url = LinkUrl.Parse(
            "serial:/dev/ttyAMA0:57600,rate=3600,name=radio,flush=50,hold=10,optional,position=no,key=/etc/key");

        Assert.Equal((LinkKind.Serial, "/dev/ttyAMA0", 57600), (url.Kind, url.Path, url.BaudRate));
        LinkSettings settings = url.Settings;
        Assert.Equal(("radio", 3600, "/etc/key"), (settings.Name, settings.BytesPerSecond, settings.KeyFile));
        Assert.Equal(
            (true, false, false, false),
            (settings.IsOptional, settings.SendsPosition, settings.IsListenOnly, settings.IsReceiveOnly));
        Assert.Equal(TimeSpan.FromMilliseconds(50), settings.FlushAfter);
        Assert.Equal(TimeSpan.FromMilliseconds(10), settings.HoldTime);
        Assert.Equal("serial:/dev/ttyAMA0:57600", url.Address);
    }

    [Fact]
    public void Parse_NoOptions_GivesNone()
        => Assert.Same(LinkSettings.None, LinkUrl.Parse("tcp:127.0.0.1:5760").Settings);

    [Theory]
    [InlineData("udpin:0.0.0.0:14550,idle=10", 10.0, null)]
    [InlineData("udpout:gcs:14550,KEEPALIVE=2.5", null, 2.5)]
    public void Parse_Times_AreInSeconds(string text, double? idle, double? keepAlive)
    {
        LinkSettings settings = LinkUrl.Parse(text).Settings;

        Assert.Equal((idle, keepAlive), (settings.IdleTime?.TotalSeconds, settings.KeepAlive?.TotalSeconds));
    }

    [Theory]
    [InlineData("serial:/dev/ttyAMA0:57600,rate=3600,name=radio")]
    [InlineData("tcpin:0.0.0.0:5760,optional")]
    [InlineData("udpbcast:192.168.1.255:14550")]
    [InlineData("tlog:flight.tlog?speed=10,name=old")]
    public void ToString_OfAParsedOne_IsTheSameText(string text) => Assert.Equal(text, LinkUrl.Parse(text).ToString());

    [Theory]
    [InlineData("serial:/dev/a,b:57600", "/dev/a,b")]
    [InlineData("serial:/dev/a,b=c:57600,name=x", "/dev/a,b=c")]
    [InlineData("tlog:a,b.tlog", "a,b.tlog")]
    [InlineData("tlog:a,speed=3.tlog", "a,speed=3.tlog")]
    [InlineData("tlog:a,b.tlog,name=x", "a,b.tlog")]
    public void Parse_CommaInAPath_BelongsToThePath(string text, string path)
        => Assert.Equal(path, LinkUrl.Parse(text).Path);

    [Theory]
    [InlineData("tcp:h:1,sped=3", "the option 'sped' is unknown; there are name, rate, flush, ")]
    [InlineData("serial:/dev/x:57600,rat=3600", "the option 'rat' is unknown")]
    [InlineData("serial:/dev/x:57600,", "the option '' is unknown")]
    [InlineData("tcp:h:1,optional=1", "the option 'optional' has no value")]
    [InlineData("tcp:h:1,rate", "the option 'rate' needs a value, rate=...")]
    [InlineData("tcp:h:1,rate=3,rate=4", "the option 'rate' is given twice")]
    [InlineData("tcp:h:1,rate=279", "rate=279 is not a number from 280 to 100000000")]
    [InlineData("tcp:h:1,rate=1e3", "rate=1e3 is not a number")]
    [InlineData("tcp:h:1,flush=0", "flush=0 is not a number from 1 to 60000")]
    [InlineData("tcp:h:1,flush=NaN", "flush=NaN is not a number from 1 to 60000")]
    [InlineData("tcp:h:1,hold=1001", "hold=1001 is not a number from 1 to 1000")]
    [InlineData("tcp:h:1,name=", "the option 'name' is empty")]
    [InlineData("tcp:h:1,position=maybe", "position=maybe is neither yes nor no")]
    [InlineData("tcp:h:1,idle=3", "the option 'idle' is for udpin only")]
    [InlineData("tcp:h:1,keepalive=3", "the option 'keepalive' is for udpout only")]
    [InlineData("tlog:f.tlog,rate=300", "the option 'rate' is for live links only")]
    [InlineData("tcp:h:1,listen-only,receive-only", "with 'listen-only' and 'receive-only' together nothing would pass")]
    [InlineData("tcp:h:1,allow=3,allow-in=4", "the option 'allow' is both 'allow-in' and 'allow-out'")]
    [InlineData("tcp:h:1,deny=x", "'x' of deny=x is neither a message id, for example 33, nor a sender")]
    [InlineData("tcp:h:1,allow-out=1+@256", "'@256' of allow-out=1+@256 is neither")]
    [InlineData("tcp:h:1,deny-in=@1/2/3", "'@1/2/3' of deny-in=@1/2/3 is neither")]
    [InlineData("tcp:h:1,deny-in=16777216", "'16777216' of deny-in=16777216 is neither")]
    public void TryParse_WrongOption_NamesIt(string text, string fault)
    {
        Assert.False(LinkUrl.TryParse(text, out _, out string? error));

        Assert.StartsWith($"link '{text}': {fault}", error, StringComparison.Ordinal);
    }

    [Fact]
    public void TryParse_RandomText_NeverThrows()
    {
        var random = new Random(16);
        const string alphabet = ":,=+@/?abc0159 []-serialtcpinudp";
        for (int i = 0; i < 20_000; i++)
        {
            char[] text = new char[random.Next(30)];
            for (int c = 0; c < text.Length; c++) text[c] = alphabet[random.Next(alphabet.Length)];
            string[] starts = { "", "tcp:", "serial:", "tlog:", "udpin:", "tcpin:h:1,", "serial:/d:9," };
            string scheme = starts[random.Next(starts.Length)];

            bool isUrl = LinkUrl.TryParse(scheme + new string(text), out LinkUrl? url, out string? error);

            Assert.True(isUrl ? url is not null : !string.IsNullOrEmpty(error), "seed 16");
        }
    }
}
