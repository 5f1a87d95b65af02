using System.Threading.Tasks;
using Xunit;

namespace Rabit.Core.Tests.Analyzers;

/// <summary>RABIT0005 and RABIT0006: the types of messages and queues, and results of pushes.</summary>
public sealed class ValueAnalyzerTests
{
    private const string Types = """
        public struct Pose { public double North; public TimeSpan At; public DateTimeOffset Utc; public Pose2 Nested; }
        public struct Pose2 { public string Name; public ImmutableArray<int> Values; public int? Maybe; }
        public sealed record Order(string Name, ImmutableList<Pose> Way);
        public sealed class Plan { public int Count { get; set; } }
        public sealed class Fixed { public Fixed(int count) => Count = count; public int Count { get; } }
        public class Open { }
        public struct Scan { public float[] Ranges; }
        public struct Deep { public Scan Inner; }
        [TrustedImmutable] public sealed class Vouched { public int[] Values = []; }
        [HandedOver] public sealed class Owned { public int[] Values = []; }
        public sealed class Picture : IDisposable { public byte[] Pixels = []; public void Dispose() { } }
        public struct Leased { public BufferLease Pixels; }
        public sealed class Copied : ISelfCopying<Copied>
        {
            public int[] Values = [];
            public Copied Clone() => new();
            public void CopyTo(Copied other) { }
        }
        """;

    [Theory]
    [InlineData("int")]
    [InlineData("string")]
    [InlineData("Pose")]
    [InlineData("Order")]
    [InlineData("Fixed")]
    [InlineData("Vouched")]
    [InlineData("Copied")]
    [InlineData("DayOfWeek")]
    [InlineData("(int, string)")]
    [InlineData("ImmutableArray<Pose>")]
    [InlineData("ImmutableDictionary<string, Order>")]
    [InlineData("Version")]
    [InlineData("ManagerStatus")]
    public async Task Rabit0005_MessageThatSharesNothing_IsNotFound(string type)
        => Assert.Empty(await Message(type));

    [Theory]
    [InlineData("int[]")]
    [InlineData("List<int>")]
    [InlineData("Plan")]
    [InlineData("Open")]
    [InlineData("Scan")]
    [InlineData("Deep")]
    [InlineData("Leased")]
    [InlineData("Action")]
    [InlineData("IReadOnlyList<int>")]
    [InlineData("ImmutableArray<Plan>")]
    [InlineData("(int, int[])")]
    [InlineData("Picture")]
    public async Task Rabit0005_MessageThatCouldBeChanged_IsFound(string type)
        => Assert.Equal([$"RABIT0005 at Subscribe<{type}>(\"x\")"], await Message(type));

    [Theory]
    [InlineData("int")]
    [InlineData("Order")]
    [InlineData("Picture")]
    [InlineData("Leased")]
    [InlineData("BufferLease")]
    [InlineData("Owned")]
    public async Task Rabit0005_QueueOfWhatIsHandedOverOrFixed_IsNotFound(string type)
        => Assert.Empty(await Queue(type));

    [Theory]
    [InlineData("byte[]")]
    [InlineData("List<int>")]
    [InlineData("Plan")]
    [InlineData("Copied")]
    public async Task Rabit0005_QueueThatCouldBeChanged_IsFound(string type)
        => Assert.Equal([$"RABIT0005 at Receive<{type}>(\"x\")"], await Queue(type));

    [Fact]
    public async Task Rabit0005_TypeParameterOrOtherMethod_IsNotFound()
        => Assert.Empty(await AnalyzedManager.Report("""
            protected override void ExecuteUnitOfWork() { }
            private MessagePublisher<T> Named<T>(string name) => Publish<T>(name);
            private static T[] Send<T>(int count) => new T[count];
            private readonly int[][] _values = Send<int[]>(3);
            """));

    [Fact]
    public async Task Rabit0006_PushThatStandsAlone_IsFound()
        => Assert.Equal(["RABIT0006 at _orders.Push(1)"], await AnalyzedManager.Report("""
            private readonly QueueSender<int> _orders = null!;
            private readonly Stack<int> _stack = new();
            protected override void ExecuteUnitOfWork()
            {
                _orders.Push(1);
                _ = _orders.Push(2);
                if (_orders.Push(3) == PushResult.Rejected)
                    _stack.Push(4);
            }
            """));

    [Fact]
    public async Task Rabit0006_PushOfSeveralOrAsync_IsFound()
        => Assert.Equal(
            [
                "RABIT0006 at _orders.PushFrom([1, 2])", "RABIT0006 at await _orders.PushAsync(3)",
                "RABIT0006 at await _orders.PushAsync(4).ConfigureAwait(false)", "RABIT0006 at _orders.PushAsync(5)",
                "RABIT0006 at .Push(6)", "RABIT0006 at _orders.Push(7)", "RABIT0006 at _orders.Push(8)",
            ],
            await AnalyzedManager.Report("""
                private readonly QueueSender<int> _orders = null!;
                private QueueSender<int>? _others = null;
                protected override void ExecuteUnitOfWork() => _orders.PushFrom([1, 2]);
                public async Task Feed()
                {
                    await _orders.PushAsync(3);
                    await _orders.PushAsync(4).ConfigureAwait(false);
                    _orders.PushAsync(5);
                    _others?.Push(6);
                }
                public Action Later() => () => _orders.Push(7);
                public void Now() => _orders.Push(8);
                """));

    [Fact]
    public async Task Rabit0006_ResultThatIsUsedOrOtherPush_IsNotFound()
        => Assert.Empty(await AnalyzedManager.Report("""
            private readonly QueueSender<int> _orders = null!;
            private readonly Stack<int> _stack = new();
            private readonly Batch _batch = new();
            protected override void ExecuteUnitOfWork()
            {
                int count = _orders.PushFrom([1, 2]);
                _ = _orders.PushFrom([3]);
                if (_orders.PushFrom([4, 5]) < 2 || !_orders.TryPushOrHold(6))
                    _stack.Push(count);
                _batch.PushFrom([7]);
                _stack.Push(8);
            }
            public async Task<PushResult> Feed(CancellationToken end)
            {
                _ = await _orders.PushAsync(9);
                PushResult result = await _orders.PushAsync(10);
                Task<PushResult> pending = _orders.PushAsync(11).AsTask();
                return result == PushResult.Queued ? await _orders.PushAsync(12, end) : await pending;
            }
            public Func<PushResult> Later() => () => _orders.Push(13);
            public Func<int> More() => () => _orders.PushFrom([14]);
            public void None() => _ = _orders.Push(15);
            """, "public sealed class Batch { public int PushFrom(ReadOnlySpan<int> values) => values.Length; }"));

    private static Task<string[]> Message(string type) => AnalyzedManager.Report(
        $"partial void Declare() => Subscribe<{type}>(\"x\"); protected override void ExecuteUnitOfWork() {{ }}",
        Types);

    private static Task<string[]> Queue(string type) => AnalyzedManager.Report(
        $"partial void Declare() => Receive<{type}>(\"x\"); protected override void ExecuteUnitOfWork() {{ }}",
        Types);
}
