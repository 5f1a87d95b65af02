using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class ReopeningSerialLinkTests : ReopeningLinkContract
{
    protected override string PeerGoneReason => "the device hung up (unplugged?)";

    protected override ReopeningBed OpenBed(LinkOptions options) => new PlugBed(options);

    [Fact]
    public void Open_NoSerialDevice_SaysSoAtOnce()
        => Assert.Contains(
            "this is not a serial device",
            Assert.Throws<LinkException>(() => ReopeningLink.Open(LinkUrl.Parse("serial:/dev/null:57600"))).Message,
            StringComparison.Ordinal);

    [Fact]
    public void Read_PluggedInAgainUnderAnotherNumber_GoesOn()
    {
        using var bed = new PlugBed(Quick);
        var collector = new LinkCollector(bed.Link);
        bed.ComeUp();
        bed.AwaitPeer();
        string first = bed.Device;

        bed.PeerGoes();
        List<PseudoTerminal> holders = HoldNumbersUpTo(first);
        bed.ComeUp();
        bed.AwaitPeer();
        bed.PeerSends(9);

        Assert.Equal(new byte[] { 9 }, collector.Take(1));
        Assert.NotEqual(first, bed.Device);
        holders.ForEach(h => h.Dispose());
    }

    // A new terminal has the least number that is free; other tests take and free numbers meanwhile.
    private static List<PseudoTerminal> HoldNumbersUpTo(string path)
    {
        var holders = new List<PseudoTerminal> { new() };
        while (holders[holders.Count - 1].Path != path && holders.Count < 64)
            holders.Add(new PseudoTerminal());
        return holders;
    }

    /// <summary>A name that stays, as those in /dev/serial/by-id, for a device that comes and goes.</summary>
    private sealed class PlugBed : ReopeningBed
    {
        private readonly string _folder = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString("N"));
        private readonly string _name;
        private PseudoTerminal? _terminal;
        private long _openings;

        public PlugBed(LinkOptions options)
        {
            Directory.CreateDirectory(_folder);
            _name = Path.Combine(_folder, "usb-lidar");
            Link = ReopeningLink.Open(LinkUrl.Parse($"serial:{_name}:57600"), options);
        }

        public override IByteLink Link { get; }

        public string Device => _terminal!.Path;

        public override void ComeUp()
        {
            _openings = Link.Counters.Openings;
            _terminal = new PseudoTerminal();
            _terminal.LinkTo(_name);
        }

        public override void AwaitPeer()
            => Await(() => Link.State == ByteLinkState.Open && Link.Counters.Openings > _openings);

        public override void PeerSends(params byte[] bytes) => _terminal!.Write(bytes);

        public override byte[] PeerReceives(int count) => _terminal!.Read(count);

        public override void PeerGoes()
        {
            File.Delete(_name);
            _terminal?.Dispose();
        }
    }
}
