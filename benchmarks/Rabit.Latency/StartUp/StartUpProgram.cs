using System;
using Rabit.Core;

namespace Rabit.Latency.StartUp;

/// <summary>
/// What the runner does as a child process: nothing, or the first unit of work of two managers. Nothing else of the
/// runner is touched before it, so that the two processes differ by Rabit alone.
/// </summary>
internal static class StartUpProgram
{
    public const string Empty = "start-up-empty";
    public const string TwoManagers = "start-up-two-managers";

    public static bool IsAsked(string[] arguments)
        => arguments.Length == 1 && arguments[0] is Empty or TwoManagers;

    /// <returns>The exit code.</returns>
    public static int Run(string program) => program == Empty ? 0 : RunManagers();

    // As a user writes it, with the default options.
    private static int RunManagers()
    {
        var reactor = new RabitReactor { new Sender(), new Receiver() };
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

        public Receiver()
            : base("receiver")
        {
            _reading = Subscribe<Reading>("reading", wakeOnPost: true);
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        protected override void ExecuteUnitOfWork()
        {
            if (_reading.Fetch())
                StopSystem("the first value was received");
        }
    }
}
