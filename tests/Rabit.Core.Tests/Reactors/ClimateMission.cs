using System;
using System.IO;
using System.Text;
using Rabit.Core.Tests.Contracts;

namespace Rabit.Core.Tests.Reactors;

/// <summary>A fifth of a second of three managers, with one of everything that the event log records.</summary>
internal static class ClimateMission
{
    public static string EventLogOf(long seed)
    {
        using var log = new StringWriter(new StringBuilder());
        var time = new VirtualTime(seed) { EventLog = log };
        time.SetUnitOfWorkDuration("heater", TimeSpan.FromMilliseconds(1), TimeSpan.FromMilliseconds(30));
        var reactor = new RabitReactor(new ReactorOptions { Time = time, StopsOnSignals = false })
        {
            new Thermometer(),
            new Heater(),
            new Logger()
        };
        QueueSender<double> outside = reactor.Workspace.Send<double>("readings");
        reactor.Start();
        reactor.RunFor(TimeSpan.FromMilliseconds(100));
        outside.Push(-1);
        reactor.RunFor(TimeSpan.FromMilliseconds(100));
        reactor.Stop("the test is over");
        reactor.Finish();
        return log.ToString();
    }

    private sealed class Thermometer : RabitManager
    {
        private readonly MessagePublisher<double> _cabin;
        private readonly QueueSender<double> _readings;

        public Thermometer()
            : base("thermometer")
        {
            _cabin = Publish("cabin", 21.0);
            _readings = Send<double>("readings");
            Period = TimeSpan.FromMilliseconds(20);
        }

        protected override void ExecuteUnitOfWork()
        {
            _cabin.Value -= 0.3;
            _cabin.PostStamped(Now - TimeSpan.FromMilliseconds(1));
            _readings.Push(_cabin.Value);
        }
    }

    private sealed class Heater : RabitManager
    {
        private readonly MessageSubscriber<double> _cabin;
        private readonly MessagePublisher<bool> _heater;
        private int _runs;

        public Heater()
            : base("heater")
        {
            _cabin = Subscribe<double>("cabin", wakeOnPost: true);
            _heater = Publish<bool>("heater");
            WakeUpDelay = TimeSpan.FromMilliseconds(50);
            FaultPolicy = FaultPolicy.CarryOn;
        }

        protected override void ExecuteUnitOfWork()
        {
            if (++_runs == 4)
                throw new InvalidOperationException("the relay sticks\nand smokes");
            if (!_cabin.Fetch())
                return;
            _heater.Value = _cabin.Value < 20;
            _heater.Post();
        }
    }

    private sealed class Logger : RabitManager
    {
        private readonly QueueReceiver<double> _readings;
        private readonly BlockingReader<int> _gauge;

        public Logger()
            : base("logger")
        {
            _readings = Receive<double>("readings", 3, QueueFullMode.DropOldest, wakeOnPush: false);
            _gauge = AttachReader(
                "gauge", new ScriptedSource(new TestBoard(), TimeSpan.FromMilliseconds(70), 1, 2), capacity: 1);
            Period = TimeSpan.FromMilliseconds(80);
        }

        protected override void ExecuteUnitOfWork()
        {
            while (_gauge.TryPop(out int value))
                Log("the gauge says " + (char)('0' + value));
            while (_readings.TryPop(out _))
            {
            }
        }
    }
}
