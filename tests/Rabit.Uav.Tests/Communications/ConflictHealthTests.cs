using System;
using System.IO;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>What Communications notices of others' addresses and of its disk reaches the health report.</summary>
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

    private static HealthReasons Run(UavSystem uav, Action<RabitReactor> fly)
    {
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
        MessageSubscriber<HealthReport> health = reactor.Workspace.Subscribe<HealthReport>(MessageNames.Health);
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
