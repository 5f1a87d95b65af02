using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// What Communications notices of others' addresses, of its disk and of its links reaches the health report.
/// </summary>
public sealed class ConflictHealthTests
{
    [Fact]
    public void FramesOfTheVehicleAlone_AreNoConflict()
    {
        var pair = new MemoryLinkPair("air", 64 * 1024);
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [pair.A],
            SystemId = 1,
            Time = new VirtualTime(0),
        });
        Assert.Equal(HealthReasons.None, Run(uav, reactor =>
        {
            Put(pair.B, Frames.Heartbeat());
            reactor.RunFor(TimeSpan.FromSeconds(1));
        }) & HealthReasons.AddressConflict);
    }

    [Fact]
    public void ForgedOwnAddress_WhileItComes_IsWarnedOf()
    {
        var pair = new MemoryLinkPair("air", 64 * 1024);
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [pair.A],
            SystemId = 1,
            Time = new VirtualTime(0),
        });
        HealthReasons reasons = Run(uav, reactor =>
        {
            Put(pair.B, Frames.Heartbeat());
            reactor.RunFor(TimeSpan.FromSeconds(1));
            Put(pair.B, Frames.Heartbeat(component: 191, sequence: 200));
            reactor.RunFor(TimeSpan.FromSeconds(1));
        });
        Assert.Equal(HealthReasons.AddressConflict, reasons & HealthReasons.AddressConflict);
    }

    [Fact]
    public void Recording_ThatMissesFrames_IsWarnedOf()
    {
        string folder = Path.Combine(Path.GetTempPath(), "recording-" + Guid.NewGuid().ToString("N"));
        var pair = new MemoryLinkPair("air", 64 * 1024);
        var options = new UavOptions { OpenLinks = [pair.A], Time = new VirtualTime(0) };
        options.Communications.Recording = new RecordingOptions
        {
            Folder = folder,
            CreatesFile = _ => throw new IOException("No space left on device"),
        };
        using UavSystem uav = UavSystem.Open(options);
        HealthReasons reasons = Run(uav, reactor =>
        {
            Put(pair.B, Frames.Heartbeat());
            reactor.RunFor(TimeSpan.FromSeconds(1));
        });
        Directory.Delete(folder);
        Assert.Equal(HealthReasons.RecordingIncomplete, reasons & HealthReasons.RecordingIncomplete);
    }

    [Theory]
    [InlineData("udpin:127.0.0.1:1", HealthReasons.LinkSilent)]
    [InlineData("udpin:127.0.0.1:1,optional", HealthReasons.None)]
    public void SilentLink_ThatIsOptional_IsNoReason(string url, HealthReasons expected)
    {
        var pair = new MemoryLinkPair("air", 64 * 1024);
        var silent = new MemoryLinkPair("ground", 64 * 1024);
        var options = new UavOptions { OpenLinks = [pair.A, silent.A], Time = new VirtualTime(0) };
        options.Communications.LinkSettings = new Dictionary<int, LinkSettings> { [1] = LinkUrl.Parse(url).Settings };
        using UavSystem uav = UavSystem.Open(options);
        HealthReasons reasons = Run(uav, reactor =>
        {
            for (byte n = 0; n < 10; n++)
            {
                Put(pair.B, Frames.Heartbeat(sequence: n));
                reactor.RunFor(TimeSpan.FromSeconds(1));
            }
        });
        Assert.Equal(expected, reasons & HealthReasons.LinkSilent);
    }

    [Fact]
    public void KeyOfALink_FromItsFile_SignsAndVerifiesThatLinkAlone()
    {
        string file = Path.Combine(Path.GetTempPath(), "key-" + Guid.NewGuid().ToString("N"));
        byte[] secret = Enumerable.Range(1, MavlinkSigningKey.Length).Select(n => (byte)n).ToArray();
        File.WriteAllBytes(file, secret);
        var signed = new MemoryLinkPair("radio", 64 * 1024);
        var open = new MemoryLinkPair("wire", 64 * 1024);
        var options = new UavOptions { OpenLinks = [signed.A, open.A], SystemId = 1, Time = new VirtualTime(0) };
        options.Communications.LinkSettings = new Dictionary<int, LinkSettings>
        {
            [0] = LinkUrl.Parse($"udpin:127.0.0.1:1,key={file}").Settings,
        };
        LinkStatus status = default;
        using (UavSystem uav = UavSystem.Open(options))
        {
            File.Delete(file);
            MessageSubscriber<LinkStatus>? links = null;
            Run(uav, reactor =>
            {
                Put(signed.B, Frames.Heartbeat());
                Put(open.B, Frames.Heartbeat(sequence: 1));
                reactor.RunFor(TimeSpan.FromSeconds(3));
                links!.Fetch();
                status = links.Value;
            }, reactor => links = reactor.Workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(0)));
        }

        Assert.Equal(1, status.Signatures.NotSigned);
        Assert.All(Read(signed.B).Where(f => f.ComponentId == 191), f => Assert.True(f.IsSigned));
        Assert.Contains(Read(open.B), f => !f.IsSigned && f.ComponentId == 191);
    }

    private static List<MavlinkFrame> Read(IByteLink link)
    {
        var buffer = new byte[64 * 1024];
        LinkRead read = link.Read(buffer);
        return Frames.Read(buffer.Take(read.Count).ToArray());
    }

    private static HealthReasons Run(UavSystem uav, Action<RabitReactor> fly, Action<RabitReactor>? prepare = null)
    {
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
        MessageSubscriber<HealthReport> health = reactor.Workspace.Subscribe<HealthReport>(MessageNames.Health);
        prepare?.Invoke(reactor);
        reactor.Start();
        fly(reactor);
        health.Fetch();
        HealthReasons reasons = health.Value.Reasons;
        reactor.Stop();
        reactor.Finish();
        return reasons;
    }

    private static void Put(IByteLink link, byte[] frame) => link.Write(frame, 0, frame.Length);
}
