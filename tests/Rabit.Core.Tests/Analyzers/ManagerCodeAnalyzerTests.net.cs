using System.Threading.Tasks;
using Xunit;

namespace Rabit.Core.Tests.Analyzers;

/// <summary>RABIT0001 to RABIT0004 and RABIT0007: what they find, and what they must not find.</summary>
public sealed class ManagerCodeAnalyzerTests
{
    [Theory]
    [InlineData("Startup")]
    [InlineData("ExecuteUnitOfWork")]
    [InlineData("Shutdown")]
    public async Task Rabit0001_AsyncOverride_IsFound(string stage)
    {
        string other = stage == "ExecuteUnitOfWork" ? "" : "protected override void ExecuteUnitOfWork() { }";
        Assert.Equal(
            [$"RABIT0001 at {stage}"],
            await AnalyzedManager.Report($"protected override async void {stage}() => await Task.Yield(); {other}"));
    }

    [Fact]
    public async Task Rabit0001_AsyncOfItsOwnOrOfAnotherClass_IsNotFound()
        => Assert.Empty(await AnalyzedManager.Report(
            """
            protected override void ExecuteUnitOfWork() { }
            public async Task ExecuteUnitOfWorkAsync() => await Task.Yield();
            """,
            """
            public abstract class Job { protected abstract void ExecuteUnitOfWork(); }
            public sealed class Download : Job
            {
                protected override async void ExecuteUnitOfWork() => await Task.Yield();
            }
            """));

    [Theory]
    [InlineData("Thread.Sleep(1)")]
    [InlineData("new Thread(() => { }).Join()")]
    [InlineData("_task.Wait()")]
    [InlineData("Task.WaitAll(_task)")]
    [InlineData("_task.GetAwaiter().GetResult()")]
    [InlineData("Monitor.Enter(_gate)")]
    [InlineData("_signal.WaitOne()")]
    [InlineData("_semaphore.Wait(5)")]
    [InlineData("Console.ReadLine()")]
    public async Task Rabit0002_BlockingCallInAUnitOfWork_IsFound(string call)
        => Assert.Equal([$"RABIT0002 at {call}"], await AnalyzedManager.Report(Fields + $$"""
            protected override void ExecuteUnitOfWork() { {{call}}; }
            """));

    [Fact]
    public async Task Rabit0002_LockAndResult_AreFound()
        => Assert.Equal(["RABIT0002 at _gate", "RABIT0002 at _task.Result"], await AnalyzedManager.Report(Fields + """
            protected override void ExecuteUnitOfWork() { lock (_gate) { _count = _task.Result; } }
            """));

    [Fact]
    public async Task Rabit0002_InWhatTheUnitOfWorkCalls_IsFound()
        => Assert.Equal(
            ["RABIT0002 at Thread.Sleep(1)", "RABIT0002 at Thread.Sleep(2)", "RABIT0002 at Thread.Sleep(3)"],
            await AnalyzedManager.Report(Fields + """
                protected override void ExecuteUnitOfWork()
                {
                    Steer();
                    _ = Height;
                    Local();
                    void Local() => Thread.Sleep(1);
                }
                private void Steer() => Turn();
                private void Turn() => Thread.Sleep(2);
                private int Height { get { Thread.Sleep(3); return 1; } }
                """));

    [Fact]
    public async Task Rabit0002_OutsideOfAUnitOfWork_IsNotFound()
        => Assert.Empty(await AnalyzedManager.Report(
            Fields + """
                protected override void Startup() => Thread.Sleep(1);
                protected override void Shutdown() { lock (_gate) { } }
                protected override void ExecuteUnitOfWork() { }
                public int CountForTheScreen() { lock (_gate) return _count; }
                """,
            """
            public sealed class Other { public void ExecuteUnitOfWork() => Thread.Sleep(1); }
            """));

    [Fact]
    public async Task Rabit0002_LooksWithoutAWait_AreNotFound()
        => Assert.Empty(await AnalyzedManager.Report(Fields + """
            protected override void ExecuteUnitOfWork()
            {
                if (_task.IsCompleted)
                    _count = _task.Result;
                if (_signal.WaitOne(0) || _semaphore.Wait(TimeSpan.Zero) || Monitor.TryEnter(_gate))
                    _count++;
                Volatile.Write(ref _count, 2);
                Interlocked.Increment(ref _count);
                Start(() => Thread.Sleep(1));
            }
            private static void Start(Action work) => new Thread(() => work()).Start();
            """));

    [Theory]
    [InlineData("DateTime.Now")]
    [InlineData("DateTime.UtcNow")]
    [InlineData("DateTimeOffset.UtcNow")]
    [InlineData("Environment.TickCount64")]
    [InlineData("TimeProvider.System")]
    [InlineData("Stopwatch.StartNew()")]
    [InlineData("new Stopwatch()")]
    [InlineData("Stopwatch.GetTimestamp()")]
    [InlineData("Task.Delay(5)")]
    [InlineData("new CancellationTokenSource(5)")]
    [InlineData("new PeriodicTimer(TimeSpan.FromSeconds(1))")]
    [InlineData("new Timer(_ => { })")]
    public async Task Rabit0003_OtherTime_IsFoundAnywhereInAManager(string use)
    {
        Assert.Equal([$"RABIT0003 at {use}"], await AnalyzedManager.Report(
            $"protected override void ExecuteUnitOfWork() {{ _ = {use}; }}"));
        Assert.Equal([$"RABIT0003 at {use}"], await AnalyzedManager.Report(
            $"private readonly object _kept = {use}; protected override void ExecuteUnitOfWork() {{ }}"));
    }

    [Fact]
    public async Task Rabit0003_TimeOfTheRunOrOfAnotherClass_IsNotFound()
        => Assert.Empty(await AnalyzedManager.Report(
            """
            private readonly CancellationTokenSource _stop = new();
            protected override void ExecuteUnitOfWork()
            {
                Log($"{Now} {Clock.GetUtcNow()} {new DateTime(2026, 1, 1)} {TimeSpan.FromSeconds(1)}");
                _ = Task.Delay(TimeSpan.FromSeconds(1), Clock);
                _ = new CancellationTokenSource(TimeSpan.FromSeconds(1), Clock);
                _stop.Cancel();
            }
            """,
            "public static class Program { public static DateTime Begin => DateTime.UtcNow; }"));

    [Fact]
    public async Task Rabit0004_UnseededRandom_IsFound()
        => Assert.Equal(["RABIT0004 at new Random()", "RABIT0004 at Random.Shared"], await AnalyzedManager.Report("""
            private readonly Random _random = new Random();
            private readonly Random _seeded = new Random(7);
            protected override void ExecuteUnitOfWork() { _ = Random.Shared.Next() + _random.Next() + _seeded.Next(); }
            """));

    [Fact]
    public async Task Rabit0007_DeclarationAfterTheConstructor_IsFound()
        => Assert.Equal(
            ["RABIT0007 at Publish<int>(\"height\")", "RABIT0007 at Send<int>(\"orders\")"],
            await AnalyzedManager.Report("""
                protected override void Startup() => Publish<int>("height");
                protected override void ExecuteUnitOfWork() => Late();
                private void Late() => Send<int>("orders");
                """));

    [Fact]
    public async Task Rabit0007_DeclarationInWhatTheConstructorCalls_IsNotFound()
        => Assert.Empty(await AnalyzedManager.Report(
            """
            private MessagePublisher<int>? _height;
            partial void Declare() => _height = Publish<int>("height");
            protected override void ExecuteUnitOfWork() { if (_other.Publish<int>("x")) _height!.Post(); }
            private readonly Other _other = new();
            """,
            "public sealed class Other { public bool Publish<T>(string name) => name.Length == 1; }"));

    [Fact]
    public async Task Rules_ProgramWithoutRabit_AreSilent()
        => Assert.Empty(await AnalyzedManager.ReportOf(
            "public sealed class Clock { public System.DateTime Now => System.DateTime.Now; }"));

    private const string Fields = """
        private readonly object _gate = new();
        private readonly Task<int> _task = Task.FromResult(1);
        private readonly AutoResetEvent _signal = new(false);
        private readonly SemaphoreSlim _semaphore = new(1);
        private int _count;
        """;
}
