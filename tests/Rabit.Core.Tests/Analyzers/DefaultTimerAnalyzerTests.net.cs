using System.Threading.Tasks;
using Xunit;

namespace Rabit.Core.Tests.Analyzers;

/// <summary>RABIT0009: managers that only the default timer wakes.</summary>
public sealed class DefaultTimerAnalyzerTests
{
    [Theory]
    [InlineData("Subscribe<int>(\"x\");")]
    [InlineData("Subscribe<int>(\"x\", wakeOnPost: false);")]
    [InlineData("Send<int>(\"x\"); Publish<int>(\"y\");")]
    [InlineData("Publish<int>(\"y\"); TimeSpan now = WakeUpDelay;")]
    public async Task Rabit0009_NothingWakesIt_IsFound(string declarations)
        => Assert.Equal(["RABIT0009 at Pilot"], await Report(declarations));

    [Theory]
    [InlineData("Subscribe<int>(\"x\", wakeOnPost: true);")]
    [InlineData("Subscribe<int>(\"x\", _wakes);")]
    [InlineData("SubscribeToStatus(\"x\", wakeOnPost: true);")]
    [InlineData("Subscribe<int>(\"x\"); Receive<int>(\"y\");")]
    [InlineData("Send<int>(\"x\", wakeOnPop: true);")]
    [InlineData("Subscribe<int>(\"x\"); Period = TimeSpan.FromMilliseconds(20);")]
    [InlineData("Subscribe<int>(\"x\"); WakeUpDelay = Timeout.InfiniteTimeSpan;")]
    [InlineData("Subscribe<int>(\"x\"); Wire(this);")]
    [InlineData("Subscribe<int>(\"x\"); Changed += WakeUp;")]
    [InlineData("Subscribe<int>(\"x\"); Changed += () => WakeUp();")]
    [InlineData("")]
    public async Task Rabit0009_SomethingWakesItOrItHasNoEnds_IsNotFound(string declarations)
        => Assert.Empty(await Report(declarations));

    [Fact]
    public async Task Rabit0009_BaseClassBetween_IsNotFound()
        => Assert.Empty(await AnalyzedManager.ReportOf("""
            using Rabit.Core;
            public abstract class Base(string name) : RabitManager(name);
            public sealed class Pilot : Base
            {
                public Pilot() : base("pilot") => Subscribe<int>("x");
                protected override void ExecuteUnitOfWork() { }
            }
            """));

    private static Task<string[]> Report(string declarations) => AnalyzedManager.Report(
        $$"""
        private readonly bool _wakes = true;
        private static void Wire(RabitManager manager) { }
        public event Action? Changed;
        public void Change() => Changed?.Invoke();
        partial void Declare()
        {
            {{declarations}}
        }
        protected override void ExecuteUnitOfWork() => _ = _wakes;
        """,
        setsTimer: false);
}
