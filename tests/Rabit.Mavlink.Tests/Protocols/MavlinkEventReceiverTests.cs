using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkEventReceiverTests(ITestOutputHelper output)
{
    private static readonly MavlinkSender Vehicle = new(1, 1);
    private readonly MavlinkEventReceiver _receiver = New();
    private TimeSpan _now = TimeSpan.FromSeconds(10);
    private uint _bootMilliseconds = 50_000;

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void Receive_LossyLink_EachOnceAndTheRestCountedAsLost(int lossPercent)
    {
        const int Events = 200;
        long lost = 0;
        long requests = 0;
        for (ulong seed = 1; seed <= 50; seed++)
        {
            var vehicle = new EventVehicle(seed, Events, first: 65_450);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            MavlinkEventReceiver receiver = New();
            var seen = new HashSet<int>();
            bool ended = world.RunUntil(
                () => Take(receiver, seen) && vehicle.IsOver && world.Now > vehicle.LastAt + TimeSpan.FromSeconds(60),
                receiver.Handle, receiver.TryTakeFrame, () => receiver.NextDue, TimeSpan.FromSeconds(1000));
            Assert.True(ended, world.Context);
            Assert.Equal(seen.Count, receiver.Received);

            // What was lost before the first that came is not known.
            int first = seen.Min(s => (s - 65_450) & 0xFFFF);
            Assert.InRange(receiver.Received + receiver.Lost, Events - first, Events);
            Assert.True(lossPercent > 0 || (receiver.Lost, receiver.Recovered, vehicle.Requests) == (0, 0, 0));
            lost += receiver.Lost;
            requests += vehicle.Requests;
        }

        output.WriteLine($"loss {lossPercent} %: {lost} of {50 * Events} events lost, {requests} requests, 50 seeds");
        Assert.True(lost <= 50 * Events * lossPercent / 500, $"{lost} lost");
    }

    [Fact]
    public void Handle_Gap_IsAskedForAndComesLate()
    {
        Send(5);
        Send(9);
        Assert.Equal([(5, false), (9, false)], Take());
        Assert.Equal(_now + TimeSpan.FromSeconds(0.1), _receiver.NextDue);
        _now = _receiver.NextDue;
        RequestEvent request = Asked()!.Value;
        Assert.Equal(
            (1, 1, 6, 8),
            (request.TargetSystem, request.TargetComponent, request.FirstSequence, request.LastSequence));
        Assert.Null(Asked());
        Send(6);
        Send(8);
        Assert.Equal([(6, true), (8, true)], Take());
        _now += TimeSpan.FromSeconds(0.5);
        request = Asked()!.Value;
        Assert.Equal((7, 7), (request.FirstSequence, request.LastSequence));
        Send(7);
        Assert.Equal([(7, true)], Take());
        Assert.Equal((5L, 3L, 0L), (_receiver.Received, _receiver.Recovered, _receiver.Lost));
        Assert.Equal(TimeSpan.MaxValue, _receiver.NextDue);
    }

    [Fact]
    public void Handle_OvertakenEvent_IsNotAskedFor()
    {
        Send(1);
        Send(3);
        Send(2);
        _now += TimeSpan.FromSeconds(1);
        Assert.Null(Asked());
        Assert.Equal([(1, false), (3, false), (2, true)], Take());
    }

    [Fact]
    public void Handle_CurrentSequence_ShowsWhatIsMissingAtTheEnd()
    {
        Current(40);
        Assert.Null(Asked());
        Send(41);
        Current(43);
        Assert.Equal([(41, false)], Take());
        _now += TimeSpan.FromSeconds(0.1);
        RequestEvent request = Asked()!.Value;
        Assert.Equal((42, 43), (request.FirstSequence, request.LastSequence));
        Send(42);
        Send(43);
        Assert.Equal(2, Take().Count);
        Current(43);
        _now += TimeSpan.FromSeconds(1);
        Assert.Null(Asked());
    }

    [Fact]
    public void TryTakeFrame_NoAnswer_EightRequestsThenLost()
    {
        Send(1);
        Send(4);
        int requests = 0;
        for (int i = 0; i < 100; i++)
        {
            _now += TimeSpan.FromSeconds(0.1);
            requests += Asked() is null ? 0 : 1;
        }

        Assert.Equal((8, 2L, TimeSpan.MaxValue), (requests, _receiver.Lost, _receiver.NextDue));
        Send(2);
        Assert.Equal(2, Take().Count);
        Assert.Equal(1, _receiver.Repeats);
    }

    [Fact]
    public void Handle_Error_WhatIsOlderThanTheOldestIsLost()
    {
        Send(10);
        Send(20);
        _now += TimeSpan.FromSeconds(0.1);
        Assert.NotNull(Asked());
        Refuse(11, oldest: 15, system: 7);
        Assert.Equal(0, _receiver.Lost);
        Refuse(11, oldest: 15);
        Assert.Equal(4, _receiver.Lost);
        Refuse(12, oldest: 15);
        Refuse(13, oldest: 15);
        Assert.Equal(4, _receiver.Lost);
        for (int sequence = 15; sequence < 20; sequence++)
            Send(sequence);
        Assert.Equal(7, Take().Count);
        Assert.Equal(TimeSpan.MaxValue, _receiver.NextDue);
    }

    [Fact]
    public void Handle_JumpAboveTheWindow_SixtyFourAreAskedForAndTheRestIsLost()
    {
        Send(0);
        Send(1000);
        Assert.Equal(1000 - 64, _receiver.Lost);
        _now += TimeSpan.FromSeconds(0.1);
        RequestEvent request = Asked()!.Value;
        Assert.Equal((937, 999), (request.FirstSequence, request.LastSequence));
    }

    // By its numbers, by its times, by its flag, and by who knows it otherwise.
    [Fact]
    public void Handle_VehicleHasStartedAgain_BeginsAgain()
    {
        for (int sequence = 0; sequence < 300; sequence++)
            Send(sequence);
        Take();
        Restarted(1000);
        Send(0);
        Send(1);
        Assert.Equal([(0, false), (1, false)], Take());

        Restarted(2000);
        Send(0);
        Assert.Equal([(0, false)], Take());

        _bootMilliseconds = 100_000;
        Send(1);
        Restarted(3000);
        Send(30);
        Assert.Equal([(1, false), (30, false)], Take());

        _bootMilliseconds = 200_000;
        Current(3, MavEventCurrentSequenceFlags.Reset);
        Send(4);
        Assert.Equal([(4, false)], Take());

        _receiver.Restart();
        Send(2);
        Assert.Equal([(2, false)], Take());
        _now += TimeSpan.FromSeconds(1);
        Assert.Null(Asked());
        Assert.Equal((0L, 0L), (_receiver.Lost, _receiver.Repeats));
    }

    // What another station has asked for comes over the same link, with its own time.
    [Fact]
    public void Handle_CopiesOfOldEvents_AreCountedOnly()
    {
        var sent = new List<Event>();
        for (int sequence = 100; sequence < 130; sequence++)
            sent.Add(Send(sequence));
        Take();
        foreach (Event copy in sent)
            _receiver.Handle(Vehicle.Create(copy), _now);

        // From before the first that came.
        _receiver.Handle(Vehicle.Create(new Event { Sequence = 90, EventTimeBootMs = 1000 }), _now);
        Assert.Empty(Take());
        Assert.Equal((31L, 0L), (_receiver.Repeats, _receiver.Lost));
    }

    [Fact]
    public void Handle_OfOthersAndForOthers_AreNotTaken()
    {
        _receiver.Handle(new MavlinkSender(1, 2).Create(new Event { Sequence = 1 }), _now);
        _receiver.Handle(new MavlinkSender(2, 1).Create(new Event { Sequence = 1 }), _now);
        Assert.Equal(0, _receiver.Received);
        _receiver.Handle(
            Vehicle.Create(new Event { Sequence = 1, DestinationSystem = 255, DestinationComponent = 190 }), _now);
        _receiver.Handle(
            Vehicle.Create(new Event { Sequence = 2, DestinationSystem = 1, DestinationComponent = 191 }), _now);
        Assert.Equal([(2, false)], Take());
        Assert.Equal((2L, 0L), (_receiver.Received, _receiver.Lost));
    }

    [Fact]
    public void Handle_RandomMessages_NoExceptionNoFloodNoEndlessLoop()
    {
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var random = new ProtocolRandom(seed);
            MavlinkEventReceiver receiver = New();
            int requests = 0;
            for (int i = 0; i < 5000; i++)
            {
                var sequence = (ushort)(random.Below(3) == 0 ? random.Below(65_536) : random.Below(200));
                MavlinkFrame frame = random.Below(4) switch
                {
                    0 => Vehicle.Create(new CurrentEventSequence
                    {
                        Sequence = sequence,
                        Flags = (MavEventCurrentSequenceFlags)random.Below(2),
                    }),
                    1 => Vehicle.Create(new ResponseEventError
                    {
                        TargetSystem = 1,
                        TargetComponent = 191,
                        Sequence = sequence,
                        SequenceOldestAvailable = (ushort)random.Below(65_536),
                    }),
                    _ => Vehicle.Create(new Event { Sequence = sequence, EventTimeBootMs = (uint)random.Next() }),
                };
                receiver.Handle(frame, _now);
                _now += TimeSpan.FromMilliseconds(10);
                while (receiver.TryTakeFrame(_now, out _))
                    requests++;
                while (receiver.TryTake(out _))
                    Assert.True(receiver.Received > 0);
            }

            Assert.InRange(requests, 0, 5000);
            Assert.Equal(0, receiver.Dropped);
        }
    }

    [Fact]
    public void Handle_GapsAndRequests_AllocateNothing()
    {
        ushort sequence = 0;
        Action work = () =>
        {
            _now += TimeSpan.FromSeconds(1);
            _bootMilliseconds += 1000;
            Send(sequence);
            Send(sequence += 3);
            _now += TimeSpan.FromSeconds(0.2);
            _receiver.TryTakeFrame(_now, out _);
            Send(sequence - 1);
            while (_receiver.TryTake(out _))
                _now += TimeSpan.Zero;
        };
        work();
        Assert.Equal(0, Allocated.By(work));
    }

    [Fact]
    public void ToString_NumberLevelAndArguments_WithoutZerosAtTheEnd()
    {
        var message = new Event { Id = 26_266_355, LogLevels = 0x26, Arguments = new ByteArray40([0x0A, 0, 0xFF]) };
        var happened = new MavlinkEvent(new MavlinkAddress(1, 1), message);
        Assert.Equal("event 1:9489139 Info 0a00ff", happened.ToString());
        Assert.Equal(
            (MavlinkEventLevel.Info, MavlinkEventLevel.Critical, true),
            (happened.Level, happened.LogLevel, happened.IsForPeople));
        Assert.Equal(
            "event 0:5 Disabled", new MavlinkEvent(default, new Event { Id = 5, LogLevels = 0xFF }).ToString());
    }

    private static MavlinkEventReceiver New() => new(ScriptedVehicle.Companion(), ScriptedVehicle.Address);

    private static bool Take(MavlinkEventReceiver receiver, HashSet<int> seen)
    {
        while (receiver.TryTake(out MavlinkEvent happened))
            Assert.True(seen.Add(happened.Message.Sequence));
        return true;
    }

    private void Restarted(uint bootMilliseconds) => _bootMilliseconds = bootMilliseconds;

    private Event Send(int sequence)
    {
        _bootMilliseconds += 7;
        var happened = new Event { Sequence = (ushort)sequence, EventTimeBootMs = _bootMilliseconds };
        _receiver.Handle(Vehicle.Create(happened), _now);
        return happened;
    }

    private void Current(int sequence, MavEventCurrentSequenceFlags flags = 0) => _receiver.Handle(
        Vehicle.Create(new CurrentEventSequence { Sequence = (ushort)sequence, Flags = flags }), _now);

    private void Refuse(int sequence, int oldest, byte system = 1) => _receiver.Handle(
        Vehicle.Create(new ResponseEventError
        {
            TargetSystem = system,
            TargetComponent = 191,
            Sequence = (ushort)sequence,
            SequenceOldestAvailable = (ushort)oldest,
        }),
        _now);

    private RequestEvent? Asked()
        => _receiver.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out RequestEvent request)
            ? request
            : null;

    private List<(int Sequence, bool IsRecovered)> Take()
    {
        var taken = new List<(int, bool)>();
        while (_receiver.TryTake(out MavlinkEvent happened))
            taken.Add((happened.Message.Sequence, happened.IsRecovered));
        return taken;
    }
}
