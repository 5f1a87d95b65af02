using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// A hundred workspaces at once, again and again, on both wait engines: each does its own work, and no thread or object
/// of them is left.
/// </summary>
[Trait("Category", "Stress")]
public sealed class WorkspaceStressTests
{
    private const int Workspaces = 100;
    private const int RoundTrips = 50;

    // Linux keeps 15 characters of a thread's name.
    private const string Prefix = "hundred";

    private static TimeSpan MaxWait => TestTimeout.Limit + TestTimeout.Limit;

    [Theory, Trait("Clause", "4.1"), Trait("Clause", "4.3")]
    [InlineData(WaitEngine.Event)]
    [InlineData(WaitEngine.Best)]
    public void Workspaces_AHundredAtOnceAgainAndAgain_LeaveNothingBehind(WaitEngine engine)
    {
        var reactors = new List<WeakReference>();
        int maxThreads = 0;
        for (int round = 0; round < 5; round++)
            maxThreads = Math.Max(maxThreads, RunAll(engine, reactors));

        // That the threads can be seen at all, where the system lists threads.
        if (Directory.Exists("/proc/self/task"))
            Assert.Equal(2 * Workspaces, maxThreads);
        WaitUntil(() => ThreadsAlive() == 0, () => $"{ThreadsAlive()} threads are left");

        // Mono's collector takes what looks like a reference on a stack for one, so that some may be found alive.
        int mayStay = Type.GetType("Mono.Runtime") is null ? 0 : reactors.Count / 10;
        WaitUntil(
            () => Alive(reactors) <= mayStay,
            () => $"{Alive(reactors)} of {reactors.Count} workspaces are left in memory");
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int RunAll(WaitEngine engine, List<WeakReference> reactors)
    {
        var allRun = new CountdownEvent(Workspaces);
        var mayStop = new ManualResetEventSlim();
        var failures = new List<string>();
        Thread[] threads = [.. Enumerable.Range(0, Workspaces).Select(number => new Thread(() => RunOne(number)))];
        foreach (Thread thread in threads)
            thread.Start();
        Assert.True(allRun.Wait(MaxWait), $"{allRun.CurrentCount} workspaces do not come to their end");
        int threadsAlive = ThreadsAlive();
        mayStop.Set();
        Assert.All(threads, thread => Assert.True(thread.Join(MaxWait), "a workspace does not stop"));
        Assert.Empty(failures);
        return threadsAlive;

        void RunOne(int number)
        {
            var reactor = new RabitReactor(
                new ReactorOptions { Time = new RealTime { WaitEngine = engine }, StopsOnSignals = false });
            var ping = new Player($"{Prefix}{number} a", "ping", "pong", isFirst: true);
            var pong = new Player($"{Prefix}{number} b", "pong", "ping", isFirst: false);
            reactor.Add(ping);
            reactor.Add(pong);
            reactor.Start();
            bool isDone = ping.Done.Wait(MaxWait) && pong.Done.Wait(MaxWait);
            allRun.Signal();
            mayStop.Wait(MaxWait);
            reactor.Stop();
            ReactorResult result = reactor.Finish();
            lock (failures)
            {
                reactors.Add(new WeakReference(reactor));
                if (!isDone || result.ExitCode != 0)
                    failures.Add($"workspace {number}: {result}");
            }
        }
    }

    private static int Alive(List<WeakReference> references)
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        return references.Count(r => r.IsAlive);
    }

    // By name: other tests run in this process too.
    private static int ThreadsAlive()
    {
        if (!Directory.Exists("/proc/self/task"))
            return 0;
        return Directory.GetDirectories("/proc/self/task").Count(task =>
        {
            try
            {
                return File.ReadAllText(Path.Combine(task, "comm")).StartsWith(Prefix, StringComparison.Ordinal);
            }
            catch (IOException)
            {
                // It has ended meanwhile.
                return false;
            }
        });
    }

    private static void WaitUntil(Func<bool> condition, Func<string> fault)
    {
        var timeout = new TestTimeout();
        while (!condition())
            Assert.True(timeout.TryWait(), fault());
    }

    /// <summary>Passes a number to the other one, which passes it back, one higher.</summary>
    private sealed class Player : RabitManager
    {
        private readonly QueueReceiver<int> _receiver;
        private readonly QueueSender<int> _sender;
        private bool _begins;

        public Player(string name, string from, string to, bool isFirst)
            : base(name)
        {
            _receiver = Receive<int>(from, capacity: 4);
            _sender = Send<int>(to);
            _begins = isFirst;
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        public ManualResetEventSlim Done { get; } = new();

        protected override void ExecuteUnitOfWork()
        {
            if (_begins)
                _sender.Push(1);
            _begins = false;
            while (_receiver.TryPop(out int trip))
            {
                if (trip <= RoundTrips)
                    _sender.Push(trip + 1);
                if (trip >= RoundTrips)
                    Done.Set();
            }
        }
    }
}
