using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Radio;

/// <summary>What the simulated radio does to frames.</summary>
public sealed class SimulatedRadioTests
{
    private const int Seed = 3;
    private const int Frames = 4000;

    private static readonly TimeSpan Step = SimulatedRadioOptions.MinLatency;

    [Fact]
    public void Frame_GoodRadio_ArrivesAtAllOthersAndNotAtTheSender()
    {
        var rig = new Rig(3, new SimulatedRadioOptions());
        rig.Run(sendFrom: 0, count: 100);
        Assert.Equal([0, 100, 100], rig.Received.Select(r => r.Count));
        Assert.Equal((100L, 200L), (rig.Radio.CountersOf(0).FramesSent, rig.Radio.CountersOf(0).Delivered));
    }

    [Fact]
    public void Frame_Latency_IsKept()
    {
        var rig = new Rig(2, new SimulatedRadioOptions { Latency = TimeSpan.FromSeconds(0.5), Jitter = TimeSpan.Zero });
        rig.Send(0, 1);
        rig.RunSteps(24); // 0.48 s
        Assert.Empty(rig.Received[1]);
        rig.RunSteps(3);
        Assert.Single(rig.Received[1]);
    }

    [Fact]
    public void Frames_Jitter_OvertakeEachOther()
    {
        var rig = new Rig(2, new SimulatedRadioOptions { Jitter = TimeSpan.FromSeconds(0.2) });
        rig.Run(sendFrom: 0, count: 200);
        Assert.Equal(200, rig.Received[1].Count);
        Assert.NotEqual(rig.Received[1].OrderBy(n => n), rig.Received[1]);
    }

    [Fact]
    public void Frames_Loss_IsItsFraction()
        => Assert.InRange(LostOf(new SimulatedRadioOptions { Loss = 0.4 }), 0.37, 0.43);

    [Theory]
    [InlineData(1000, 0, 0.01)]
    [InlineData(2800, 0.23, 0.31)]
    [InlineData(3000, 0.46, 0.54)]
    [InlineData(4500, 0.99, 1)]
    public void Frames_Distance_AreLostByTheLogisticCurve(double metres, double atLeast, double atMost)
        => Assert.InRange(LostOf(new SimulatedRadioOptions(), metres), atLeast, atMost);

    [Fact]
    public void Frames_Bursts_AreLostInRuns()
    {
        // 0.5 s of 2.5 s on the average.
        var rig = new Rig(2, new SimulatedRadioOptions { BurstsPerSecond = 0.5, Jitter = TimeSpan.Zero });
        rig.Run(sendFrom: 0, count: Frames);
        RadioCounters counters = rig.Radio.CountersOf(0);
        Assert.InRange(counters.LostInBursts / (double)Frames, 0.1, 0.3);
        int gaps = rig.Received[1].Zip(rig.Received[1].Skip(1), (a, b) => b - a).Count(d => d > 1);
        Assert.True(gaps < counters.LostInBursts / 5, $"seed {Seed}: {gaps} gaps, {counters.LostInBursts} lost");
    }

    [Fact]
    public void Frames_Duplicates_ArriveTwiceAndAreCounted()
    {
        var rig = new Rig(2, new SimulatedRadioOptions { DuplicateFraction = 0.25 });
        rig.Run(sendFrom: 0, count: Frames);
        long duplicated = rig.Radio.CountersOf(0).Duplicated;
        Assert.InRange(duplicated / (double)Frames, 0.22, 0.28);
        Assert.Equal(Frames + duplicated, rig.Received[1].Count);
    }

    [Fact]
    public void Frames_MoreThanTheRate_AreRefusedAndCounted()
    {
        var rig = new Rig(2, new SimulatedRadioOptions { BytesPerSecond = 200 });
        rig.Run(sendFrom: 0, count: 500);
        RadioCounters counters = rig.Radio.CountersOf(0);
        Assert.True(counters.FramesRefused > 100, $"{counters.FramesRefused}");
        Assert.Equal(500, counters.FramesRefused + counters.FramesSent);

        // Ten seconds, and one that waits.
        Assert.InRange(counters.BytesSent, 1800, 2300);
    }

    [Fact]
    public void Frames_Partition_ReachNoOneOnTheOtherSide()
    {
        var rig = new Rig(3, new SimulatedRadioOptions
        {
            Partitions = [new RadioPartition(TimeSpan.FromSeconds(1), TimeSpan.FromSeconds(1), [2])],
        });
        rig.Run(sendFrom: 0, count: 150); // 3 s
        Assert.Equal(150, rig.Received[1].Count);
        Assert.Equal(100, rig.Received[2].Count);
        Assert.Equal(50, rig.Radio.CountersOf(0).LostByPartition);
    }

    [Fact]
    public void Frames_RadioSwitchedOff_NeitherSendsNorReceives()
    {
        var rig = new Rig(2, new SimulatedRadioOptions());
        rig.Radio.SwitchOff(1);
        rig.Run(sendFrom: 0, count: 10);
        rig.Run(sendFrom: 1, count: 10);
        Assert.All(rig.Received, Assert.Empty);
        Assert.Equal(10, rig.Radio.CountersOf(0).LostByPartition);
        Assert.Equal(10, rig.Radio.CountersOf(1).FramesRefused);
    }

    [Fact]
    public void Frames_SameSeed_SameOrder()
    {
        List<int> Run()
        {
            var options = new SimulatedRadioOptions { Loss = 0.2, DuplicateFraction = 0.1, BurstsPerSecond = 0.1 };
            var rig = new Rig(3, options);
            rig.Run(sendFrom: 0, count: 1000);
            return rig.Received[2];
        }

        Assert.Equal(Run(), Run());
    }

    private static double LostOf(SimulatedRadioOptions options, double metres = 100)
    {
        var rig = new Rig(2, options, metres);
        rig.Run(sendFrom: 0, count: Frames);
        return 1 - (rig.Received[1].Count / (double)Frames);
    }

    // Stations in a row; one frame each 20 ms, with its number in it.
    private sealed class Rig
    {
        private readonly List<IByteLink> _links = [];
        private readonly List<MavlinkFrameReader> _readers = [];
        private readonly byte[] _buffer = new byte[4096];
        private TimeSpan _now;
        private int _number;

        public Rig(int stations, SimulatedRadioOptions options, double spacingMetres = 100)
        {
            Radio = new SimulatedRadio(options, Seed);
            for (int i = 0; i < stations; i++)
            {
                var place = new NedPosition(0, i * spacingMetres, 0);
                _links.Add(Radio.Add(() => place));
                _readers.Add(new MavlinkFrameReader(MavlinkDialect.All));
                Received.Add([]);
            }
        }

        public SimulatedRadio Radio { get; }

        public List<List<int>> Received { get; } = [];

        public void Run(int sendFrom, int count)
        {
            for (int i = 0; i < count; i++)
            {
                Send(sendFrom, _number++);
                RunSteps(1);
            }

            RunSteps(200);
        }

        public void Send(int from, int number)
        {
            var heartbeat = new Heartbeat { CustomMode = (uint)number, MavlinkVersion = 3 };
            MavlinkFrame frame = MavlinkFrame.Create(heartbeat, (byte)(from + 1), 191, (byte)number);
            int length = frame.WriteTo(_buffer);
            _links[from].Write(_buffer, 0, length);
        }

        public void RunSteps(int count)
        {
            for (int i = 0; i < count; i++)
            {
                _now += Step;
                Radio.Exchange(_now);
                for (int to = 0; to < _links.Count; to++)
                    Receive(to);
            }
        }

        private void Receive(int to)
        {
            while (_links[to].Read(_buffer) is { Kind: LinkReadKind.Bytes } read)
            {
                var bytes = new ReadOnlySpan<byte>(_buffer, 0, read.Count);
                while (_readers[to].TryRead(ref bytes, out MavlinkFrame frame, out _))
                {
                    Assert.True(frame.TryDecode(out Heartbeat heartbeat));
                    Received[to].Add((int)heartbeat.CustomMode);
                }
            }
        }
    }
}
