using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Links;
using Rabit.Uav.Simulation;

namespace PackCheck
{
    /// <summary>A user's program: a little of each package. It prints the same on every runtime, or fails.</summary>
    internal static class Program
    {
        private static int Main()
        {
            RunManagers();
            PassOn(
                new Heartbeat
                {
                    Type = MavType.Quadrotor,
                    Autopilot = MavAutopilot.Px4,
                    CustomMode = 7,
                    MavlinkVersion = 3
                },
                MavlinkDialect.All);
            OwnDialect.Check();
            Console.WriteLine("Rabit.Uav: {0}", LinkUrl.Parse("UDPIN:0.0.0.0:14550"));
            Fly();
            return 0;
        }

        private static void RunManagers()
        {
            var counter = new Counter();
            var reactor = new RabitReactor(new VirtualTime()) { counter, new Watcher() };
            ReactorResult result = reactor.Run();
            Console.WriteLine("Rabit.Core: {0}, exit code {1}", result.StopReason, result.ExitCode);
        }

        /// <summary>A second of the simulated vehicle, in virtual time, without an autopilot's commands.</summary>
        private static void Fly()
        {
            var world = new SimulatedWorld(new SimulationOptions { Seed = 3 });
            var ends = new MemoryLinkPair("air");
            var reactor = new RabitReactor(new VirtualTime()) { world.CreateVehicle(ends.A) };
            reactor.Start();
            reactor.RunFor(TimeSpan.FromSeconds(1));
            reactor.Stop();
            Console.WriteLine(
                "Rabit.Uav.Simulation: exit code {0}, {1} m flown", reactor.Finish().ExitCode, world.Truth.FlownMetres);
        }

        /// <summary>Message to frame to bytes to frame to message.</summary>
        internal static MavlinkFrame PassOn<T>(T sent, MavlinkDialect dialect)
            where T : struct, IMavlinkMessage
        {
            MavlinkFrame frame = MavlinkFrame.Create(sent, systemId: 1, componentId: 191, sequence: 0);
            var wire = new byte[frame.WireLength];
            frame.WriteTo(wire);

            var reader = new MavlinkFrameReader(dialect);
            ReadOnlySpan<byte> bytes = wire;
            MavlinkFrameInfo info;
            T received;
            if (!reader.TryRead(ref bytes, out frame, out info) || !info.IsChecked || !frame.TryDecode(out received)
                || !received.Equals(sent))
                throw new InvalidOperationException(typeof(T).Name + " did not come back as it was sent.");
            Console.WriteLine("Rabit.Mavlink: {0}, {1} bytes", typeof(T).Name, wire.Length);
            return frame;
        }
    }

    internal struct Count
    {
        public int Value;
    }

    internal sealed class Counter : RabitManager
    {
        private readonly MessagePublisher<Count> _count;

        public Counter()
            : base("counter")
        {
            _count = Publish<Count>("count");
            WakeUpDelay = TimeSpan.FromMilliseconds(100);
        }

        protected override void ExecuteUnitOfWork()
        {
            _count.Value.Value++;
            _count.Post();
        }
    }

    internal sealed class Watcher : RabitManager
    {
        private readonly MessageSubscriber<Count> _count;

        public Watcher()
            : base("watcher")
        {
            _count = Subscribe<Count>("count", wakeOnPost: true);
        }

        protected override void ExecuteUnitOfWork()
        {
            if (_count.Fetch() && _count.Value.Value == 10)
                StopSystem("counted to 10");
        }
    }
}
