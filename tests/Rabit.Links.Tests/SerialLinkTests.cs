using System;
using System.IO;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class SerialLinkTests : FillingLinkContract
{
    protected override string PeerGoneReason => "the device hung up (unplugged?)";

    protected override LinkTestBed Open(LinkOptions options) => new SerialBed(options);

    [Theory]
    [InlineData(57600)]
    [InlineData(921600)]
    [InlineData(250000)]
    [InlineData(420000)]
    public void Open_StandardAndUnusualRate_Works(int baudRate)
    {
        using var terminal = new PseudoTerminal();
        using IByteLink link = LinkFactory.Open(LinkUrl.Parse($"serial:{terminal.Path}:{baudRate}"));

        link.Write(new byte[] { 1, 2, 3 }, 0, 3);

        Assert.Equal(new byte[] { 1, 2, 3 }, terminal.Read(3));
        Assert.Equal($"serial:{terminal.Path}:{baudRate}", link.Url);
    }

    [Theory]
    [InlineData("/dev/no-such-serial-device", "there is no such device")]
    [InlineData("/dev/null", "this is not a serial device")]
    [InlineData("/dev", "this is not a serial device")]
    public void Open_WrongDevice_SaysWhatIsWrong(string path, string reason)
    {
        var fault = Assert.Throws<LinkException>(() => SerialLink.Open(path, 57600));

        Assert.Equal($"link serial:{path}:57600: cannot open: {reason}", fault.Message);
        Assert.True(fault.LinkEnded);
    }

    [Fact]
    public void Open_OrdinaryFile_SaysThatItIsNoSerialDevice()
    {
        string path = Path.GetTempFileName();
        try
        {
            var fault = Assert.Throws<LinkException>(() => SerialLink.Open(path, 57600));

            Assert.Equal($"link serial:{path}:57600: cannot open: this is not a serial device", fault.Message);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void Describe_NoPermission_NamesTheGroup() =>
        Assert.Contains("'dialout'", Errno.Describe(Errno.AccessDenied), StringComparison.Ordinal);

    [Theory]
    [InlineData(0)]
    [InlineData(-57600)]
    public void Open_BadBaudRate_Throws(int baudRate) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => SerialLink.Open("/dev/ttyAMA0", baudRate));

    [Fact]
    public void Read_WhileGarbageIsCollected_GoesOnWaiting()
    {
        using var bed = new SerialBed(LinkOptions.Default);
        var collector = new LinkCollector(bed.Link);

        for (int i = 0; i < 50; i++) GC.Collect(); // each interrupts a poll under Mono
        Assert.False(collector.EndsWithin(TimeSpan.Zero));

        bed.PeerSends(5);
        Assert.Equal(new byte[] { 5 }, collector.Take(1));
    }

    [Fact]
    public void Dispose_WhileOthersReadAndUnblock_NeverLeavesAReadWaiting()
    {
        for (int attempt = 0; attempt < 50; attempt++)
        {
            using var bed = new SerialBed(LinkOptions.Default);
            var collector = new LinkCollector(bed.Link);
            var unblocker = new System.Threading.Thread(bed.Link.Unblock);
            unblocker.Start();

            bed.Link.Dispose();

            Assert.True(collector.EndsWithin(LinkTestBed.TestTimeout));
            Assert.True(unblocker.Join(LinkTestBed.TestTimeout));
        }
    }

    [SocatFact]
    public void ReadAndWrite_BetweenTwoSerialLinks_ArriveUntilUnplugged()
    {
        using var cable = new SocatCable();
        using SerialLink one = SerialLink.Open(cable.FirstDevice, 115200);
        using SerialLink other = SerialLink.Open(cable.SecondDevice, 115200);
        var collector = new LinkCollector(other);
        var oneCollector = new LinkCollector(one);
        byte[] bytes = new byte[20_000];
        for (int i = 0; i < bytes.Length; i++) bytes[i] = (byte)i;

        one.Write(bytes, 0, bytes.Length);
        Assert.Equal(bytes, collector.Take(bytes.Length));

        cable.Unplug();
        Assert.Equal(PeerGoneReason, collector.WaitForEnd().Reason);
        Assert.Equal(PeerGoneReason, oneCollector.WaitForEnd().Reason);
    }

    private sealed class SerialBed : LinkTestBed
    {
        private readonly PseudoTerminal _terminal = new();

        public SerialBed(LinkOptions options) => Link = SerialLink.Open(_terminal.Path, 57600, options);

        public override IByteLink Link { get; }

        public override void PeerSends(params byte[] bytes) => _terminal.Write(bytes);

        public override byte[] PeerReceives(int count) => _terminal.Read(count);

        public override void PeerGoes() => _terminal.Dispose();
    }
}
