using System;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// A day of simulated time: managers that post, fetch, push and pop without end, one of which fails now and then, hold
/// no more at its end than after its first hour, and nothing is lost.
/// </summary>
[Collection(AloneCollection.Name)]
public sealed class VirtualDayTests(ITestOutputHelper output)
{
    private const int Hours = 24;
    private const int PerHour = 180_000;   // 50 Hz

    // A buffer or a table that grows to its size late; what each unit of work or each fault left would be far more.
    private const long MaxGrowthBytes = 64 << 10;

    [Fact, Trait("Category", "Long"), Trait("Clause", "5.2")]
    public void Day_OfManagersAtWork_LeavesTheHeapAsItWasAfterAnHour()
    {
        using var reactor = new RabitReactor(new ReactorOptions
        {
            Time = new VirtualTime(seed: 1),
            StopsOnSignals = false,
            Log = _ => { },
        });
        Member[] members = [.. Enumerable.Range(0, Member.Crew).Select(n => new Member(n))];
        foreach (Member member in members)
            reactor.Add(member);
        reactor.Start();

        reactor.RunFor(TimeSpan.FromHours(1));
        long first = HeapBytes();
        for (int hour = 2; hour <= Hours; hour++)
        {
            reactor.RunFor(TimeSpan.FromHours(1));
            long grown = HeapBytes() - first;
            output.WriteLine($"after {hour} h: {grown} bytes more");
            Assert.True(grown < MaxGrowthBytes, $"after {hour} h the heap has {grown} bytes more than after one");
        }

        // A fault puts the next unit of work off.
        Assert.All(members.Skip(1), m => Assert.Equal((Hours * PerHour) + 1, m.Runs));
        Assert.Equal(members[0].Runs / Member.RunsToAFault, members[0].Faults);
        Assert.InRange(members[0].Faults, Hours * PerHour / Member.RunsToAFault * 9 / 10, int.MaxValue);
        Assert.All(members, m => Assert.InRange(members[m.Next].Received, m.Runs - 1, m.Runs));
        reactor.Stop();
        reactor.Finish();
    }

    private static long HeapBytes()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        return GC.GetTotalMemory(forceFullCollection: true);
    }

    private sealed class Member : RabitManager
    {
        public const int Crew = 3;

        // Every ten minutes of 50 Hz.
        public const int RunsToAFault = 30_000;

        private readonly MessagePublisher<long> _own;
        private readonly MessageSubscriber<long> _neighbour;
        private readonly QueueReceiver<int> _inbox;
        private readonly QueueSender<int> _outbox;
        private readonly bool _fails;

        public Member(int number)
            : base($"member {number}")
        {
            _own = Publish<long>($"count {number}");
            Next = (number + 1) % Crew;
            _neighbour = Subscribe<long>($"count {Next}");
            _inbox = Receive<int>($"inbox {number}", 10, wakeOnPush: false);
            _outbox = Send<int>($"inbox {Next}");
            _fails = number == 0;
            Period = TimeSpan.FromMilliseconds(20);
            FaultPolicy = FaultPolicy.CarryOn;
        }

        /// <summary>Who receives what it sends.</summary>
        public int Next { get; }

        public int Runs { get; private set; }

        public int Received { get; private set; }

        public int Faults { get; private set; }

        protected override void ExecuteUnitOfWork()
        {
            Runs++;
            while (_inbox.TryPop(out _))
                Received++;
            _neighbour.Fetch();
            _own.Post(Runs);
            Assert.Equal(PushResult.Queued, _outbox.Push(Runs));
            if (_fails && Runs % RunsToAFault == 0)
            {
                Faults++;
                throw new InvalidOperationException("as planned");
            }
        }
    }
}
