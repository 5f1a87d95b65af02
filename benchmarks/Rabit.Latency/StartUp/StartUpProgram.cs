using System;
using Rabit.Core;

namespace Rabit.Latency.StartUp;

/// <summary>
/// What the runner does as a child process: nothing, or two managers to the first value that one receives of the other,
/// or to the end of their run after it. Nothing else of the runner is touched before it, so that the processes differ
/// by Rabit alone.
/// </summary>
internal static class StartUpProgram
{
    public const string Empty = "start-up-empty";
    public const string ToFirstValue = "start-up-to-first-value";
    public const string WholeRun = "start-up-whole-run";

    public static bool IsAsked(string[] arguments)
        => arguments.Length == 1 && arguments[0] is Empty or ToFirstValue or WholeRun;

    /// <returns>The exit code.</returns>
    public static int Run(string program) => program == Empty ? 0 : RunManagers(program == ToFirstValue);

    // As a user writes it, with the default options.
    private static int RunManagers(bool exitsAtFirstValue)
    {
        var reactor = new RabitReactor { new Sender(), new Receiver(exitsAtFirstValue) };
        return reactor.RunAsync().GetAwaiter().GetResult().ExitCode;
    }

    private struct Reading
    {
        public double Celsius { get; set; }
    }

    private sealed class Sender : RabitManager
    {
        private readonly MessagePublisher<Reading> _reading;

        public Sender()
            : base("sender")
        {
            _reading = Publish<Reading>("reading");
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        protected override void ExecuteUnitOfWork()
        {
            _reading.Value.Celsius = 21;
            _reading.Post();
        }
    }

    private sealed class Receiver : RabitManager
    {
        private readonly MessageSubscriber<Reading> _reading;
        private readonly bool _exitsAtFirstValue;

        public Receiver(bool exitsAtFirstValue)
            : base("receiver")
        {
            _exitsAtFirstValue = exitsAtFirstValue;
            _reading = Subscribe<Reading>("reading", wakeOnPost: true);
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        protected override void ExecuteUnitOfWork()
        {
            if (!_reading.Fetch())
                return;
            if (_exitsAtFirstValue)
                Environment.Exit(0);
            StopSystem("the first value was received");
        }
    }
}
